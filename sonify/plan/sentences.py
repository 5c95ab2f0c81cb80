"""Sentences of a plan on its models, omissions and reasons."""

from dynamics import Outcome

INTEGRATOR_REASONS = {
    "taylor": "the order of the Taylor series grows with the number of digits: full double "
    "precision costs only a third more than half the digits, and late slips amplify errors",
    "dop853": "each additional digit requires a third more steps, and late slips amplify errors",
}
"""Reason for the tolerance of the motion, by integrator."""
DENSE_SAMPLING = (
    "every sample, and more often where the contact turns too fast for the sample rate"
)
SPARSE_SAMPLING = (
    "every {stride}th sample where the contact turns by less than {turn:g} rad in between and the "
    f"force does not jump, otherwise {DENSE_SAMPLING}"
)
SAMPLING_REASON = (
    "the solution is smooth between its jumps, and their times are known exactly"
)
RADIATION_CHOICE = "by the upper face in a baffle, at the frequency of each mode"
RADIATION_REASON = "the disk is not small compared with the wavelengths of its modes"
MEASURED_DECAY_REASON = "the scene gives material.decay_rates"
LOSS_FACTOR_REASON = (
    "the air dissipates up to a third as much energy of a mode as the material"
)
SOLVER_REASONS = {
    "patch": "support.kind = 'patch': the stress is singular at the edge of the patch, and the "
    "mesh follows this edge",
    "free": "support.kind = 'free': the disk is axisymmetric, and its mode shapes have no "
    "singularity",
    "contact": "support.kind = 'contact': a few springs couple the modes of the free disk, which "
    "are the same at every inclination",
}
"""Reason for the solver of the modes, by kind of support."""
SUPPORT_COMPARISON_REASON = (
    "on its contact the disk also oscillates as a rigid body, as for the patch in the paper, but on "
    "springs that stiffen as it falls; the other modes are almost those of the free disk"
)

SUPPORT_MODELLED = {
    "patch": "The elastic modes are those of the disk held at a patch of its rim that travels with "
    "the contact; the contact force drives them through the rigid acceleration that it causes.",
    "free": "The elastic modes are those of the free disk; the contact force drives them at the "
    "contact.",
    "contact": "The elastic modes are those of the disk on its contact springs under its own "
    "weight, at one inclination; the force that keeps the contact point at rest drives them. If "
    "the contact is elastic, the vibration of the rigid disk on it is rendered as a separate stem, "
    "and only the higher modes are rendered as modes.",
}
RADIATION_MODELLED = (
    "The upper face radiates into the half space above the table (Rayleigh's integral, with the "
    "table as baffle): heave and tilt of the rigid disk, and each elastic mode at its own "
    "frequency.",
    "The listener is fixed and hears the source after the travel time of sound.",
)
RIGID_DISK_MODELLED = "A rigid disk rolls and slides on a rigid plane."
DISK_COUPLED_LATER_MODELLED = (
    "A rigid disk rolls and slides on a rigid plane until two-way coupling with the table begins; "
    "from then on the contact is elastic, at the point of smallest gap between the rim and the "
    "deflected table."
)
DISK_MODES_COUPLED_MODELLED = "The elastic modes of the disk below 20 kHz take part in two-way coupling with the table."
RIGID_UNTIL_TWO_WAY = "rigid, until two-way coupling with the table begins"
COUPLED_DISK_REASON = (
    "the contact is elastic from then on, so that disk and table deform each other"
)
RIGID_DISK_REASON = (
    "surface.kind = {kind!r}; the elastic modes of the disk do not affect the motion"
)
CONTACT_MODELLED = {
    "rigid": (),
    "filter": (
        "The edge and the table are elastic (Hertz, Mindlin, Kalker): a linear filter, applied to "
        "the rigid motion, adds the force excited by height variations and force jumps.",
    ),
    "full": (
        "The edge and the table are elastic (Hertz, Mindlin, Kalker): the disk moves on this "
        "contact, with creep, slip and losses of contact. The contact stem is the sound "
        "above half the first contact resonance.",
    ),
    "many": (
        "The disk touches the uneven table anywhere on its rim, possibly at several places at once, "
        "and is airborne in between. Each contact is a Hertzian spring with a dashpot, friction "
        "and creep; the heights of table and edge are combined in one profile of the rim. The free "
        "modes of the disk move the rim.",
    ),
}
RATTLING_FILM_MODELLED = (
    "The air film is modelled as under a disk in contact, which is valid while hops are low "
    "compared with the mean gap. It is not valid in the final part of the motion, in which the "
    "rim rises by less than ten times the heights of the table."
)
RATTLING_FILM_NEGLECTED = (
    "The effect of the film on the modes of the disk before the end; the sound that heave and tilt "
    "of the rigid disk generate by squeezing the film."
)
FILTER_ERROR_REASON = (
    "its vibration is within 10 % of the full model for rolling, and up to 1.9 times too weak for "
    "sliding"
)
ROUGHNESS_LOSS_MODELLED = {
    "own": "Roughness dissipates energy in addition to the friction of the scene (roughness.loss = "
    "'own').",
    "fitted": "The friction of the scene was measured on a surface with this roughness and already "
    "includes the loss to it (roughness.loss = 'fitted').",
}
BENDING_SENTENCE = (
    "The disk bends at its contact, in series with the contact springs; this lowers the resonance "
    "by {first:.1%} at the release and by {late:.1%} at {inclination:.2g} rad."
)
HEIGHT_SOUND_MODELLED = (
    "The disk vibrating on its contact radiates at its actual height above the film, including the "
    "flow out of the film. The error, relative to a coupled solution of film and outer air, is "
    "0.5 dB for a uniform gap. For an inclined disk with a thickness of 0.1 to 0.8 radii it is 2 dB "
    "up to 0.35 rad and k R = 4 (5.8 kHz for a disk of 75 mm). At 0.6 rad it is -4 to +6 dB, and "
    "positive above k R = 2; from k R = 4 to 5 a thick disk is up to 5 dB too quiet. Above k R = 6 "
    "the value at 6 is used."
)
"""Errors of the mean-square pressure around the disk, which
tests/sound/test_open_film_sound.py checks."""
FILM_MODELLED = (
    "The air film between disk and table (Reynolds' equation for a wedge) slows the precession, "
    "damps the fall, and carries part of the weight; friction acts on the remaining contact force.",
    "Heave and tilt of the rigid disk radiate above the film. While the film is open, the air "
    "displaced by the face leaves at the rim and cancels part of its sound. The second harmonic of "
    "this flow is 17 dB below tilt over an open film, and stronger over a half-closed film. Above a "
    "closed film only the upper face radiates. The film damps and detunes the modes and weakens "
    "their radiation; the inertia of its air and heat conduction to both faces are included.",
)
HOLE_MODELLED = (
    "The air below the disk escapes at its rim and into a hole of {hole:g} m in the table, which stays "
    "under the centre of the disk; the film is that of the ring between them."
)
RING_MODELLED = (
    "The air below the ring escapes at its rim and into its hole of {hole:g} m, where the pressure is "
    "that of the room."
)
RING_NEGLECTED = (
    "The effect of the film on the sound of the ring: on the radiation and damping of its modes and on "
    "the air expelled from the gap."
)
HOLE_NEGLECTED = (
    "The hole changes neither the modes of the table nor the damping of the modes of the disk by the "
    "film, nor the sound of the expelled air."
)
WAVY_TABLE_MODELLED = (
    "The table is wavy along the contact circle, which moves with the disk; the contact is at the "
    "smallest gap between rim and waves."
)
MODAL_TABLE_MODELLED = (
    "The contact force drives the modes of the table at the moving contact.",
    "The top face of the table, including the part under the disk, radiates (Rayleigh's integral, "
    "below and above coincidence); without a baffle, air flows around its edge.",
)
TABLE_MODELLED = {
    "plate": ("The table is a round elastic plate.", *MODAL_TABLE_MODELLED),
    "mesh": ("The table is an elastic solid.", *MODAL_TABLE_MODELLED),
    "modes": (
        "The table is described by its modes along the contact circle, which moves with the disk; "
        "only this circle is known, and only it radiates.",
        *MODAL_TABLE_MODELLED,
    ),
}
INFINITE_TABLE_MODELLED = (
    "The table is an infinite plate driven at the contact. Its far field has a closed form; its "
    "bending waves arrive later than the airborne sound."
)
TABLE_MODES_REASON = (
    "the others are more than {range_db:g} dB(A) below the loudest mode at the listener and have "
    "less than {energy:.0%} of the energy"
)
MOTION_USES_ALL_MODES_CLAUSE = "; the motion uses all modes"
ALL_MODES_SOUND_REASON = "all modes are audible"
TABLE_SOUNDS_ONLY = "radiates sound without affecting the motion"
TABLE_YIELDS_AND_SOUNDS = (
    "yields to the vibration of the rough contact and radiates sound"
)
ROUGH_TABLE_MODELLED = (
    "The table yields to the vibration of the rough contact: the linear filter contains the "
    "receptance of all its modes at the moving contact (two-way coupling of the vibration). One-way "
    "coupling would change the A-weighted level of the table by {level:+.1f} dB."
)
ROUGH_HAND_OVER_MODELLED = (
    "Below an inclination of {inclination:.2g} rad, time steps with all modes of the table continue "
    "the motion on the rough contact. At the hand-over, the modes are at rest under the weight; their "
    "vibration rises within their decay times, while that of the linear filter fades."
)
ROUGH_TABLE_NEGLECTED = (
    "Friction on the yielding table, and the damping of its modes by their own sound."
)
FILM_REACTION_NEGLECTED = (
    "The reaction of the air between the faces on the vibration of disk and table; it would change "
    "the A-weighted level of the table by at most {change:.1f} dB."
)
LINEAR_TABLE_LIMIT = (
    "The limit of the linear filter, which is also used below an inclination of "
    "{inclination:.2g} rad although {limit}."
)
TABLE_YIELDS_THEN_MOVES = (
    "yields to the vibration of the rough contact, radiates sound, and moves with the disk below an "
    "inclination of {inclination:.2g} rad"
)
TABLE_MOVES_AND_SOUNDS = "moves with the disk and radiates sound"
TABLE_MOVES_BELOW_INCLINATION = "radiates sound, and moves with the disk below an inclination of {inclination:.2g} rad"
FROM_RELEASE_CLAUSE = "; a rattling disk is coupled from the release"
TABLE_SLOPE_NEGLECTED = (
    "The slope of the deflected table (contact forces remain vertical) and waves above its highest "
    "mode. Its sound is computed with the whole force at the lowest point of the rim."
)
ON_ELASTIC_CONTACT_CLAUSE = ", on an elastic contact"
MOTION_ACTION_REASON = (
    "surface.action = 'motion': the rim touches the deflected table, and the contact force drives "
    "its modes"
)
INFINITE_ACTION_REASON = (
    "surface.action = {action!r}: only a table with modes can be coupled to the motion"
)
FILM_LIFTS_DISK = (
    "the film lifts the disk at an inclination of {inclination:.2g} rad, at {turns:.3g} turns per "
    "second"
)
HEIGHTS_PREVENT_LIFT_OFF = (
    "the film cannot lift the disk: asperities or waves of {height:.3g} um hold it open; the limit is "
    "{limit:.2g} um"
)
WAVES_BREAK_CONTACT_FIRST = (
    "waves break the contact at {inclination:.2g} rad, before the film lifts the disk at "
    "{lower:.2g} rad"
)
LIFT_OFF_OF_PLANE_FILM = (
    "prediction for a film above a plane that alone resists the motion; contour friction raises the "
    "inclination by up to 12 %"
)
LIFT_OFF_FROM_BOWL = (
    "prediction for a film above a concave table that alone resists the motion; it is 4 % too high if "
    "the table lowers it by a quarter, and 30 % if by two thirds"
)
LIFT_OFF_FROM_WAVES = "prediction for a film above a plane, which is not valid over waves that are as high as its gap"
FILM_ACTS_CHOICE = "acts on the motion and on the sound"
FILM_OMITTED_CHOICE = "does not act"
ABSORPTION_SENTENCE = (
    "Absorption: over {distance:g} m, air of 50 % humidity absorbs {at_8_khz:.2g} dB at 8 kHz and "
    "{at_20_khz:.2g} dB at 20 kHz"
)
HEAD_MODELLED = (
    "Ears: a head is a rigid sphere of radius {radius:g} m. Its scattering of the sound of a point "
    "source at the disk is solved exactly at both ears."
)
HEAD_NEGLECTED = "Reflections between head and table, and the extent of the source as seen from the head."
NEAR_MODELLED = (
    "The near field of the disk at {distance:g} m: Rayleigh's integral over the upper face and along "
    "the rim."
)
NEAR_NEGLECTED = (
    "The scattering by the edge of the disk at {distance:g} m: below k R = 2 it changes the pressure by "
    "up to 4 dB for a disk with a thickness of a third of its radius, and by 1 dB for a thin one. The disk radiates as "
    "if it lay flat at its initial position."
)
NEAR_TABLE_NEGLECTED = (
    "The near field of the table at {distance:g} m: the sound of an infinite plate, and the flow "
    "around the edge of a plate without a baffle, are those of a distant listener."
)

ALWAYS_NEGLECTED = (
    "Excitation of the modes by resisting moments and centrifugal loads.",
)
MODES_ABOVE_NEGLECTED = "The sound of modes above {frequency:g} Hz."
WALL_SOUND_NEGLECTED = {
    "solid": (),
    "shell": (
        "The sound of the cylindrical wall of a hoop, driven by in-plane modes, and of the air "
        "inside the hoop: only the upper edge of the wall radiates.",
    ),
}
NEGLECTED_IN_DRAFT = (
    "The picture of the sound sources and the oblique views of the modes.",
)
MODAL_REACTION_NEGLECTED = (
    "The sound of impacts; the effect of the elastic modes on the motion."
)
EARLY_MODAL_REACTION_NEGLECTED = (
    "The sound of impacts; the effect of the elastic modes on the motion, until two-way coupling "
    "with the table begins."
)
CONTACT_NEGLECTED = {
    "rigid": ("The sound of roughness, including the contact resonance.",),
    "filter": (
        "The effect of this vibration on the motion; losses of contact; fluctuating friction "
        "while the disk slides.",
    ),
    "full": (),
    "many": (
        "The change of the combined profile while the edge slips along the table.",
    ),
}
ROUGHNESS_LOSS_NEGLECTED = (
    "The loss to roughness in addition to friction, {share:.1%} of the energy, because the motion is "
    "that of a smooth contact."
)
SHELL_BENDING_NEGLECTED = (
    "The bending of the disk at its contact, which lowers the resonance by an amount that is unknown "
    "for a shell."
)
OPEN_FILM_NEGLECTED = (
    "The open film during a loss of contact, which is modelled as a closing wedge that moves with the "
    "face at the centre of its pressure."
)
FILM_ACTION_NEGLECTED = "The effect of the film on the vibration of the disk on its contact, except for its sound."
HEIGHT_SOUND_NEGLECTED = (
    "The height of the disk in the contact stem: the disk radiates like a face in the plane of the "
    "table."
)
FILM_NEGLECTED = (
    "The effect of the sound radiated at the rim of the film on the decay of the modes: the pressure "
    "there is set to zero. Doubling the number of elements changes this decay by up to 5 %.",
    "Memory effects of the film, and direct excitation of the modes by the film pressure.",
    "The inertia of the air in the second harmonic at the rim (3 dB at S = 3), and higher harmonics, "
    "which are 50 dB lower.",
    "The variation of a mode's radiation above the film with phase and azimuth; means are used. "
    "Modes above k R = 1.5 (2.2 kHz for a disk of 75 mm) radiate as they do above a closed film, "
    "which only damps and detunes them.",
    "The imperfect baffling by the disk at steep inclinations: the error of the film sound is "
    "several dB above 0.3 rad. At smaller inclinations the heave of the rigid disk is accurate within "
    "4 dB up to k R = 2.6, and its tilt within 1.5 dB at low frequency, without its resonance with the "
    "film at k R = 3.2.",
)
VACUUM_NEGLECTED = (
    "The air under the disk: it would slow and lift the disk, and flow around the rim while the film "
    "is open, so that the pressure of heave and tilt is overestimated until late in the motion.",
)
AIR_COUNTED_TWICE = "Double counting of the air: the scene has a published law of air drag in addition to the film."
NO_ERROR_PREDICTION_WITH_TABLE = (
    "A prediction of the error of the table's sound samples relative to a finer run."
)
RIGID_TABLE_NEGLECTED = "The sound of the table, which is assumed rigid."
TABLE_NEGLECTED = (
    "The effect of the table on the motion through its absorbed energy and its deflection.",
    "Excitation of the table by friction, the sound of its other faces, its damping by the air, and "
    "acoustic shadowing by the disk.",
)
NEAR_LISTENER_NEGLECTED = (
    "Level changes for a listener near the contact: the varying distance affects only the arrival "
    "time."
)
MOTION_EVENT = (
    "At t = {t:.6g} s: {kind}, at {speed:.3g} mm/s and with {energy:.2g} J, {share:.2%} of "
    "the initial energy."
)
NEGLECTED_AFTER_END = {
    Outcome.FELL: "The final impact of the face on the table and the ringing that it excites.",
    Outcome.AIRBORNE: "The sound of the landing: the disk falls on its film of air. The modes decay above "
    "the film at the loss of contact; in reality the film closes as the disk settles, which changes "
    "their damping.",
}
NEGLECTED_LANDING = (
    "As the disk lands: inertia, compression and rarefaction of the air, motion of the table, and "
    "the effect of the modes on the impacts."
)
"""Omitted events after the motion, by outcome."""
RAREFACTION_LIMITS = (
    (
        60,
        "slip at the walls increases the flow by a tenth or more, which the film law describes within "
        "10 %",
    ),
    (
        10,
        "by kinetic theory (Fukui & Kaneko 1990), the flow is 9 % greater than with slip alone, "
        "and even more at smaller gaps",
    ),
    (
        1,
        "the film is no longer a continuum: the flow is 1.5 times as great, and the film law gives "
        "only the order of magnitude",
    ),
)
"""Pairs of a ratio of mean gap to mean free path and the error of the film law below
this ratio."""
FILM_LIMITS = (
    "The fit of the inertia of the air in the film is accurate to 5 % below S = 3; here S ranges from "
    "{first:.2g} to {last:.2g}. The air is isothermal, and the fit of its compression is accurate to "
    "5 % below Lam = 12 mu Omega/(p beta^2) = 100; at the end Lam is {squeezed:.2g}. The pressure is "
    "quasi-steady: at the end the disk falls {closing:.2g} times as fast as the film can drain; at a "
    "ratio of 1 the resistance of the film is 12 % too low."
)
RAREFIED_AIR_FROM_TIME = (
    "From t = {time:.6g} s on, the mean gap is less than {ratio:g} mean free paths of the air, "
    "{path:.2g} m: {error}."
)
RAREFIED_MOTION_NOT_SOLVED = (
    "The motion below {inclination:.2g} rad, at a mean gap of {gap:.2g} m: the mean free path of the "
    "air is {knudsen:g} times as long, and the slip law underestimates the flow by a factor of 3.4."
)
PLATE_STRETCHING_NEGLECTED = (
    "The stretching of the plate: the weight of the disk alone would deflect it by {deflection:.3g} mm "
    "at a thickness of {thickness:.3g} mm, and linear theory does not apply."
)

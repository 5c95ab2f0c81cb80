"""FACTS -> SENTENCES: what a plan says about its model, its omissions and their reasons."""

from dynamics import Outcome

INTEGRATOR_REASONS = {
    "taylor": "the order of the Taylor series grows with the number of digits: full double "
    "precision costs a third more than half of it, and late slips amplify errors",
    "dop853": "each further digit costs a third more steps, and late slips amplify errors",
}
"""Integrator -> reason for the tolerance of the motion."""
DENSE_SAMPLING = "every sample, and more often where the contact turns too fast for the samples"
SPARSE_SAMPLING = (
    "every {stride}th sample where the contact turns by less than {turn:g} rad in between and the "
    f"force does not jump, otherwise {DENSE_SAMPLING}"
)
SAMPLING_REASON = "the solution is smooth between its jumps, whose times are known exactly"
RADIATION_CHOICE = "the upper face in a baffle, at the frequency of each mode"
RADIATION_REASON = "the disk is not small compared with the wavelengths of its modes"
MEASURED_DECAY_REASON = "material.decay_rates"
LOSS_FACTOR_REASON = "some modes lose a third as much energy to the air as to the material"
SOLVER_REASONS = {
    "patch": "support.kind = 'patch': the stress is singular at the edge of the patch, and the "
    "mesh follows this edge",
    "free": "support.kind = 'free': the disk is axisymmetric, and its shapes have no singularity",
    "contact": "support.kind = 'contact': a few springs couple the modes of the free disk, for any "
    "inclination at once",
}
"""Kind of support -> reason for the solver of the modes."""
SUPPORT_COMPARISON_REASON = (
    "on its contact a disk swings as a whole, as on the paper's patch, but on springs that stiffen "
    "as it falls; its other modes hardly differ from those of the free disk"
)

SUPPORT_MODELLED = {
    "patch": "The elastic modes are those of the disk held at a patch of its rim that travels with "
    "the contact; the contact force drives them through the rigid acceleration that it causes.",
    "free": "The elastic modes are those of the free disk; the contact force drives them at the "
    "contact.",
    "contact": "The elastic modes are those of the disk on the springs of its contact under its "
    "weight, at one inclination; the force that keeps the contact point at rest drives them. Where "
    "the contact is elastic, the vibration of the rigid disk on it is a separate stem, and only "
    "the higher modes sound as modes.",
}
RADIATION_MODELLED = (
    "The upper face radiates into the half space above the table (Rayleigh's integral, with the "
    "table as baffle): heave and tilt of the rigid disk, and each elastic mode at its own "
    "frequency.",
    "The listener stays at one place and hears the source after the travel time of sound.",
)
RIGID_DISK_MODELLED = "A rigid disk rolls and slides on a rigid plane."
DISK_COUPLED_LATER_MODELLED = (
    "A rigid disk rolls and slides on a rigid plane until two-way coupling with the table begins; "
    "from then on its contact is elastic and lies at the smallest gap between the rim and the "
    "deflected table."
)
DISK_MODES_COUPLED_MODELLED = " The elastic modes of the disk below 20 kHz are coupled as well."
UNTIL_TWO_WAY_CLAUSE = ", until two-way coupling with the table begins"
RIGID_DISK_REASON = "surface.kind = {kind!r}; the elastic modes of the disk only sound"
CONTACT_MODELLED = {
    "rigid": (),
    "filter": (
        "The edge and the table are elastic (Hertz, Mindlin, Kalker): along the rigid motion, a "
        "linear filter adds the force that height variations and force jumps excite.",
    ),
    "full": (
        "The edge and the table are elastic (Hertz, Mindlin, Kalker): the disk moves on this "
        "contact, with creep, slip and losses of contact. The sound above half of the first "
        "contact resonance is the stem of the contact.",
    ),
    "many": (
        "The disk touches the uneven table anywhere on its rim, at several places at once, and "
        "flies in between. Each contact is a spring (Hertz) with a dashpot, friction and creep; "
        "heights of table and edge act as one profile of the rim. The free modes of the disk move "
        "the rim.",
    ),
}
RATTLING_FILM_MODELLED = (
    "The air film acts as under a disk on its contact, which holds while hops are low compared "
    "with the mean gap: the last stretch, where the rim is raised by less than ten times the "
    "heights of the table, is outside its law."
)
RATTLING_FILM_NEGLECTED = (
    "The action of the film on the modes of the disk before the end; the sound that heave and tilt "
    "of the rigid disk press out of the film."
)
FILTER_ERROR = "its level is within 10 % of the full model for rolling, and up to 1.9 times too low for sliding"
ROUGHNESS_LOSS_MODELLED = {
    "own": "Roughness dissipates energy in addition to the friction of the scene (roughness.loss = "
    "'own').",
    "fitted": "The friction of the scene was measured on such a surface and includes the loss to "
    "roughness, which is therefore counted once (roughness.loss = 'fitted').",
}
BENDING = (
    "The disk bends at its contact, in series with the contact springs; this lowers the resonance "
    "by {first:.1%} at the release and by {late:.1%} at {inclination:.2g} rad."
)
HEIGHT_SOUND_MODELLED = (
    "The disk that vibrates on its contact radiates at its actual height above the film, including "
    "the flow out of the film: within 0.5 dB of a coupled solution of film and outer air for an "
    "even gap; for an inclined disk 0.1 to 0.8 radii thick within 2 dB up to 0.35 rad and k R = 4 "
    "(5.8 kHz for a disk of 75 mm); at 0.6 rad the error is -4 to +6 dB, too loud above k R = 2; "
    "from k R = 4 to 5 a thick disk is up to 5 dB too quiet. Above k R = 6 the value at 6 is used."
)
"""tests/sound/test_open_film_sound.py checks the numbers, in mean square around the disk."""
FILM_MODELLED = (
    "The air film between disk and table (Reynolds' equation for a wedge) slows the precession, "
    "damps the fall, and carries part of the weight; friction acts on the remaining contact force.",
    "Heave and tilt of the rigid disk radiate through the film. While it is open, its rim returns "
    "the flow of the face, and its second harmonic is 17 dB below an open tilt, more where the "
    "film is half closed; once it is closed, the face alone radiates. The film damps, detunes and "
    "muffles the modes; its air has inertia and exchanges heat with both faces.",
)
WAVY_TABLE_MODELLED = (
    "The table is wavy along the circle of the contact, which moves with the disk; the contact "
    "lies at the smallest gap between rim and waves."
)
MODAL_TABLE_MODELLED = (
    "The contact force acts on the table at the moving contact and drives its modes.",
    "The top face of the table, including the part under the disk, radiates into the half space "
    "above it as in a baffle (Rayleigh's integral, below and above coincidence).",
)
TABLE_MODELLED = {
    "plate": ("The table is a round elastic plate.", *MODAL_TABLE_MODELLED),
    "mesh": ("The table is an elastic solid.", *MODAL_TABLE_MODELLED),
    "modes": (
        "The table is given by its modes along the contact circle, which moves with the disk; only "
        "this circle is known, and only it radiates.",
        *MODAL_TABLE_MODELLED,
    ),
}
INFINITE_TABLE_MODELLED = (
    "The table is an infinite plate driven at the contact; its far field is known in closed form, "
    "and its bending waves arrive after the sound through the air."
)
TABLE_MODES_REASON = (
    "the others are more than {range_db:g} dB(A) below the loudest at the listener and hold less "
    "than {energy:.0%} of the energy"
)
ALL_MODES_SOUND_REASON = "all modes sound"
TABLE_SOUNDS_ONLY = "it only sounds"
TABLE_MOVES_AND_SOUNDS = "it moves with the disk, and sounds"
TABLE_MOVES_BELOW_INCLINATION = (
    "it sounds, and moves with the disk below an inclination of {inclination:.2g} rad"
)
ON_ELASTIC_CONTACT_CLAUSE = ", on an elastic contact"
MOTION_ACTION_REASON = (
    "surface.action = 'motion': the contact lies at the smallest gap between the rim and the "
    "deflected table, and the modes respond to the force there"
)
INFINITE_ACTION_REASON = (
    "surface.action = {action!r}: only a table with modes can be coupled to the motion"
)
FILM_ACTS_CHOICE = "acts on the motion and on the sound"
FILM_OMITTED_CHOICE = "does not act"
ABSORPTION = (
    "Absorption: over {distance:g} m, air of 50 % humidity absorbs {at_8_khz:.2g} dB at 8 kHz and "
    "{at_20_khz:.2g} dB at 20 kHz"
)

ALWAYS_NEGLECTED = ("Excitation of the modes by the resisting moments and by centrifugal loads.",)
MODES_ABOVE_NEGLECTED = "The sound of modes above {frequency:g} Hz."
WALL_SOUND_NEGLECTED = {
    "solid": (),
    "shell": (
        "The sound of the cylindrical wall of a hoop, which its in-plane modes move, and of the "
        "air in its hole: only the upper edge of the wall radiates.",
    ),
}
NEGLECTED_IN_DRAFT = (
    "The psychoacoustic roughness, the picture of the causes of sound, and the oblique views of the "
    "modes.",
)
NO_MODAL_REACTION = "Sound of impacts; the reaction of the elastic modes on the motion"
CONTACT_NEGLECTED = {
    "rigid": ("Sound of roughness, and the contact resonance that it excites.",),
    "filter": (
        "The reaction of this vibration on the motion; losses of contact; fluctuating friction "
        "while the disk slides.",
    ),
    "full": (),
    "many": ("The change of the profile while the edge slips round the table.",),
}
ROUGHNESS_LOSS_NEGLECTED = (
    "The loss to roughness in addition to friction, {share:.1%} of the energy: the motion is that of "
    "a smooth contact."
)
SHELL_BENDING_NEGLECTED = (
    "Bending of the disk at its contact, which lowers the resonance; for a shell its size is "
    "unknown."
)
OPEN_FILM_NEGLECTED = (
    "The open film during a loss of contact: it acts as a closing wedge that moves with the face at "
    "the centre of its pressure."
)
FILM_ACTION_NEGLECTED = (
    "The effect of the film on the vibration of the disk on its contact, except for its sound."
)
HEIGHT_SOUND_NEGLECTED = (
    "In the stem of the contact, the height of the disk: it radiates as a face in the plane of the "
    "table."
)
FILM_NEGLECTED = (
    "In the decay of the modes due to the film, the sound radiated at its rim, where the pressure is "
    "taken as zero. Twice as many elements change this decay by up to 5 %.",
    "Memory of the film, and direct excitation of the modes by the film pressure.",
    "Inertia of the air in the second harmonic at the rim (3 dB at S = 3), and higher harmonics, "
    "50 dB lower.",
    "The phase and azimuth at which a mode radiates through the film; a mean is used. Modes above "
    "k R = 1.5 (2.2 kHz for a disk of 75 mm) radiate as above a closed film, which only damps and "
    "detunes them.",
    "The disk is no baffle at steep inclinations: above 0.3 rad the sound of the film is wrong by "
    "several dB; below, heave and tilt are within 1.5 dB of a solution of the film.",
)
VACUUM_NEGLECTED = (
    "Air under the disk: it would slow and lift the disk, and it would flow around the rim while the "
    "film is open; until late in the motion the true pressure of heave and tilt is lower.",
)
AIR_COUNTED_TWICE = (
    "The scene has a published air law in addition to the film: the same air acts twice."
)
NO_ERROR_PREDICTION_WITH_TABLE = (
    "The error of the samples of a table's sound relative to a finer run: it is not predicted."
)
RIGID_TABLE_NEGLECTED = "The sound of the table, which is rigid."
TABLE_NEGLECTED = (
    "The reaction of the table on the motion: the energy that it absorbs, and its deflection.",
    "Friction on the table, the sound of its other faces, its damping by the air, and the shadow of "
    "the disk.",
)
NEAR_LISTENER_NEGLECTED = (
    "The level for a listener near the contact: the changing distance of the contact shifts only the "
    "arrival time."
)
NEGLECTED_AFTER_END = {
    Outcome.FELL: "The impact of the face on the table that ends the fall, and the ringing that it "
    "excites.",
    Outcome.AIRBORNE: "The landing of the disk after the air has carried it. The modes ring out over "
    "the film as it was when contact was lost; as the disk settles the film closes, which changes "
    "their damping.",
}
"""Omitted events after the motion, by outcome."""
RAREFACTION_LIMITS = (
    (
        60,
        "slip at the walls lets a tenth more air through, later more, which the film's law describes "
        "within 10 %",
    ),
    (
        10,
        "by kinetic theory (Fukui & Kaneko 1990), 9 % more air passes than slip predicts, later "
        "more",
    ),
    (
        1,
        "the film is no continuum: 1.5 times as much air passes, and only the order of magnitude of "
        "its law holds",
    ),
)
"""(Mean gap over mean free path, error of the film's law below this ratio)."""
FILM_LIMITS = (
    "The inertia of the air in the film is a fit, within 5 % below S = 3; S goes from {first:.2g} to "
    "{last:.2g}. The air in the film is isothermal, and its compression is a fit to the solved film, "
    "within 5 % below Lam = 12 mu Omega/(p beta^2) = 100; at the end Lam is {squeezed:.2g}. Its "
    "pressure is quasi-steady: at the end the disk falls {closing:.2g} times as fast as the film can "
    "drain; at a ratio of 1 the film resists 12 % too little."
)
RAREFIED_AIR_FROM_TIME = (
    "From t = {time:.6g} s on the mean gap is less than {ratio:g} mean free paths of the air, "
    "{path:.2g} m: {error}."
)
RAREFIED_MOTION_NOT_SOLVED = (
    "The motion below {inclination:.2g} rad, a mean gap of {gap:.2g} m: there the mean free path of "
    "the air is {knudsen:g} times as long, and slip lets 3.4 times too little air through."
)
PLATE_STRETCHING_NEGLECTED = (
    "The stretching of the plate: the weight of the disk alone would bend it by {deflection:.3g} mm, "
    "its thickness is {thickness:.3g} mm, and linear theory does not apply."
)

"""Closed-form forces of the air film, for floats, arrays, compiled code and power series.

The air is isothermal and compressible and slips at the walls. The film is quasi-steady: it depends
on the present rates of rotation and fall. The wedge h = s (R + x), s = sin(beta), rotates at Omega
and closes at omega_1. Kn is the mean free path divided by R s. Lam is 12 mu Omega/(p s^2), divided
by the factor by which slip increases the mobility. All fits are fits to the solutions of
reynolds.py; tests/film/test_film_constants.py measures their errors.
"""

SQUEEZE_NUMBER = 0.2
"""Lam above which the air is compressed rather than displaced, in the fits to the solved film."""
SLIP_FACTOR = 12.3
"""Relative increase of the mobility of the rotating film, divided by Kn.

The increase for a falling film is half as large.
"""
BOUNDARY_LAYER_RATIO = 6.3
"""Ratio S of film to boundary layer thickness above which inertia affects the rotating film."""
SERIES_OFFSET = 1e-12
"""Added to (S/BOUNDARY_LAYER_RATIO)^4, because a broken power has no power series at zero."""


def film_forces(s, nutation, rate, *constants):
    """Return three moments of the film at sin(beta) = s.

    They are the moment against e_3, the moment against e_1 about the contact, and the lift times R.
    `nutation` and `rate` are omega_1 and Omega; the constants are those of `film_parts`.
    """
    drag, fall, lever, tip, lift = film_parts(s, rate, *constants)
    return drag, fall * nutation + tip, lever * fall * nutation + lift


def film_parts(s, rate, turning, falling, inertia, number, ambient, slip):
    """Return the parts of the moments that do not depend on omega_1.

    Parameters
    ----------
    s, rate : float
        sin(beta) and Omega.
    turning, falling : float
        12 mu R^3 times I and I_n.
    inertia : float
        (S/BOUNDARY_LAYER_RATIO)^4 over (rate s^2)^2.
    number : float
        Lam/SQUEEZE_NUMBER over rate/s^2.
    ambient : float
        p pi R^3.
    slip : float
        SLIP_FACTOR times the mean free path divided by R.

    Returns
    -------
    drag : float
        Moment against e_3.
    fall : float
        Moment about the contact per omega_1.
    lever : float
        R over the distance of the lift of a falling disk from the contact.
    tip : float
        Moment of the compressed turning air about the contact.
    lift : float
        Its lift times R.
    """
    square = s * s
    drag = rate / (square + slip * s)
    lam = number * drag
    layers = square * rate
    heavy = (1.0 + (inertia * layers * layers + SERIES_OFFSET) ** 0.625) ** 0.4
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    u2 = u * u
    share = 1.0 / (1.0 + 0.2586 * u + 0.01593 * u2 + 0.00603 * u2 * u)
    lift = (0.01846 * u + 0.01269 * u2) / (1.0 + 0.00925 * u2)
    tip = (0.00189 * u + 0.00436 * u2) / (1.0 + 0.00778 * u2)
    fall = falling / (square * (s + 0.5 * slip))
    lever = 4.0 / 3.0 + 5.0 / 12.0 * share
    return turning * drag * heavy * share, fall, lever, ambient * tip, ambient * lift


def squeezed_air_energy(s, rate, number, ambient, slip):
    """Return the energy of the compressed air of a rotating film.

    It is s p pi R^3 times the mean of h (P ln P - P + 1), with P in units of the ambient pressure
    and h
    in units of the gap at the centre. By conservation of mass, the work on the face equals the
    increase
    of this energy plus the loss int h^3 |grad p|^2/(12 mu) dA. The film therefore returns at most
    this
    energy. The constants are those of `film_parts`.
    """
    lam = number * rate / (s * s + slip * s)
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    share = u * (0.000572 + u * (0.00073 + u * 0.000276)) / (1.0 + u * u * (0.00916 + u * 0.000565))
    return ambient * s * share

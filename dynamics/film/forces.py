"""Closed-form loads of the air film for floats, arrays, compiled code and power series.

The air is isothermal and compressible, and it slips at the walls. The film is
quasi-steady: it depends only on the current rates of rotation and fall. The wedge h = s
(R + x), s = sin(beta), rotates at Omega and closes at omega_1; a concave table adds a
gap in the middle. Kn is the mean free path divided by R s. Lam is 12 mu Omega/(p s^2),
divided by the factor by which wall slip increases the mobility. All fits are fits to
the solutions of reynolds.py; tests/film/test_film_constants.py measures their errors.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dynamics.equations import NumberOrExpression
    from dynamics.film.wedge import Film

COMPRESSION_ONSET_NUMBER = 0.2
"""Compressibility number Lam above which the air is compressed rather than displaced."""
SLIP_MOBILITY_PER_KNUDSEN = 12.3
"""Relative increase of the mobility of a rotating film by wall slip, divided by Kn.

For a falling film the increase is half as large.
"""
HOLE_COEFFICIENTS = 6
"""Number of coefficients of each of the three polynomials for a table with a hole."""
NO_HOLE = (0.0,) * (3 * HOLE_COEFFICIENTS)
"""Constants of a film over a table without a hole."""


def film_forces(
    s: "NumberOrExpression",
    nutation: "NumberOrExpression",
    rate: "NumberOrExpression",
    film: "Film",
) -> "tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression]":
    """Return three dimensionless moments of the film at sin(beta) = s.

    They are the moment against e_3, the moment against e_1 about the contact, and the
    lift times R. `nutation` is omega_1 and `rate` is Omega; `film` is that of
    `film_moment_parts`.
    """
    parts = film_moment_parts(s, rate, film)
    if film[-1][0] != 0:
        parts = moment_parts_over_hole(parts, s, film)
    drag, fall, lever, tip, lift = parts
    return drag, fall * nutation + tip, lever * fall * nutation + lift


def film_moment_parts(
    s: "NumberOrExpression", rate: "NumberOrExpression", film: "Film"
) -> "tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression]":
    """Return the parts of the moments that do not depend on omega_1, without a hole.

    Parameters
    ----------
    s, rate : float
        sin(beta) and Omega.
    film : tuple
        The following constants, and those of a hole (`moment_parts_over_hole`).
    turning, falling : float
        12 mu R^3 times I and I_n.
    inertia : float
        (S/6.3)^4 divided by (rate s^2)^2, where S is the ratio of film to boundary-layer
        thickness. Above S = 6.3, inertia affects a rotating film.
    number : float
        Lam/COMPRESSION_ONSET_NUMBER without wall slip, divided by rate/s^2.
    ambient : float
        p pi R^3.
    slip : float
        SLIP_MOBILITY_PER_KNUDSEN times the mean free path divided by R.
    bowl : float
        Gap added in the middle by a concave table, divided by R; 0 on a plane.

    Returns
    -------
    drag : float
        Moment against e_3.
    fall : float
        Moment about the contact of a falling disk, divided by omega_1.
    lever : float
        R divided by the distance from the contact at which the lift on a falling disk
        acts.
    tip : float
        Moment of the compressed air of the rotating film about the contact.
    lift : float
        Lift of this air, times R.
    """
    turning, falling, inertia, number, ambient, slip, bowl, _ = film
    square = s * s
    x = 0.0
    if bowl != 0:
        # Fits for a gap that is wider in the middle, accurate to 1 % for the drag and to 4 % for
        # the resistance to a fall.
        x = bowl / s
        share = 1.0 / (1.0 + x * (2.241 + x * (1.028 + x * 0.0703)))
        turning = turning * share
        falling = falling / (1.0 + 1.515 * x)
        number = number * share**1.4
        slip = slip * share**0.65
    drag = rate / (square + slip * s)
    lam = number * drag
    # 1e-12, because a fractional power has no series at zero
    heavy = inertia * (square * rate) * (square * rate) + 1e-12
    heavy = (1.0 + heavy**0.625) ** 0.4
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    u2 = u * u
    share = 1.0 / (1.0 + 0.2586 * u + 0.01593 * u2 + 0.00603 * u2 * u)
    lift = (0.01846 * u + 0.01269 * u2) / (1.0 + 0.00925 * u2)
    tip = (0.00189 * u + 0.00436 * u2) / (1.0 + 0.00778 * u2)
    fall = falling / (square * (s + 0.5 * slip))
    lever = 4.0 / 3.0 + 5.0 / 12.0 * share
    if bowl != 0:
        lever = 1.0 + (lever - 1.0) / (1.0 + 1.389 * x)
    return turning * drag * heavy * share, fall, lever, ambient * tip, ambient * lift


def moment_parts_over_hole(
    parts: "tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression]",
    s: "NumberOrExpression",
    film: "Film",
) -> "tuple[NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression, NumberOrExpression]":
    """Return the results of `film_moment_parts` for a hole in table or disk.

    The air flows out at both edges of the ring between rim and hole. The resistances are
    polynomials of w = 1/(1 + x), where x is the gap that the bowl adds in the middle, which
    `annular_film.closed_film_polynomials` fits to the solution for the ring. The air in the
    ring is incompressible: its lift by compression, which is up to 0.13 of the weight
    without a hole, is neglected.

    Parameters
    ----------
    parts : tuple
        Results of `film_moment_parts`.
    s : float
        sin(beta).
    film : tuple
        The constants of `film_moment_parts`; the last one contains those of the hole.

    Returns
    -------
    tuple
        The parts in the same order.
    """
    drag, fall, _, _, _ = parts
    bowl = film[6]
    hole = film[7]
    x = bowl / s
    w = 1.0 / (1.0 + x)
    turning = 0.0
    closing = 0.0
    lifting = 0.0
    for k in range(HOLE_COEFFICIENTS - 1, -1, -1):
        turning = w * (turning + hole[k])
        closing = w * (closing + hole[k + HOLE_COEFFICIENTS])
        lifting = w * (lifting + hole[k + 2 * HOLE_COEFFICIENTS])
    # without the resistance to the bowl in `film_moment_parts`, which the polynomials contain
    turning = turning * (1.0 + x * (2.241 + x * (1.028 + x * 0.0703)))
    return (
        drag * turning,
        fall * closing * (1.0 + 1.515 * x),
        lifting / closing,
        0.0,
        0.0,
    )


def squeezed_air_energy(
    s: float, rate: float, number: float, ambient: float, slip: float, bowl: float
) -> float:
    """Return the energy of the compressed air of a rotating film.

    It is s p pi R^3 times the mean of h (P ln P - P + 1), with P in units of the
    ambient pressure and h in units of the gap at the centre. By conservation of mass,
    the work on the face equals the increase in this energy plus the loss int h^3 |grad
    p|^2/(12 mu) dA. The film can therefore return at most this energy. The constants
    are those of `film_moment_parts`.
    """
    if bowl != 0:
        x = bowl / s
        share = 1.0 / (1.0 + x * (2.241 + x * (1.028 + x * 0.0703)))
        number = number * share**1.4
        slip = slip * share**0.65
    lam = number * rate / (s * s + slip * s)
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    share = (
        u
        * (0.000572 + u * (0.00073 + u * 0.000276))
        / (1.0 + u * u * (0.00916 + u * 0.000565))
    )
    return ambient * s * share

"""The forces of the film on a disk, in closed form, for scalars of any kind: floats, arrays, machine code, series.

The air is isothermal and compressible, it slips at the walls, and follows the turning and the falling of the instant.
The wedge h = s (R + x), s = sin(beta), turns at Omega and closes at omega_1; Kn = mean free path/(R s), and
Lam = 12 mu Omega/(p s^2) over the part in which slip lets more air through. Every fit is one to reynolds.py, and
tests/test_film_solved.py tells how good it is.
"""

FLATTENS = 0.2
"""Lam from which the air begins to be squeezed rather than driven, in these fits to the solved film:"""
SLIP = 12.3
"""Over Kn, what slip adds to the mobility of the turning film; of the falling one half as much."""
SLOW = 6.3
"""Thickness of the film over that of its boundary layers, S, from which its inertia counts in the turning film."""
NOTHING = 1e-12
"""Added to (S/SLOW)^4, of which a broken power is taken: without precession its series has no end."""


def forces(s, nutation, rate, *constants):
    """Return three moments of the film at sin(beta) s: against e_3; against e_1, about the contact; its lift times R.

    `nutation` and `rate` are omega_1 and Omega; the constants are those of `parts`.
    """
    drag, fall, lever, tip, lift = parts(s, rate, *constants)
    return drag, fall * nutation + tip, lever * fall * nutation + lift


def parts(s, rate, turning, falling, inertia, number, ambient, slip):
    """Return the moment against e_3; of a fall the moment per omega_1 about the contact, and R over the distance of its
    lift from there; and of squeezed air that turns the moment about the contact, and the lift times R.

    `turning` and `falling` are 12 mu R^3 times I and I_n, `inertia` (S/SLOW)^4 over (rate s^2)^2, `number` Lam/FLATTENS
    over rate/s^2, `ambient` p pi R^3, `slip` SLIP times the mean free path over R.
    """
    square = s * s
    drag = rate / (square + slip * s)
    lam, layers = number * drag, square * rate
    heavy = (1.0 + (inertia * layers * layers + NOTHING) ** 0.625) ** 0.4
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    u2 = u * u
    share = 1.0 / (1.0 + 0.2586 * u + 0.01593 * u2 + 0.00603 * u2 * u)
    lift = (0.01846 * u + 0.01269 * u2) / (1.0 + 0.00925 * u2)
    tip = (0.00189 * u + 0.00436 * u2) / (1.0 + 0.00778 * u2)
    fall, lever = falling / (square * (s + 0.5 * slip)), 4.0 / 3.0 + 5.0 / 12.0 * share
    return turning * drag * heavy * share, fall, lever, ambient * tip, ambient * lift


def holds(s, rate, number, ambient, slip):
    """Return the energy of the air that a film squeezes as it turns: s p pi R^3 times the mean of h (P ln P - P + 1).

    P and h are over those around and in the middle. By the flow of mass, the work on the face is what this grows by and
    int h^3 |grad p|^2/(12 mu) dA, which is lost: so no more than this comes back. Constants are those of `parts`.
    """
    lam = number * rate / (s * s + slip * s)
    u = ((1.0 + lam * lam) ** 0.5) ** 0.5 - 1.0
    share = u * (0.000572 + u * (0.00073 + u * 0.000276)) / (1.0 + u * u * (0.00916 + u * 0.000565))
    return ambient * s * share

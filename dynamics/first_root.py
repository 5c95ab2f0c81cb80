"""The first guard that falls through zero along a curve, for integrators that do not find roots themselves."""

LOOKS = 4
"""Points of a step at which the guards are looked at."""


def first_fall(curve, start, stop, guards, values):
    """Return the time of the first fall of a guard on (start, stop] (or stop), its name (or None) and the last values.

    `curve(t)` is the state, `guards(y)` the guards by name, `values` what they are at `start`. A guard that is not
    positive at `start` cannot fall.
    """
    first, length = start, (stop - start) / LOOKS
    for look in (*(first + k * length for k in range(1, LOOKS)), stop):
        now = guards(curve(look))
        falls = [name for name in now if values[name] > 0 >= now[name]]
        if falls:
            from scipy.optimize import brentq  # loads slowly

            roots = {name: brentq(lambda t, n=name: guards(curve(t))[n], start, look, xtol=1e-16) for name in falls}
            name = min(roots, key=roots.get)
            return roots[name], name, now
        start, values = look, now
    return stop, None, values

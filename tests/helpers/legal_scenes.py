"""Random legal scenes with every section as TOML documents, and the outcomes allowed for a run."""

import time
import warnings
from math import exp, isnan, log, radians, sin, sqrt

from sonify import SceneError, solve
from sonify.scene import from_document

MAX_SECONDS_PER_SCENE = 400.0
"""Processor time [s] after which a scene hangs, also on a slow machine.

The mean is 4 s; several listeners or hundreds of modes take up to 85 s, or 121 s on a machine that
is twice as slow.
"""


def decades(random, low, high):
    """Draw a number with a uniformly distributed logarithm."""
    return exp(random.uniform(log(low), log(high)))


def odd(random, usual, corner, share=0.05):
    """Draw a positive quantity from its usual range [low, high], sometimes from a wider one."""
    return decades(random, *(corner if random.random() < share else usual))


def any_disk(random):
    """Draw a disk, mostly one that fits on a table."""
    radius = odd(random, (5e-3, 0.15), (1e-4, 10))
    thickness = radius * odd(random, (0.02, 2), (1e-3, 20))
    disk = {"radius": radius, "thickness": thickness}
    if random.random() < 0.1:
        return disk | {"mass": decades(random, 1e-6, 1e3)}
    disk["density"] = odd(random, (500, 2e4), (1, 1e5))
    if random.random() < 0.1:
        disk |= {"shape": "shell", "wall": radius * random.uniform(0.02, 0.9)}
    return disk


def any_material(random):
    """Draw the material of the disk, from rubber to diamond and beyond."""
    material = {
        "young": odd(random, (1e9, 4e11), (1e4, 1e14)),
        "poisson": random.uniform(-0.9, 0.499)
        if random.random() < 0.1
        else random.uniform(0.0, 0.45),
        "loss_factor": random.choice([decades(random, 1e-5, 1e-1)] * 8 + [0.0, 1.0]),
    }
    if random.random() < 0.1:
        material["decay_rates"] = [decades(random, 0.1, 1e3)]
    return material


def any_friction(random, radius):
    """Draw friction coefficients, sometimes equal, zero or very large, and arms of the resisting
    moments."""
    mu = random.choice([decades(random, 0.02, 1)] * 8 + [0.0, 5.0])
    ratio = random.choice([1.0, 1.01, random.uniform(1, 2), random.uniform(1, 2)])
    friction = {"mu_static": ratio * mu, "mu_dynamic": mu}
    for arm in ("arm_nutation", "arm_rolling", "arm_pivoting"):
        if random.random() < 0.8:
            friction[arm] = radius * odd(random, (1e-6, 1e-2), (1e-9, 0.5))
    return friction


def any_release(random, radius, friction):
    """Draw a release, near a steady motion or at random."""
    inclination_deg = odd(random, (2, 60), (1e-3, 89))
    beta = radians(inclination_deg)
    steady = sqrt(4 * 9.81 / (radius * sin(beta)))
    whirl = random.choice([1, 1, 1, 0.5, 0, -1, 3]) * steady * sin(beta)
    spread = random.choice([0.0, 0.02, 0.2, 1.0]) * steady * sin(beta)
    return {
        "inclination_deg": inclination_deg,
        "omega": [
            random.gauss(0, spread),
            random.gauss(0, spread),
            random.gauss(whirl, spread),
        ],
    }


def any_support(random, disk):
    """Draw the support used for the modes."""
    kind = (
        "free"
        if disk.get("shape") == "shell"
        else random.choice(["patch", "free", "contact"])
    )
    support = {"kind": kind}
    if kind == "patch":
        support["half_angle_deg"] = odd(random, (1, 30), (0.05, 180))
        if random.random() < 0.2:
            support |= {
                "height": random.uniform(0.1, 1) * disk["thickness"],
                "position": "bottom",
            }
        if random.random() < 0.1:
            support["held"] = random.choice(
                [["axial", "radial"], ["tangential", "axial"], ["axial"]]
            )
    if kind == "contact" and random.random() < 0.3:
        support["inclination_deg"] = decades(random, 1e-4, 80)
    return support


def any_plate_material(random):
    """Draw the material of a table."""
    return {
        "young": odd(random, (1e9, 2e11), (1e6, 1e13)),
        "poisson": random.uniform(0.0, 0.45),
        "density": odd(random, (100, 8000), (1, 5e4)),
        "loss_factor": random.choice([decades(random, 1e-4, 0.3)] * 5 + [0.0, 1.0]),
    }


def any_surface(random, radius):
    """Draw a table, or None for the default, a rigid one."""
    kind = random.choice(
        [None, "rigid", "plate", "plate", "modes", "modes", "infinite"]
    )
    if kind in (None, "rigid"):
        return kind and {"kind": kind}
    surface = {"kind": kind}
    if random.random() < 0.6:
        surface["action"] = random.choice(["auto", "sound", "motion"])
    if kind == "modes":
        surface["modes"] = [
            {
                "order": random.choice([0, 0, 1, 2, 3, 8]),
                "frequency": odd(random, (80, 8000), (1, 1e5)),
                "damping_ratio": random.choice([decades(random, 1e-4, 0.3), 0.0, 0.9]),
                "modal_mass": odd(random, (0.05, 100), (1e-4, 1e5)),
            }
            for _ in range(random.randint(1, 4))
        ]
        return surface
    if kind == "infinite":
        return (
            surface
            | {"thickness": odd(random, (2e-3, 0.1), (1e-4, 5))}
            | any_plate_material(random)
        )
    size = radius * odd(random, (2, 8), (1.01, 60))
    surface |= {
        "radius": size,
        "thickness": size * odd(random, (0.01, 0.1), (1e-3, 0.9)),
    }
    surface |= any_plate_material(random) | {
        "edge": random.choice(["free", "supported", "clamped"])
    }
    if random.random() < 0.15:
        surface |= {
            "ring_radius": size * random.uniform(0.2, 1),
            "ring_stiffness": decades(random, 1e3, 1e9),
        }
    if random.random() < 0.3:
        surface["place"] = [
            random.uniform(-0.6, 0.6) * (size - radius) for _ in range(2)
        ]
    return surface


def any_contact(random, disk):
    """Draw a contact, elastic or rigid."""
    contact = {"law": random.choice(["elastic", "elastic", "elastic", "rigid"])}
    if random.random() < 0.6:
        contact["fillet"] = min(disk["thickness"] / 2, disk["radius"]) * odd(
            random, (0.05, 1), (1e-3, 1)
        )
    if random.random() < 0.7:
        contact |= {
            "young": odd(random, (1e9, 2e11), (1e5, 1e14)),
            "poisson": random.uniform(0.0, 0.45),
        }
    contact["loss_factor"] = random.choice([decades(random, 1e-3, 0.5), 0.0, 0.02])
    contact["body"] = random.choice(["elastic", "elastic", "rigid"])
    return contact


def any_roughness(random, radius):
    """Draw the roughness of table and edge."""
    roughness = {
        "rms": odd(random, (1e-9, 3e-7), (1e-12, 1e-5)),
        "loss": random.choice(["own", "fitted"]),
    }
    if random.random() < 0.4:
        roughness["rms_edge"] = random.choice([0.0, decades(random, 1e-9, 1e-7)])
    if random.random() < 0.4:
        shortest = decades(random, 1e-5, 1e-3)
        roughness |= {
            "shortest": shortest,
            "longest": shortest * decades(random, 2, 5e3),
        }
    if random.random() < 0.4:
        roughness["exponent"] = random.uniform(0, 4)
    return roughness | {"seed": random.randint(0, 9)}


def any_dissipation(random, disk):
    """Draw one or two further laws of dissipation of a strength that affects the disk."""
    mass = (
        disk.get("mass")
        or disk["density"] * 3 * disk["radius"] ** 2 * disk["thickness"]
    )
    chi = sqrt(disk["radius"] / 8)
    strength = decades(random, 1e-7, 1e-1)
    inertia = strength * mass * disk["radius"] ** 2
    power = random.choice([1.0, 2.5, 4.0])
    laws = [
        {"viscous_moment": inertia / chi, "viscous_force": strength * mass / chi},
        {"contour_moment": inertia / chi**2},
        {"power_coefficient": inertia * chi ** (power - 3), "power_exponent": power},
        {"air_viscosity": decades(random, 1e-6, 1e-2)},
        {
            "boundary_layer_viscosity": decades(random, 1e-6, 1e-3),
            "air_density": decades(random, 1e-2, 10),
        },
    ]
    first, second = random.sample(laws, 2)
    return first | (second if random.random() < 0.2 else {})


def any_air(random):
    """Draw the air, from a poor vacuum to oil."""
    air = {"film": random.choice(["auto", "auto", "acts", "none"])}
    if random.random() < 0.7:
        air["viscosity"] = odd(random, (3e-6, 1e-4), (1e-9, 100))
    if random.random() < 0.6:
        air["pressure"] = odd(random, (2e3, 1e6), (1e-3, 1e9))
    if random.random() < 0.2:
        air["density"] = random.choice([0.0, decades(random, 1e-4, 1e3)])
    if random.random() < 0.2:
        air["temperature"] = random.uniform(50, 3000)
    return air


def any_audio(random, radius):
    """Draw the settings of the sound file and the listeners."""
    audio = {
        "sample_rate": random.choice([48000, 48000, 44100, 22050, 8000, 96000]),
        "distance": max(0.5, 1.5 * radius) * odd(random, (1, 4), (0.7, 500)),
        "elevation_deg": random.choice([45.0, 0.0, 90.0, random.uniform(0, 90)]),
    }
    if random.random() < 0.15:
        audio["listeners"] = [
            {
                "distance": 2 * radius + random.uniform(0.1, 2),
                "azimuth_deg": random.uniform(-180, 180),
            }
            for _ in range(random.randint(1, 3))
        ]
    return audio


def any_numerics(random, radius):
    """Draw the numerical settings: mostly a draft of a part of the motion."""
    numerics = {
        "accuracy": random.choice(["draft"] * 9 + ["standard"]),
        "time_limit": min(random.choice([0.05, 0.5, 2.0]), 60 * sqrt(radius / 8)),
    }
    if random.random() < 0.2:
        numerics["integrator"] = random.choice(["taylor", "dop853"])
    if random.random() < 0.3:
        numerics["contact"] = random.choice(["filter", "full"])
    if random.random() < 0.1:
        numerics["final_inclination"] = decades(random, 1e-8, 0.1)
    if random.random() < 0.1:
        numerics["contact_rate"] = decades(random, 5e4, 2e6)
    if random.random() < 0.05:
        numerics["tolerance"] = decades(random, 1e-16, 1e-9)
    return numerics


def any_document(random):
    """Draw the document of a scene; about one in ten is not legal."""
    disk = any_disk(random)
    radius = disk["radius"]
    friction = any_friction(random, disk["radius"])
    document = {
        "disk": disk,
        "material": any_material(random),
        "friction": friction,
        "release": any_release(random, radius, friction),
        "support": any_support(random, disk),
        "numerics": any_numerics(random, radius),
        "audio": any_audio(random, radius),
    }
    if surface := any_surface(random, radius):
        document["surface"] = surface
    if random.random() < 0.5:
        document["contact"] = any_contact(random, disk)
        if random.random() < 0.5:
            document["roughness"] = any_roughness(random, radius)
    if random.random() < 0.3:
        document["dissipation"] = any_dissipation(random, disk)
    if random.random() < 0.7:
        document["air"] = any_air(random)
    if random.random() < 0.05:
        document["imperfection"] = {
            "order": random.randint(2, 8),
            "amplitude": decades(random, 1e-8, 1e-4),
        }
    return document


def faults_of(document) -> tuple[str, list[str]]:
    """Run a scene; return its ending and a list of its faults.

    A scene ends in a named outcome or in one line of a SceneError. Faults are any other exception,
    a warning, a failed self-check, a finding with a non-finite value, and a run of more than
    MAX_SECONDS_PER_SCENE of processor time.
    """
    began = time.process_time()
    result = None
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        warnings.simplefilter(
            "ignore", DeprecationWarning
        )  # between third-party libraries
        try:
            result = solve(from_document(document))
            ending = result.motion.outcome.name
        except SceneError as error:
            ending = f"SceneError: {error}"
        except Exception as error:
            ending = f"{type(error).__name__}: {error} {place_of(error)}"
    took = time.process_time() - began
    faults = [
        f"{w.category.__name__}: {w.message} ({w.filename}:{w.lineno})" for w in told
    ]
    if result is not None:
        faults += [f"failed: {check}" for check in result.checks if not check.passed]
        values = {finding.key: finding.value for finding in result.findings}
        faults += [
            f"finding {key} is nan"
            for key, value in values.items()
            if isinstance(value, float) and isnan(value)
        ]
    elif not ending.startswith("SceneError") or "\n" in ending:
        faults.append(ending)
    if took > MAX_SECONDS_PER_SCENE:
        faults.append(f"took {took:.0f} s")
    return ending, faults


def place_of(error) -> str:
    """Return the last source line of this project in the traceback of an exception."""
    frame = error.__traceback__
    place = ""
    while frame:
        file = frame.tb_frame.f_code.co_filename
        if any(part in file for part in ("/sonify/", "/dynamics/", "/modal/")):
            place = f"({file}:{frame.tb_lineno})"
        frame = frame.tb_next
    return place

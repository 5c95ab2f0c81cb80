"""Faulty values of scenes, each with a part of the message that it must give.

The bounds of single keys are tested by test_the_range_in_the_reference_is_what_is_allowed."""

PLATE = "{kind='plate', radius=0.15, thickness=0.006, young=70e9, poisson=0.22, density=2500.0}"
MODES = "{kind='modes', modes=[{order=2, frequency=600.0, damping_ratio=0.02, modal_mass=1.0}]}"

FAULTS = [
    ("disk.radius=-1", "disk.radius = -1: must be greater than 0"),
    ("disk.radius=1e-300", "disk: radius = 1e-300: must not be below 1e-09"),
    ("disk.mass=nan", "disk.mass = nan: must be finite"),
    ("disk.radius=inf", "disk.radius = inf: must be finite"),
    ("release.omega=[0.0, nan, 0.0]", "release.omega = nan"),
    ("friction.mu_static=nan", "friction.mu_static = nan"),
    ("friction.mu_dynamic=-inf", "friction.mu_dynamic = -inf"),
    (
        "friction.arm_pivoting=slip",
        "friction.arm_pivoting = 'slip': must be a valid number, or 'contact'",
    ),
    (
        "friction.arm_pivoting=-1",
        "friction.arm_pivoting = -1: must be greater than or equal to 0, or 'contact'",
    ),
    ("audio.distance=0.01", "audio.distance = 0.01"),
    (
        "disk.radios=0.04",
        "disk.radios: unknown key; known: radius, thickness, mass, density, shape",
    ),
    ("disc.radius=0.04", "disc: unknown key; known: name, disk"),
    ("disk.radius=true", "disk.radius = True"),
    ("disk.radius=wide", "disk.radius = 'wide': must be a valid number"),
    ("disk.shape=square", "disk.shape = 'square': must be 'solid' or 'shell'"),
    ("disk=3", "disk = 3"),
    ("disk.density=7000", "disk: give either mass or density"),
    (
        "release.inclination_deg=90",
        "release.inclination_deg = 90: must be less than 90",
    ),
    ("release.omega=[1.0, 2.0]", "release.omega.2: missing"),
    ("release.omega=2024-01-01", "release.omega"),
    ("friction.mu_dynamic=0.6", "mu_dynamic = 0.6 must not exceed mu_static = 0.5"),
    (
        "support.half_angle_deg=181",
        "support.half_angle_deg = 181: must be less than or equal to 180",
    ),
    (
        "surface.kind=water",
        "surface.kind = 'water': must be one of 'rigid', 'plate', 'modes', 'infinite', 'mesh'",
    ),
    ("surface.kind=plate", "surface.radius: missing"),
    ("surface.radius=1", "surface.radius: unknown key; known: kind"),
    ("surface={}", "surface.kind: missing"),
    (
        f"surface={PLATE.replace('radius=0.15', 'radius=0.01')}",
        "surface.radius = 0.01: must be at least disk.radius",
    ),
    (
        f"surface={PLATE.replace('0.006', '0.2')}",
        "surface: thickness = 0.2: must not exceed radius = 0.15",
    ),
    (
        f"surface={PLATE.replace('}', ', ring_radius=0.1}')}",
        "surface: give ring_radius and ring_stiffness together",
    ),
    (
        "surface={kind='modes', modes=[]}",
        "surface.modes = []: must have at least 1 values",
    ),
    (
        f"surface={MODES.replace('600.0', '0')}",
        "surface.modes.0.frequency = 0: must be greater than 0",
    ),
    (
        f"surface={MODES.replace('0.02', '1')}",
        "surface.modes.0.damping_ratio = 1: must be less than 1",
    ),
    (
        f"surface={MODES.replace('order', 'n')}",
        "surface.modes.0.n: unknown key; known: order, frequency, damping_ratio",
    ),
    (
        "audio.sample_rate=7999",
        "audio.sample_rate = 7999: must be greater than or equal to 8000",
    ),
    (
        "audio.sample_rate=44100.5",
        "audio.sample_rate = 44100.5: must be a whole number",
    ),
    ("audio.sample_rate=1e300", "audio.sample_rate = 1e+300: must be a whole number"),
    ("name=../elsewhere", "name = '../elsewhere'"),
    ("disk", "'disk': expected section.key=value"),
    (".radius=1", "'.radius=1': expected section.key=value"),
    ("disk.radius.x=1", "disk.radius.x: radius is a value, not a section"),
    ("disk=word", "disk = 'word': must be a section"),
    ("release.omega=3.0", "release.omega = 3.0: must be a list"),
    (
        "release.omega=[1.0, 2.0, 3.0, 4.0]",
        "release.omega = [1.0, 2.0, 3.0, 4.0]: must have at most 3 values",
    ),
    (
        "friction.arm_pivoting=contact",
        "friction.arm_pivoting = 'contact': requires contact.law = 'elastic' or contact.fillet",
    ),
    ("surface.sag=1e-3", "surface.sag = 0.001: requires surface.diameter"),
    (
        "surface={sag=0.05, diameter=0.229}",
        "surface.sag = 0.05: too deep for the rim of the disk; at most 0.0175 m is possible",
    ),
    (
        "surface={sag=1e-3, diameter=0.07}",
        "surface.diameter = 0.07: must exceed the disk diameter, 0.0751",
    ),
    (
        "contact.fillet=0.007",
        "contact.fillet = 0.007: must be positive and at most 0.0064, so that it fits the disk",
    ),
    (
        "friction.arm_pivoting=0.04",
        "friction.arm_pivoting = 0.04: must not exceed disk.radius = 0.03755",
    ),
    (
        "friction.mu_static=1e308",
        "mu_static = 1e+308: must be less than or equal to 1e+06, or inf",
    ),
    (
        "friction.mu_static=.6",
        "friction.mu_static = .6: in TOML this number is written 0.6",
    ),
    (
        "friction.mu_static=10.",
        "friction.mu_static = 10.: in TOML this number is written 10.0",
    ),
    ("friction.mu_static=0.4\nmu_dynamic=0.1", "must be a single value on one line"),
    ("name=two\nlines", "name = 'two\\nlines': invalid TOML"),
    (
        "support.inclination_deg=3",
        "inclination_deg = 3: allowed only with kind = 'contact', not 'patch'",
    ),
    ("air.viscosity=0", "air.viscosity = 0"),
    ("air.viscosity=-1e-5", "air.viscosity = -1e-05"),
    (
        "air={pressure=0, film='acts'}",
        "requires air, but pressure = 0 (vacuum)",
    ),
    ("air.pressure=-1", "air.pressure = -1"),
    ("air.film=thick", "air.film"),
    ("surface.hole=0.0751", "surface.hole = 0.0751: must not reach"),
    ("release.omega=[1.0, 2.0", "release.omega = '[1.0, 2.0': invalid TOML"),
]

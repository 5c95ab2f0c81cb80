"""Solve and render three short scenes in the order of the arguments; print a hash of every result.

tests/rigid/test_machine_code_order.py runs it with the usual and with an empty cache of machine code.
"""

import re
import sys
from hashlib import sha256

import numpy as np

from dynamics import Motion, simulate
from dynamics.compliant.stepping.time_loop import step_motion
from modal import eigenmodes
from sonify import load_scene
from sonify.sound.render import Renderer

MODE = "{order=3, frequency=600.0, damping_ratio=0.005, modal_mass=1.0}"
TABLE = f"surface={{kind='modes', action='motion', modes=[{MODE}]}}"
RELEASED_FLAT = (
    "release.inclination_deg=0.3",
    "release.omega=[0.0, 0.461, 2.70]",
    "numerics.accuracy=draft",
)
ROUGH = "roughness.rms=1e-7", "numerics.contact=full", "numerics.time_limit=0.05"
FUSED = re.compile("fn?m(add|sub|la|ls)")
PORTABLE = "numerics.integrator=dop853", "numerics.time_limit=0.5"


def table() -> tuple[Motion, np.ndarray]:
    """Return the motion on a light table and its pressure [Pa]."""
    scene = load_scene("published").replace(
        *RELEASED_FLAT, TABLE, "contact.law=elastic", "numerics.time_limit=0.1"
    )
    motion = simulate(scene)
    blocks = Renderer(scene, motion, eigenmodes(scene, below=8e3)).blocks()
    return motion, np.vstack(list(blocks))


def rough() -> tuple[Motion, np.ndarray]:
    """Return the motion on a rough contact and its normal force [N]."""
    motion = simulate(
        load_scene("published").replace(*RELEASED_FLAT, "contact.law=elastic", *ROUGH)
    )
    return motion, motion.force(motion.t)


def portable() -> tuple[Motion, np.ndarray]:
    """Return the motion from the Numba integrator and its force at many times [N]."""
    motion = simulate(load_scene("published").replace(*PORTABLE))
    return motion, motion.force(np.linspace(0.0, 0.5, 5000))


def main(names: list[str]) -> None:
    """Print name, end and hashes of each result in alphabetical order.

    Then print the numbers of multiplications and of fused operations in the machine code of
    `step_motion`.
    """
    cases = {"table": table, "rough": rough, "portable": portable}
    found = {name: cases[name]() for name in names}
    for name, (motion, more) in sorted(found.items()):
        hashes = [
            sha256(array.tobytes()).hexdigest()
            for array in (motion.t, motion.state, more)
        ]
        print(name, float(motion.t[-1]), *hashes)
    assembly = "".join(step_motion.inspect_asm().values())
    instructions = [
        words[0] for line in assembly.splitlines() if (words := line.split())
    ]
    print(
        "march",
        sum("mul" in word for word in instructions),
        len([*filter(FUSED.search, instructions)]),
    )


if __name__ == "__main__":
    main(sys.argv[1:])

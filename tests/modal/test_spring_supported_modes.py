"""Claim: the modes of a disk on its elastic contact follow from its free modes and residual
flexibility on the contact springs.

Source: Hertz, Mindlin and Kalker for the springs (dynamics/compliant); MacNeal (1971), Rubin (1975)
for the flexibility. Oracle: the rigid disk on the same springs; the free disk; finite elements of
the disk with springs at its edge.
"""

from dataclasses import replace
from math import pi
from types import SimpleNamespace

import numpy as np
import pytest
from contact_scenes import granite, on_springs, steady_speed
from scipy.sparse.linalg import LinearOperator, eigsh, splu
from skfem import ElementHex2

from dynamics.compliant.law.hertz_mindlin import ElasticConstants
from dynamics.compliant.law.linearised import (
    linear_contact,
    normal_damping,
    resonances,
    rigid_mode_shapes,
    suspension,
)
from modal import FreeDisk, Material, Plate, Support, UnsolvableError, eigenmodes
from modal.accuracy import REFERENCE_COARSE_MESH
from modal.elements.elastic import assemble_solid
from modal.elements.sample import quadratic_shape_functions, quadratic_shape_slopes
from modal.elements.unfold import HEXAHEDRON_SIDES
from modal.mesh.sector import sector
from modal.mesh.symmetry import Mirror, admissible_displacements, rigid_fields
from modal.spectral.axisymmetric import plate_modes
from modal.spring_supported import (
    contact_modes,
    patch_to_contact_rotation,
    residual_flexibility,
)
from modal.synthesis.free_disk import BasisSizes
from modal.synthesis.residual_flexibility import nonlocal_flexibility, strip_flexibility
from sonify import load_scene
from sonify.plan.supports import modes_over_run, support_comparison
from sonify.report.pictures import mode_changes_text
from sonify.report.write import mode_changes_record
from sonify.sound.modal_forcing import forcing_per_newton

LAW = granite()
DISK = LAW.disk
DENSITY = DISK.mass / (pi * DISK.radius**2 * DISK.thickness)
PLATE = Plate(
    radius=DISK.radius,
    thickness=DISK.thickness,
    material=Material(young=195e9, poisson=0.28),
    density=DENSITY,
)
BODY = FreeDisk(plate=PLATE)


def modes_on(springs, inclination, plate=PLATE, below=24e3):
    return contact_modes(plate, springs, inclination, below, "standard")


@pytest.mark.parametrize("beta", [0.57, 0.1, 0.01, 1e-4])
def test_a_rigid_disk_has_the_resonances_of_its_contact(beta):
    """Frequencies and losses agree, creep included; the disk has 1e-6 of its true flexibility."""
    stiff = replace(PLATE, material=replace(PLATE.material, young=195e15))
    modes = modes_on(suspension(LAW, beta), beta, stiff)
    at = np.array([beta])
    weight = DISK.weight
    system = linear_contact(
        DISK,
        at,
        LAW.springs(at, weight),
        steady_speed(LAW, beta),
        normal_damping(LAW, at, weight),
        fillet=LAW.rolling_fillet,
    )
    rigid = resonances(system)
    assert modes.frequency == pytest.approx(rigid.frequency[0], rel=1e-6)
    roots = np.hypot(2 * pi * modes.frequency, modes.decay_rate)
    assert 2 * modes.decay_rate / roots == pytest.approx(rigid.loss_factor[0], rel=1e-6)


def test_a_soft_contact_leaves_the_free_modes():
    """By first-order perturbation, springs of 1e-6 the stiffness shift w^2 by 1e-6 as much."""
    springs = suspension(LAW, 0.1)
    soft = modes_on(
        springs._replace(
            stiffness=1e-6 * springs.stiffness, damping=0 * springs.damping
        ),
        0.1,
    )
    free = plate_modes(PLATE, 48e3)  # from the same basis
    free = free.select(free.frequency < 24e3)
    assert soft.frequency[-len(free) :] == pytest.approx(free.frequency, rel=1e-7)
    assert sorted(soft.order[-len(free) :]) == sorted(free.order)


def test_ever_stiffer_tables_have_a_limit():
    """The limit is the disk's own half of the contact; the table's flexibility is ~ 1/E."""
    found = []
    for young in (1e13, 1e14, 1e15, 1e16):
        law = granite(table=ElasticConstants(young, 0.2))
        springs = suspension(law, 0.1)._replace(
            damping=np.zeros(3), relaxation_rate=np.zeros(3)
        )
        found.append(modes_on(springs, 0.1).frequency)
    steps = np.diff(found, axis=0)
    assert (steps > 0).all()
    assert steps[:-1] / steps[1:] == pytest.approx(
        np.full((2, len(found[0])), 10), rel=0.05
    )


def test_small_losses_are_of_first_order():
    """The decay rate is c x^2/2 for normal damping and r k x^2/(2 w^2) for creep.

    x is the stretch of a spring per unit of the modal coordinate q, here of a sharp edge.
    """
    springs = suspension(LAW, 0.1)._replace(offset=np.zeros(3))
    still = modes_on(
        springs._replace(damping=np.zeros(3), relaxation_rate=np.zeros(3)), 0.1
    )
    assert still.decay_rate == pytest.approx(0, abs=1e-6)
    rest, _ = residual_flexibility(PLATE, 24e3, "standard")
    turn = patch_to_contact_rotation(0.1)
    yields = np.diag(1 / springs.stiffness) + turn @ rest @ turn.T
    stretch = (
        np.linalg.solve(yields, turn @ still.rim_shape[:, 0].T).T / springs.stiffness
    )
    lossy = modes_on(
        springs._replace(damping=1e-3 * springs.damping, relaxation_rate=np.zeros(3)),
        0.1,
    )
    assert lossy.decay_rate == pytest.approx(
        1e-3 * springs.damping[2] * stretch[:, 2] ** 2 / 2, rel=1e-3, abs=1e-9
    )
    creeps = modes_on(
        springs._replace(
            damping=np.zeros(3), relaxation_rate=1e-3 * springs.relaxation_rate
        ),
        0.1,
    )
    power = (1e-3 * springs.relaxation_rate * springs.stiffness * stretch**2).sum(
        axis=1
    )
    assert creeps.decay_rate == pytest.approx(
        power / (2 * (2 * pi * still.frequency) ** 2), rel=1e-3, abs=1e-9
    )


@pytest.mark.parametrize(("beta", "ratio"), [(0.57, 0.98), (0.1, 0.97), (0.001, 0.90)])
def test_the_carrier_of_an_elastic_disk_is_lower_than_that_of_a_rigid_one(beta, ratio):
    """At low frequency the body is a spring F0 in series with the contact springs.

    The relative effect of the body grows with the square of frequency over that of the first free
    mode.
    """
    springs = suspension(LAW, beta)
    at = np.array([beta])
    turn = patch_to_contact_rotation(beta)
    elastic = modes_on(
        springs._replace(damping=np.zeros(3), relaxation_rate=np.zeros(3)), beta
    ).frequency[:3]
    stiffness = np.diag(springs.stiffness)[None]
    F0 = turn @ nonlocal_flexibility(BODY, LAW.fillet)[0] @ turn.T
    rigid, static = (
        on_springs(
            rigid_mode_shapes(DISK, at, LAW.rolling_fillet), stiffness, residual=rest
        )[0, 3:]
        for rest in (0 * F0, F0)
    )
    assert elastic[2] / rigid[2] == pytest.approx(ratio, abs=0.005)
    assert (elastic <= static).all()
    assert (
        static - elastic <= 2 * (elastic / 10603) ** 2 * np.abs(rigid - elastic)
    ).all()


@pytest.mark.parametrize("size", [0.8e-3, 1.6e-3])
def test_what_hertz_has_is_left_out_whatever_the_strip(size):
    """F grows as the strip shrinks; F0 does not, up to terms of the order 1/(E R)."""
    (one, doubt), (two, _) = (nonlocal_flexibility(BODY, s) for s in (size, 2 * size))
    grown = strip_flexibility(BODY, size)[0] - strip_flexibility(BODY, 2 * size)[0]
    assert np.abs(one - two).max() < 0.2 * np.abs(grown).max()
    assert doubt.max() < 0.1 * one.max()


def test_richer_bases_stay_within_the_doubt():
    fine = FreeDisk(
        plate=PLATE,
        richness=BasisSizes(size=(14, 10), highest_direct_order=6, highest_order=300),
    )
    (one, doubt), (two, less) = (
        nonlocal_flexibility(disk, LAW.fillet) for disk in (BODY, fine)
    )
    assert (np.abs(one - two) <= np.outer(doubt, doubt) ** 0.5).all()
    assert less.max() < doubt.max()


def strip_quadrature(solid, size):
    """Yield nodes (3, 3), position (3,) and weights (3, 3) at the Gauss points of a strip."""
    sides = np.concatenate(
        [solid.cells[:, side] for pair in HEXAHEDRON_SIDES for side in pair]
    )
    x, y, z = np.moveaxis(solid.points[sides], -1, 0)
    rim = np.abs(np.hypot(x, y) - DISK.radius) < 1e-9 * DISK.radius
    inside = (np.abs(np.arctan2(y, x)) < 0.501 * size / DISK.radius) & (
        z < 1.001 * size - DISK.thickness / 2
    )
    at, weight = np.polynomial.legendre.leggauss(5)
    at = (at + 1) / 2
    weight = weight / 2
    for nodes in sides[(rim & inside).all(axis=1)].reshape(-1, 3, 3):
        corners = solid.points[nodes]
        for i, j in np.ndindex(5, 5):
            value = np.outer(
                quadratic_shape_functions(at[i]), quadratic_shape_functions(at[j])
            )
            along = np.einsum(
                "i,j,ijx",
                quadratic_shape_slopes(at[i]),
                quadratic_shape_functions(at[j]),
                corners,
            )
            across = np.einsum(
                "i,j,ijx",
                quadratic_shape_functions(at[i]),
                quadratic_shape_slopes(at[j]),
                corners,
            )
            area = weight[i] * weight[j] * np.linalg.norm(np.cross(along, across))
            yield nodes, np.einsum("ij,ijx", value, corners), value * area


class Elements:
    """Half the disk, y >= 0, in hexahedra graded to a strip of the edge, for one symmetry class.

    Means over the strip: `even` is uniform; `low` is weighted so that its centre is the edge.
    """

    def __init__(self, size, parity):
        support = Support(
            half_angle_deg=np.rad2deg(size / 2 / DISK.radius),
            height=size,
            position="bottom",
        )
        part = sector(DISK.radius, DISK.thickness, support, REFERENCE_COARSE_MESH)
        self.solid = assemble_solid(
            part.mesh, ElementHex2(), PLATE.material, DENSITY, intorder=4
        )
        points = self.solid.points
        mirror = Mirror(y=parity, z=0)
        self.free = admissible_displacements(
            points, np.zeros(len(points), bool), (), mirror, DISK.radius
        )
        self.K, self.M = (
            self.free.T @ a @ self.free for a in (self.solid.stiffness, self.solid.mass)
        )
        low = -DISK.thickness / 2
        area = 0.0
        means = np.zeros((2, 3, len(points), 3))
        for nodes, place, weight in strip_quadrature(self.solid, size):
            c, s = place[:2] / np.hypot(*place[:2])
            up = (place[2] - low) / size
            for row, unit in enumerate([(c, s, 0), (-s, c, 0), (0, 0, 1)]):
                means[:, row, nodes.ravel()] += np.multiply.outer(
                    [1, 4 - 6 * up], np.outer(weight.ravel(), unit)
                )
            area += weight.sum()
        self.even, self.low = (
            row @ self.free for row in means.reshape(2, 3, -1) / area
        )
        self.which = [0, 2] if parity > 0 else [1]
        fields = (
            rigid_fields(points)[[0, 2, 4] if parity > 0 else [1, 3, 5]].reshape(3, -1)
            @ self.free
        )
        self.rigid = np.linalg.solve(
            np.linalg.cholesky(fields @ self.M @ fields.T), fields
        )
        corner = rigid_fields(np.array([[DISK.radius, 0, low]]))[
            [0, 2, 4] if parity > 0 else [1, 3, 5], 0
        ].T
        self.corner = (
            corner @ np.linalg.inv(np.linalg.cholesky(fields @ self.M @ fields.T)).T
        )

    def yields(self, spread):
        """Return the elastic flexibility of the whole disk under a distributed force.

        The force on the half disk is half of the total.
        """
        loads = spread[self.which]
        loads = loads - loads @ self.rigid.T @ (self.rigid @ self.M)
        solved = splu((self.K + 1e3 * self.M).tocsc()).solve(loads.T)
        return loads @ solved / 2

    def frequencies(self, yields, below):
        """Return the frequencies of the disk held at its edge.

        The constraint is exact for rigid motion, and the strip mean `low` for elastic motion.
        """
        held = self.low + (self.corner - self.low @ self.rigid.T) @ (
            self.rigid @ self.M
        )
        held = held[self.which]
        half = 2 * yields
        shift = -((2 * pi * 300.0) ** 2)
        factor = splu((self.K - shift * self.M).tocsc())
        dense = factor.solve(held.T)
        inner = np.linalg.inv(half + held @ dense)

        def solve(load):
            plain = factor.solve(load)
            return plain - dense @ (inner @ (held @ plain))

        inverse = LinearOperator(self.K.shape, matvec=solve, dtype=float)
        values = eigsh(
            self.K, k=9, M=self.M, sigma=shift, OPinv=inverse, return_eigenvectors=False
        )
        found = np.sqrt(np.maximum(np.sort(values), 0)) / (2 * pi)
        return found[(found > 50) & (found < below)]


@pytest.mark.slow
@pytest.mark.parametrize("beta", [0.57, 0.1, 0.001])
def test_finite_elements_with_springs_at_their_edge_have_the_same_modes(beta):
    """The oracle's springs omit the part of the flexibility that its strip means have beyond F0.

    All springs hold a sharp edge.
    """
    springs = suspension(LAW, beta)
    turn = patch_to_contact_rotation(beta)
    strip = LAW.fillet
    found = []
    free = []
    own = np.zeros((3, 3))
    for parity in (1, -1):
        here = Elements(strip, parity)
        wide = Elements(2 * strip, parity)
        which = np.ix_(here.which, here.which)
        own[which] = 2 * wide.yields(wide.even) - here.yields(here.even)
        soft = (turn.T @ np.diag(1 / springs.stiffness) @ turn + own)[
            which
        ] - here.yields(here.low)
        found.append(here.frequencies(soft, 20e3))
        free.append(here.frequencies(1e9 * soft, 20e3))
    found, free = (np.sort(np.concatenate(part)) for part in (found, free))
    modes = modes_on(
        springs._replace(
            damping=np.zeros(3), relaxation_rate=np.zeros(3), offset=np.zeros(3)
        ),
        beta,
        below=20e3,
    )
    F0, _ = nonlocal_flexibility(BODY, strip)
    print(own * 1e9, F0 * 1e9, found, modes.frequency, free)
    assert own == pytest.approx(F0, abs=0.03 * F0.max())
    exact = plate_modes(PLATE, 20e3).frequency
    assert free == pytest.approx(exact, rel=3e-3)
    assert modes.frequency[:3] == pytest.approx(found[:3], rel=1e-3)
    assert np.diff([exact**2, modes.frequency[3:] ** 2], axis=0) == pytest.approx(
        np.diff([free**2, found[3:] ** 2], axis=0), rel=0.02
    )


def test_where_the_contact_is_elastic_its_stem_has_the_rigid_disk_and_modes_only_what_is_above():
    """On soft springs the force drives the elastic part of a shape, that of the free disk."""
    scene = load_scene("published").replace("support.kind=contact")
    elastic = scene.replace("contact.law=elastic")
    modes = eigenmodes(scene)
    alone, beside = (forcing_per_newton(modes, s) for s in (scene, elastic))
    assert (np.abs(alone).max(axis=0) > 0).all()
    assert (np.abs(beside[:, :3]) == 0).all()
    assert (np.abs(beside[:, 3:]).max(axis=0) > 0).all()
    springs = suspension(LAW, 0.1)
    soft = modes_on(springs._replace(stiffness=1e-6 * springs.stiffness), 0.1)
    elastic_part = forcing_per_newton(soft, elastic)[:, -5:]
    assert elastic_part == pytest.approx(
        soft.rim_shape[-5:, 0].T, abs=1e-4 * np.abs(elastic_part).max()
    )


def test_modes_rise_as_the_disk_falls_and_the_plan_names_what_other_supports_predict():
    scene = load_scene("published").replace(
        "support.kind=contact", "numerics.accuracy=draft"
    )
    motion = SimpleNamespace(
        t=[0.0, 2.0], at=lambda t: np.array([[0.0, 0.5 * 10.0 ** -t[0], 0.0]])
    )
    steps = modes_over_run(scene, motion, 20e3)
    assert [step.name for step in steps] == ["release", "middle", "end"]
    assert (np.diff([step.modes.frequency for step in steps], axis=0) > 0).all()
    said = support_comparison(scene, steps[0].modes, 20e3).choice
    assert all(kind in said for kind in ("contact: 7", "patch: 80", "free: 1060"))
    assert modes_over_run(load_scene("published"), motion, 20e3) == []


def test_a_run_is_told_of_also_where_its_contact_becomes_too_stiff_for_springs():
    """With half the stiffness of steel below 1e-6 rad, the springs are stiffer than the body."""
    scene = load_scene("published").replace(
        "support.kind=contact", "numerics.accuracy=draft", "material.young=100e9"
    )
    motion = SimpleNamespace(
        t=[0.0, 2.0], at=lambda t: np.array([[0.0, 0.5 * 1e-3 ** t[0], 0.0]])
    )
    steps = modes_over_run(scene, motion, 20e3)
    with pytest.raises(UnsolvableError, match="such a stiff contact"):
        eigenmodes(
            scene, 20e3, replace(scene.support, inclination_deg=np.degrees(5e-7))
        )
    assert [step.modes is None for step in steps] == [False, False, True]
    assert mode_changes_text(steps).splitlines()[-1].endswith("→ none")
    told = mode_changes_record(
        SimpleNamespace(
            scene=scene, motion=motion, plan=SimpleNamespace(highest_mode=20e3)
        )
    )["over_the_run"]
    assert [type(step["frequency"]) for step in told] == [list, list, type(None)]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (["support.inclination_deg=80"], "no steady motion"),
        (["contact.fillet=1e-7"], "too sharp"),
        (["disk.shape=shell", "disk.wall=0.001"], "must be 'free'"),
    ],
)
def test_what_has_no_contact_to_stand_on_is_one_line(changes, words):
    scene = load_scene("published").replace("support.kind=contact", *changes)
    with pytest.raises(ValueError, match=words) as raised:
        eigenmodes(scene)
    assert "\n" not in str(raised.value)


def test_springs_stiffer_than_the_disk_itself_are_refused():
    springs = suspension(LAW, 0.1)
    with pytest.raises(UnsolvableError, match="such a stiff contact"):
        modes_on(springs._replace(stiffness=1e6 * springs.stiffness), 0.1)


def test_no_mode_of_a_soft_disk_grows():
    """The contact is about as stiff as the disk.

    The residual flexibility once supplied energy to a mode, at a decay rate of -19 1/s.
    """
    soft = (
        "material.young=2.8e9",
        "material.poisson=0.38",
        "contact.young=50e9",
        "numerics.accuracy=draft",
    )
    small = (
        "disk.radius=0.0187",
        "disk.thickness=0.00284",
        "disk.mass=0.0245",
        "support.inclination_deg=0.9",
    )
    with pytest.raises(UnsolvableError, match="such a stiff contact"):
        eigenmodes(
            load_scene("published").replace("support.kind=contact", *soft, *small),
            below=20e3,
        )


def test_the_free_modes_that_a_contact_needs_are_counted():
    """Modes up to twice the highest frequency are needed; for this soft disk they took 15 GB."""
    soft = load_scene("published").replace(
        "support.kind=contact", "material.young=3e9", "disk.radius=0.0927"
    )
    with pytest.raises(UnsolvableError, match="modes below 40000 Hz, but at most 600"):
        eigenmodes(soft.replace("disk.thickness=0.015", "disk.mass=1.1"), below=20e3)

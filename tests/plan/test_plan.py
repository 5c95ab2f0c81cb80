"""Claim: a run computes exactly the work in its plan, and its error against the reference is the
predicted one.

Source: sonify/plan.py, sonify/predictions.py. Oracle: the same scene at accuracy "reference";
counts of the computed samples; white noise and sines of known level.
"""

import re
from dataclasses import replace
from math import inf, pi
from types import SimpleNamespace

import numpy as np
import pytest
import soundfile
from arithmetic import gamma
from law_scenes import named_scene
from prepared_runs import PreparedRun

import modal.accuracy
from benchmarks.cases.sound_error import audible_error, level_error
from dynamics import RigidMotion, plan_motion, simulate
from dynamics.solver_settings import ACCURACY_LEVELS, inclination_at_rate
from modal import radiation_decay
from modal.radiation import TOP_FACE
from sonify import SceneError, load_scene
from sonify.plan import sentences
from sonify.plan.plan import plan_of, steady_precession_frequency
from sonify.plan.predictions import mode_frequency_error, predicted_sound_error
from sonify.plan.preflight import plan_with_modes
from sonify.plan.table import solve_table, with_table
from sonify.scene import shipped_scenes
from sonify.sound.force import INTERPOLATION_NODES, INTERPOLATION_STRIDE
from sonify.sound.oscillators import OscillatorBank

CHAOTIC_SCENES = ("coin", "coin-grain", "coin-wood")
"""Scenes whose end varies by chance with the step: the error predicted is its usual size."""
FACTOR = 3
"""Largest ratio between predicted and measured errors."""


def measured(run, reference, key) -> float:
    """Return the error of one quantity of a run; both arguments are a `PreparedRun`."""
    if key == "frequencies":
        found = run.modes.frequency
        true = reference.modes.frequency
        count = min(len(found), len(true))
        return (
            float(np.median(np.abs(found[:count] / true[:count] - 1))) if count else 0.0
        )
    if key == "end":
        return float(reference.motion.t[-1] - run.motion.t[-1])
    return audible_error(run.sound.pressure, reference.sound.pressure)


def prepared(scene, accuracy):
    """Return a run of a scene with the given accuracy."""
    return PreparedRun(scene.replace(f"numerics.accuracy={accuracy}"))


def disagreements(scene):
    """Return the predictions of draft and standard that the measured errors contradict.

    On a table with modes, only the frequencies are predicted; no sound is rendered, and the modes
    of the table are solved once, as a draft.
    """
    reference, draft, standard = (
        prepared(scene, accuracy) for accuracy in ("reference", "draft", "standard")
    )
    if [prediction.key for prediction in draft.plan.predictions] == ["frequencies"]:
        standard.table = draft.table  # the modes of the disk do not depend on it
    wrong = []
    for accuracy, run in (("draft", draft), ("standard", standard)):
        for prediction in run.plan.predictions:
            key = prediction.key
            if key == "end" and run.motion.rolling_outcome.name != "SETTLED":
                continue
            error = measured(run, reference, key)
            if not error / FACTOR < prediction.error < error * FACTOR:
                wrong.append(
                    f"{scene.name}, {accuracy}, {key}: predicted {prediction.error:.2g}, "
                    f"measured {error:.2g}"
                )
    return wrong


SCENES_LIKE_OTHERS = ("coin-polished", "glass", "polished", "wood-table")
"""Scenes with the models of `granite`, whose contact is rough and whose air film acts, and another
disk, table or height of the roughness; and one with the disk and the support of `light-plate`."""


@pytest.mark.slow
@pytest.mark.parametrize("support", ["patch", "free"])
def test_the_published_run_is_as_wrong_as_predicted(scene, support):
    assert disagreements(scene.replace(f"support.kind={support}")) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    sorted(set(shipped_scenes()) - {"published", *CHAOTIC_SCENES, *SCENES_LIKE_OTHERS}),
)
def test_every_shipped_scene_is_as_wrong_as_predicted(name):
    assert disagreements(load_scene(name)) == []


@pytest.fixture(scope="module")
def counted():
    """A standard run of the first 12 s of the published scene, with the sizes of all its
    computations."""
    sizes = {"stepped": [], "solved": []}

    class CountedBank(OscillatorBank):
        def advance(self, g, knots=None, out=None):
            sizes["stepped"].append((len(g) - 1, g.shape[1]))
            return super().advance(g, knots, out)

    def counted_force(self, t):
        sizes["solved"].append(len(np.atleast_1d(t)))
        return solved(self, t)

    solved = RigidMotion.at_and_force
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sonify.sound.response.OscillatorBank", CountedBank)
        patch.setattr(RigidMotion, "at_and_force", counted_force)
        scene = load_scene("published").replace("numerics.time_limit=12.0")
        run = prepared(scene, "standard")
        samples = run.sound.samples
    return SimpleNamespace(run=run, samples=samples, **sizes)


def test_only_the_modes_of_the_plan_are_stepped_and_only_while_there_is_sound(counted):
    voices = len(counted.run.plan.sounding)
    assert 0 < voices < len(counted.run.modes)
    assert {m for _, m in counted.stepped} == {voices}
    assert sum(n for n, _ in counted.stepped) == 2 * counted.samples


def test_no_mode_is_sought_above_what_is_heard(counted):
    assert counted.run.modes.frequency.max() < counted.run.plan.highest_mode
    low = load_scene("published").replace("audio.sample_rate=16000")
    assert plan_with_modes(low)[1].frequency.max() < 8000


def test_the_force_is_read_no_more_often_than_the_plan_says(counted):
    """The limit is one reading per INTERPOLATION_STRIDE samples, plus, at each jump, the samples within
    reach of a polynomial across it."""
    jumps = len(counted.run.motion.jumps.t)
    most = (
        counted.samples / INTERPOLATION_STRIDE
        + (jumps + 2) * (INTERPOLATION_NODES + 1) * INTERPOLATION_STRIDE
        + 1000
    )
    assert counted.run.renderer.sampler.evaluations <= most < 0.2 * counted.samples
    assert sum(counted.solved) <= most + 2000


@pytest.mark.slow
def test_the_motion_stops_where_the_plan_says(scene):
    assert list(modal.accuracy.ACCURACY_LEVELS) == list(ACCURACY_LEVELS)
    for accuracy, level in ACCURACY_LEVELS.items():
        wanted = scene.replace(f"numerics.accuracy={accuracy}")
        plan = plan_of(wanted)
        motion = simulate(wanted)
        assert motion.state[-1, 1] == pytest.approx(plan.final_inclination, rel=1e-9)
        turning = motion.state[-1, 7] / np.sin(motion.state[-1, 1]) / (2 * pi)
        assert abs(turning) == pytest.approx(
            steady_precession_frequency(scene.disk, plan.final_inclination), rel=0.05
        )
        assert abs(turning) > 0.95 * 20e3 * min(level.final_rate_factor, 25)


def test_what_the_scene_sets_stands(scene):
    plan = plan_of(
        scene.replace("numerics.tolerance=1e-10", "numerics.final_inclination=1e-3")
    )
    assert (plan.tolerance, plan.final_inclination) == (1e-10, 1e-3)
    assert plan_of(scene.replace("audio.sample_rate=8000")).highest_mode == 4000


def test_a_lower_rate_is_reached_earlier(scene):
    disk = scene.disk
    assert inclination_at_rate(disk, 4e3) == pytest.approx(
        25 * inclination_at_rate(disk, 20e3)
    )
    assert inclination_at_rate(disk, 1e12) == 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("name", ["published", "viscous"])
def test_the_time_that_is_left_is_that_of_the_solved_motion(name):
    scene = named_scene(name)
    motion = simulate(scene)
    for beta in (1e-4, 1e-6):
        when = motion.t[np.argmax(motion.state[:, 1] < beta)]
        left = plan_motion(scene).time_to_flat(beta)
        assert motion.t_end - when == pytest.approx(left, rel=0.1)


def test_a_mode_that_radiates_nothing_is_silent_in_the_plan(scene):
    """The first mode of the held disk moves along the rim; the sound of the two halves of the face
    cancels in every direction."""
    plan, modes = plan_with_modes(scene)
    quiet = set(range(len(modes))) - set(plan.sounding)
    assert quiet
    assert all(modes.parity[i] == "odd" for i in quiet)


@pytest.mark.slow
def test_the_reference_leaves_no_mode_out(scene):
    plan, modes = plan_with_modes(scene.replace("numerics.accuracy=reference"))
    assert plan.sounding == tuple(range(len(modes)))
    assert plan.predictions == ()


def test_loss_free_modes_are_planned_too(scene):
    plan, _ = plan_with_modes(
        scene.replace("material.loss_factor=0.0", "support.kind=free")
    )
    assert np.isfinite([p.error for p in plan.predictions]).all()


def test_modes_without_loss_and_without_error_stay_in_step(scene):
    modes = plan_with_modes(scene)[1].with_decay(0.0)
    exact = replace(modes, error=0 * modes.error)
    draft = scene.replace("numerics.accuracy=draft")
    loudness = np.ones(len(modes))
    assert predicted_sound_error(draft, exact, loudness).error == pytest.approx(
        10 ** (-ACCURACY_LEVELS["draft"].range_db / 20)
    )
    assert predicted_sound_error(draft, modes, loudness).error == pytest.approx(
        2**0.5, rel=1e-3
    )


def test_the_error_of_a_free_disk_is_that_of_its_support_whether_its_modes_pair_or_not(
    scene,
):
    free = scene.replace("support.kind=free")
    alone = replace(
        plan_with_modes(scene)[1], partner=np.full(len(plan_with_modes(scene)[1]), -1)
    )
    assert mode_frequency_error(free, alone) == pytest.approx(
        ACCURACY_LEVELS["standard"].free_error_share * alone.error
    )
    assert mode_frequency_error(scene, alone) == pytest.approx(
        ACCURACY_LEVELS["standard"].held_error_share * alone.error
    )


def test_a_scaled_sound_is_off_by_the_scale(tmp_path):
    noise = np.random.default_rng(1).standard_normal(48000).astype(np.float32)
    for name, factor in (("true", 1.0), ("louder", 1.1)):
        soundfile.write(tmp_path / f"{name}.wav", factor * noise, 48000, "FLOAT")
    for weighted in (True, False):
        found = audible_error(tmp_path / "louder.wav", tmp_path / "true.wav", weighted)
        assert found == pytest.approx(0.1, rel=1e-5)
    assert level_error(tmp_path / "louder.wav", tmp_path / "true.wav") == pytest.approx(
        np.log(1.1), rel=0.01
    )


def test_a_weighting_takes_what_is_not_heard_out_of_the_error(tmp_path):
    t = np.arange(48000) / 48000
    true = np.sin(2 * pi * 1000 * t)
    soundfile.write(tmp_path / "true.wav", true, 48000, "FLOAT")
    soundfile.write(
        tmp_path / "hum.wav", true + 0.1 * np.sin(2 * pi * 31.5 * t), 48000, "FLOAT"
    )
    plain, weighted = (
        audible_error(tmp_path / "hum.wav", tmp_path / "true.wav", w)
        for w in (False, True)
    )
    assert plain == pytest.approx(0.1, rel=1e-3)
    assert 20 * np.log10(weighted / plain) == pytest.approx(
        -39.4, abs=0.5
    )  # IEC 61672-1, table 3, at 31.5 Hz


def test_sounds_of_other_rates_are_not_compared(tmp_path):
    for rate in (8000, 16000):
        soundfile.write(tmp_path / f"{rate}.wav", np.zeros(100), rate, "FLOAT")
    with pytest.raises(ValueError, match="8000 Hz and 16000 Hz"):
        audible_error(tmp_path / "8000.wav", tmp_path / "16000.wav")


def test_decay_rates_may_be_measured_ones(scene):
    _, modes = plan_with_modes(scene)
    plan, measured_modes = plan_with_modes(
        scene.replace("material.decay_rates=[3.0, 2.5]")
    )
    assert measured_modes.decay_rate[:2].tolist() == [3.0, 2.5]
    assert np.array_equal(measured_modes.decay_rate[2:], modes.decay_rate[2:])
    assert "first 2 as measured" in next(
        d.choice for d in plan.decisions if d.subject == "decay of the modes"
    )


def test_more_decay_rates_than_modes_are_refused(scene):
    with pytest.raises(
        SceneError, match=r"material.decay_rates: 40 values, but only 9 modes"
    ):
        plan_with_modes(scene.replace(f"material.decay_rates={[1.0] * 40}"))


def test_modes_lose_to_the_air_as_well(scene):
    _, modes = plan_with_modes(scene.replace("support.kind=free"))
    loss = pi * modes.frequency * scene.material.loss_factor
    radiated = radiation_decay(modes, (TOP_FACE,))
    assert (
        np.abs(modes.decay_rate - loss - radiated) <= gamma(5) * modes.decay_rate
    ).all()
    assert (modes.decay_rate > 1.1 * loss).all()


def test_a_disk_that_loses_nothing_has_all_the_time_there_is(scene):
    """A motion without losses never ends, so its predicted error of the end is zero."""
    lossless = [
        f"friction.arm_{name}=0" for name in ("nutation", "rolling", "pivoting")
    ]
    still = scene.replace(*lossless, "numerics.time_limit=1")
    assert plan_motion(still).time_to_flat(1e-3) == inf
    assert plan_of(still).predictions[0].error == 0


def test_a_disk_that_moves_with_its_table_is_not_said_to_stay_rigid_on_a_plane(scene):
    """A table mode of 1 kg ends in two-way coupling; one of 1e6 kg never does."""
    surface = "surface={{kind='modes', modes=[{{order=2, frequency=600.0, damping_ratio=0.02, modal_mass={}}}]}}"
    moves, still = (
        with_table(plan_of(on), on, solve_table(on, plan_motion(on)))
        for on in (scene.replace(surface.format(mass)) for mass in (1.0, 1e6))
    )
    plane = with_table(plan_of(scene), scene, None).modelled[-1]
    assert plane == "A rigid disk rolls and slides on a rigid plane."
    assert plane in still.modelled
    assert plane not in moves.modelled
    modal_reaction = [
        next(line for line in plan.left_out if line.startswith("The sound of impacts"))
        for plan in (still, moves)
    ]
    assert (
        modal_reaction[1]
        == modal_reaction[0].removesuffix(".")
        + ", until two-way coupling with the table begins."
    )
    for plan, told in (
        (still, "rigid in the motion"),
        (moves, "rigid, until two-way coupling with the table begins"),
    ):
        assert told in [
            decision.choice for decision in plan.decisions if decision.subject == "disk"
        ]
    for plan in (still, moves):
        for sentence in (*plan.modelled, *plan.left_out):
            assert any(re.fullmatch(form, sentence) for form in sentence_forms())


def sentence_forms():
    """Return a regular expression for each template of a whole sentence in the table."""

    def texts(entry):
        if isinstance(entry, str):
            yield entry
        elif isinstance(entry, dict | tuple):
            for part in entry.values() if isinstance(entry, dict) else entry:
                yield from texts(part)

    for text in texts({**vars(sentences), "__doc__": "", "__builtins__": ""}):
        if re.fullmatch(r"[A-Z{].*\.", text):
            yield re.sub(r"\\{.*?\\}", ".*", re.escape(text))

"""Claim: a run of the published scene writes every file of the contract, verifies itself and judges
the paper's claims.

Source: the README's table of outputs; the claims of Kessler & O'Reilly (2002), sections 1, 7 and 8.
Oracle: the files, read back with independent readers; the known verdicts of the corrected model.
"""

import gzip
import json
import re
from dataclasses import replace
from html import unescape
from importlib import resources
from types import SimpleNamespace

import meshio
import numpy as np
import pytest
import soundfile
from full_disk import files_of_at_most
from page_arrays import decoded, decoded_track, with_gain
from paths import ROOT
from scipy.spatial import cKDTree

from dynamics import simulate
from sonify import load_scene, run, solve, summary, write
from sonify.claims.checks import Check, no_sample_clipped
from sonify.claims.details import details_in_words
from sonify.claims.finding import JUDGE_BY_KEY, Finding
from sonify.claims.finding_texts import texts_with
from sonify.claims.literature import motion_findings as literature_claims
from sonify.claims.paper_figures import paper_rows
from sonify.claims.provenance import depends_on
from sonify.claims.reference_scenes import is_paper_scene
from sonify.claims.sound import modes_take_little
from sonify.claims.surface_summary import complete_answers
from sonify.hearing.audio_source import Recording
from sonify.report import page as report
from sonify.report import page_data
from sonify.report import write as files
from sonify.studio.application import OPENING_RUN

FILES = {
    "sound.wav",
    "audible.wav",
    "pressure.wav",
    "stems",
    "spectrogram.png",
    "stems.png",
    "motion.png",
    "modes.png",
}
FILES |= {"motion.npz", "modes.json", "modes.vtu", "run.json", "report.html"}
STANDS = {
    "The disk repeatedly changes from rolling to sliding": True,
    "The normal force stays positive": True,
    "The frequency of the normal force rises as the disk declines": True,
    "The frequency of the normal force reaches f = 2.5 (36 Hz for the paper's disk)": True,
    "The energy falls monotonically": True,
    "Sliding dissipates more than rolling": True,
    "The motion of the centre diminishes until it is almost negligible": True,
    "The precession rate stays finite": False,
    "At least four modes of vibration are in the audible range": True,
    "The tone, the beats or the noise band rises": True,
    "In the last second the rising tone is the precession of the contact": True,
    "Until four seconds before the end the tone is the nutation, the frequency of the normal force": True,
    "The sound exceeds the threshold of hearing": True,
    "The rising tone can be heard": True,
    "In the last second, the sound of the disk is the vibration of its modes": False,
    "The rising tone lasts until the end of the motion": True,
    "The strongest steady tone keeps its pitch": True,
    "The strongest steady tone is a mode of the disk": True,
    "The modes hold too little energy to affect the motion": False,
    "The air film under the disk may be neglected": False,
    "What ends the motion is friction of rolling and pivoting": True,
    "With the air film included, the air would lift the disk": True,
    "With the friction of the scene, the precession rate grows as measured": False,
    "A Hertzian contact can cause the pivoting friction of the scene": False,
    "Slip dissipates most of the energy": False,
    "Transverse deformation of the disk alone makes the rising tone": False,
    "A single impact ends the motion": False,
    "Vibrations make the sound of the last second": False,
}
"""Verdicts of the corrected model on the paper's claims and on the sound."""
ABOUT = {"key": "x", "claim": "x", "unit": "1", "source": "-"}
"""Further fields of a finding."""
SHARES = [
    (0.9, 0.1, "undecided"),
    (0.8, 0.1, "yes"),
    (1.1, 0.1, "undecided"),
    (1.3, 0.1, "no"),
]
SHARES += [(0.9, 0.0, "yes"), (1.1, 0.0, "no")]
"""Ratio of modal to disk energy, relative error of the sound, and expected answer."""


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    return run(
        load_scene("published"), out=tmp_path_factory.mktemp("run") / "published"
    )


@pytest.fixture(scope="module")
def record(result):
    def refuse(value):
        raise AssertionError(f"{value} is not JSON")

    return json.loads((result.out / "run.json").read_text(), parse_constant=refuse)


def test_every_file_is_there_and_no_other(result):
    assert {p.name for p in result.out.iterdir()} == FILES
    stems = sorted(p.name for p in (result.out / "stems").iterdir())
    assert stems == ["heave.wav", "ringing_jumps.wav", "ringing_smooth.wav", "tilt.wav"]


def test_what_stands(result):
    assert {finding.claim: finding.holds for finding in result.findings} == STANDS


@pytest.mark.slow
def test_what_is_solved_needs_no_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = solve(
        load_scene("published").replace("numerics.time_limit=0.6", "name=cut"),
        accuracy="draft",
    )
    assert found.out is None
    assert list(tmp_path.iterdir()) == []
    written = write(found, tmp_path / "first")
    again = write(found, tmp_path / "again")
    stems = [f"stems/{path.name}" for path in (written.out / "stems").iterdir()]
    for name in ("sound.wav", "pressure.wav", "audible.wav", *stems):
        assert (written.out / name).read_bytes() == (again.out / name).read_bytes()
    pressure, _ = soundfile.read(again.out / "pressure.wav", dtype="float32")
    assert np.array_equal(pressure, found.sound.pressure.read())


def test_a_summary_is_a_row_of_plain_values_under_stable_keys(result, record):
    row = summary(result)
    assert all(isinstance(value, (str, float, bool)) for value in row.values())
    assert (row["outcome"], row["t_end"]) == ("SETTLED", result.motion.t[-1])
    for kind, answer in (("findings", "holds"), ("checks", "passed")):
        keys = [one["key"] for one in record[kind]]
        assert len(set(keys)) == len(keys)
        assert all(re.fullmatch("[a-z][a-z_]*", key) for key in keys)
        assert [one["value"] for one in record[kind]] == [row[key] for key in keys]
        assert [one[answer] for one in record[kind]] == [
            row[f"{key}_{answer}"] for key in keys
        ]
    assert {"contact_kept", "energy_balance", "seconds_motion"} <= row.keys()


def test_a_result_shows_itself_in_a_few_lines(result):
    assert len(repr(result).splitlines()) <= 6
    parts = (
        result,
        result.plan,
        result.motion,
        result.modes,
        result.sound,
        *result.findings,
        *result.checks,
    )
    assert max(len(line) for part in parts for line in repr(part).splitlines()) <= 160
    page = result._repr_html_()
    assert page.count("<audio") == 1
    assert len(page) < 300_000
    assert all(finding.claim[:20] in page for finding in result.findings)
    assert np.ptp(np.asarray(result.plot("motion"))) > 0
    with pytest.raises(
        ValueError,
        match="'song'; choose one of spectrogram, stems, motion, energy, modes",
    ):
        result.plot("song")


@pytest.mark.parametrize("t", [[[0.0, 1.0]], [-1.0], [float("nan")], [1e9]])
def test_a_motion_is_not_asked_for_what_is_no_time_of_it(result, t):
    with pytest.raises(ValueError, match="t must"):
        result.motion.at(t)


def test_run_json_says_what_was_done(result, record):
    assert record["scene"]["disk"]["mass"] == 0.4387
    assert record["outcome"]["name"] == "AT_REST"
    assert record["hand_over"]["reason"] == "SETTLED"
    assert len(record["findings"]) == len(STANDS)
    assert [check["passed"] for check in record["checks"]] == [True] * 8
    assert {"motion", "modes", "sound"} <= record["seconds"].keys()
    assert record["versions"]["numpy"] == np.__version__
    assert record["plan"]["modelled"]
    assert record["plan"]["left_out"]
    copy, rate = soundfile.read(result.out / "sound.wav")
    pressure, _ = soundfile.read(result.out / "pressure.wav")
    assert rate == record["sound"]["sample_rate"]
    assert np.abs(copy).max() == pytest.approx(
        np.abs(pressure).max() / record["sound"]["full_scale_pascal"], rel=1e-6
    )
    assert 20 * np.log10(copy.std() / pressure.std()) == pytest.approx(
        record["sound"]["gain_db"], abs=1e-3
    )


def test_the_files_are_read_by_others(result):
    motion = np.load(result.out / "motion.npz", allow_pickle=False)
    assert np.isin(motion["t"], result.motion.t).all()
    assert motion["state"].shape == (len(motion["t"]), len(motion["columns"]))
    assert len(motion["regime"]) == len(motion["t"])
    assert len(motion["transition_time"]) == len(result.motion.transitions)
    mesh = meshio.read(result.out / "modes.vtu")
    assert len(mesh.point_data) == len(result.modes.frequency)
    modes = json.loads((result.out / "modes.json").read_text())
    assert [mode["frequency"] for mode in modes["modes"]] == pytest.approx(
        result.modes.frequency.tolist()
    )


@pytest.mark.parametrize("most", [1, 7, 100])
def test_a_long_motion_is_written_at_few_of_its_times(
    result, tmp_path, monkeypatch, most
):
    monkeypatch.setattr(files, "MAX_MOTION_ROWS", most)
    files.write_motion(result.motion, tmp_path / "few.npz")
    few = np.load(tmp_path / "few.npz", allow_pickle=False)
    t = result.motion.t
    rows = np.flatnonzero(np.isin(t, few["t"]))
    assert len(rows) == len(few["t"]) <= most + 1 < len(t)
    assert (rows[0], rows[-1]) == (0, len(t) - 1)
    assert len(rows) == 2 or np.ptp(np.diff(rows)[:-1]) == 0
    assert np.array_equal(few["state"], result.motion.state[rows])
    assert np.array_equal(few["force"], result.motion.force(t[rows]))
    assert np.array_equal(few["regime"], result.motion.regime(t[rows]))


def test_the_page_needs_no_other_file(result):
    page = (result.out / "report.html").read_text()
    written = page.partition("<script>")[0]  # the script draws from these fields
    assert re.findall(r'src="(?!data:)', written) == []
    assert all(
        (result.out / name).is_file()
        for name in re.findall(r'href="(?!data:)([^"]*)"', written)
    )
    assert written.count("data:image/png") == 4
    assert written.count("data:audio/flac") == len(result.sound.stems)
    assert len(page.encode()) <= 6e6
    assert all(
        f"{finding.claim[:30]}" in page.replace("&#39;", "'")
        for finding in result.findings
    )


def test_every_verdict_says_its_number_its_error_and_what_it_depends_on(result):
    page = unescape((result.out / "report.html").read_text())
    answered = re.findall(
        r"<dt>(.*?)\?</dt><dd>(.*?)\.</dd>", page.partition('id="findings"')[0]
    )
    assert {q.lower(): a.lower() for q, a in answered} == {
        q: a.lower() for q, a in complete_answers(result.findings).items()
    }
    verdicts = re.findall(
        r"<details class=.*?</details>", page.partition('class="claims"')[2], re.DOTALL
    )[: len(result.findings)]
    assert texts_with("quotation").keys() <= JUDGE_BY_KEY.keys()
    assert len(verdicts) == len(result.findings)
    for finding, told in zip(result.findings, verdicts, strict=True):
        parts = (
            finding.claim,
            finding.measured,
            texts_with("quotation").get(finding.key, ("",))[0],
            finding.unit,
            details_in_words(finding),
        )
        assert all(part in told for part in parts)
        assert f"Depends on</dt><dd>{depends_on(finding.key)}" in told
        assert depends_on(finding.key).startswith("the ")
    assert (
        depends_on("tone_is_precession")
        == "the rising tone, tracked in the sound alone, the motion, the sound"
    )


@pytest.mark.parametrize(
    ("value", "margin", "told"),
    [
        (0.99953, 0.0088, "1.000 ± 0.009"),
        (879.6, 96.3, "880 ± 100"),
        (128.0, 1.0, "128 ± 1"),
        (0.25512, 0.0, "0.2551"),
        (2036.0, 7000.0, "2e+03 ± 7000"),
        (0.0, 0.2, "0 ± 0.2"),
    ],
)
def test_a_number_is_no_finer_than_its_margin_and_always_shown(value, margin, told):
    assert Finding(value=value, margin=margin, **ABOUT).measured == told


def test_the_paper_s_figures_stand_beside_ours_where_the_scene_is_the_paper_s(result):
    """The page compares the paper's printed values with those of the run for the paper's scene
    only.

    Section 7 prints chi, h (upside down), the density and 36 Hz; its figures begin at alpha = 1 and
    end with the flat disk.
    """
    rows = paper_rows(result.motion, result.findings)
    assert len(rows) == 15
    assert [row.key for row in rows if not row.holds] == []
    page = unescape((result.out / "report.html").read_text())
    assert all(row.claim in page.partition('id="paper"')[2] for row in rows)
    assert is_paper_scene(
        result.scene.replace("audio.distance=1.0", "numerics.accuracy=draft")
    )
    assert not is_paper_scene(result.scene.replace("friction.mu_static=0.4"))


def test_pictures_say_what_is_seen(result):
    """The alternative text of each picture states numbers of the result itself."""
    seen = re.findall(
        r'<img src="data:image/png[^"]*" alt="([^"]*)"',
        (result.out / "report.html").read_text(),
    )
    spectrogram, stems, motion, modes = map(unescape, seen)
    assert f"the motion ends at {result.sound.source_end:.2f} s" in spectrogram
    assert all(name.replace("_", " ") in stems for name in result.sound.stems)
    assert "the inclination goes from 32.7 to " in motion
    assert f"the weight is {result.motion.disk.weight:.3g} N" in motion
    assert f"{result.modes.frequency[0]:.0f} Hz" in modes
    page = (result.out / "report.html").read_text()
    assert all(
        f" {100 * share:.3g} %" in page for share in result.sound.low_frequency_shares
    ), "100 % is not 1e+02 %"


def page_parts(result):
    """Return the slow parts of the page, with black for every colour."""
    return {
        "motion": page_data.encoded_motion(result.motion),
        "sound": page_data.encoded_sounds(result.sound),
        "colours": bytes(3 * 256),
    }


@pytest.mark.parametrize(
    ("limit", "value"),
    [("MAX_PAGE_SOUND_DURATION", 2.0), ("MAX_PAGE_SOUND_SIZE", 200_000)],
)
def test_the_page_holds_the_end_of_a_long_sound(
    result, tmp_path, monkeypatch, limit, value
):
    """The decoded stems equal the last samples of the sound to the step of 16 bits."""
    monkeypatch.setattr(page_data, limit, value)
    parts = page_parts(result)
    data = page_data.page_data(result, parts)
    start = round(data["start"] * result.sound.sample_rate)
    assert start > 0
    for name, url in data["sounds"]["tracks"].items():
        samples = decoded_track(url)
        expected = result.sound.stems[name].read(start) / result.sound.full_scale
        assert np.abs(samples - expected.clip(-1, 1)).max() < 2**-15
    if limit == "MAX_PAGE_SOUND_DURATION":
        assert data["start"] == pytest.approx(result.sound.duration - value)
    else:
        assert sum(map(len, data["sounds"]["tracks"].values())) < value
    numbers = report.template_data(result, parts)
    report.write_page(result, tmp_path / "report.html", numbers)
    text = (tmp_path / "report.html").read_text()
    assert (
        f"The page contains the last {result.sound.duration - data['start']:.3g} s"
        in text
    )


def test_the_page_plays_the_stems(result):
    """The decoded stems at the true scale add up to sound.wav within rounding: 16 bits for each
    stem, 24 bits for the sum."""
    data = page_data.page_data(result, page_parts(result))["sounds"]
    tracks = list(map(decoded_track, data["tracks"].values()))
    whole = soundfile.read(result.out / "sound.wav")[0]
    assert np.abs(sum(tracks) - whole).max() < (len(tracks) / 2 + 1) * 2.0**-15
    assert data["full_scale"] == result.sound.full_scale


def test_the_page_has_the_gain_of_the_audible_copy(result):
    """The A-weighted pressure with the stored gain is audible.wav within 0.2 dB of its level,
    from 0.3 s on, when the filter has settled."""
    audible = page_data.encoded_sounds(result.sound)["content"]["audible"]
    rate = result.sound.sample_rate
    found = with_gain(audible, np.ravel(result.sound.pressure.read(0)), rate)
    expected = soundfile.read(result.out / "audible.wav")[0][:, 0]
    error = (found - expected)[round(0.3 * rate) :]
    assert np.sqrt(np.mean(error**2)) < 0.02 * np.sqrt(np.mean(expected**2))


def test_a_silent_sound_has_a_gain():
    """No sample of silence determines a gain."""
    silence = Recording(samples=np.zeros(480), sample_rate=48000)
    assert not page_data.audible_gain_db(silence, silence, 0.0).any()


def test_the_opening_run_of_the_studio_has_the_form_of_a_page(result):
    """`python -m sonify.studio.opening` renews it after a change of the form."""
    shipped = resources.files("sonify.studio") / OPENING_RUN
    opening = json.loads(gzip.decompress(shipped.read_bytes()))
    data = page_data.page_data(result, page_parts(result))
    assert opening["name"] == "toy"
    assert opening["record"]["headline"].endswith(".")
    assert set(opening) == {*data, "record"}
    for name in ("sounds", "disk", "motion", "lines"):
        assert set(opening[name]) == set(data[name])
    assert set(opening["sounds"]["audible"]) == set(data["sounds"]["audible"])


def test_a_fine_mesh_is_thinned_evenly():
    """The kept points are fewer, cover every part of the table and include its corners."""
    grid = np.stack(np.meshgrid(np.linspace(0, 3, 300), np.linspace(0, 1, 100)), -1)
    points = grid.reshape(-1, 2)
    kept = points[page_data.thinned(points, 1000)]
    assert 900 < len(kept) < 1200
    assert {(0.0, 0.0), (3.0, 0.0), (0.0, 1.0), (3.0, 1.0)} <= set(map(tuple, kept))
    assert cKDTree(kept).query(points)[0].max() < 2 * np.sqrt(3 / 1000)
    assert page_data.thinned(points[:50], 1000).tolist() == list(range(50))


def test_the_page_shows_the_motion(result):
    """The animation covers the whole motion.

    While the disk is audible, the contact turns by less than a fifth of a revolution between two
    instants.
    """
    data = page_data.page_data(result, page_parts(result))["motion"]
    t, precession = decoded(data["t"]), decoded(data["precession"])
    assert t[[0, -1]].tolist() == result.motion.t[[0, -1]].tolist()
    assert len(t) <= page_data.MAX_STORED_MOTION_TIMES + 2
    heard = t[:-1] < result.motion.t[-1] - 0.01
    assert np.abs(np.diff(precession))[heard].max() < 2 * np.pi / 5


@pytest.mark.parametrize(
    ("value", "within", "below"),
    [
        (1.0, True, True),
        (1.1, True, True),
        (1.11, False, False),
        (-9.0, False, True),
        (float("nan"), False, False),
        (float("inf"), False, False),
    ],
)
def test_a_check_has_two_sides_or_one_and_can_fail(value, within, below):
    about = {"key": "x", "name": "x", "expected": 1.0, "source": "-"}
    check = Check(value=value, tolerance=0.1 + 1e-12, **about)
    assert check.passed == within
    assert replace(check, one_sided=True).passed == below
    exact = replace(check, one_sided=True, tolerance=0.0)
    assert exact.expectation == "at most 1"


@pytest.mark.parametrize(
    ("peak", "finite", "passed"),
    [(0.0, True, True), (1.0, True, True), (1.001, True, False), (0.5, False, False)],
)
def test_a_clipped_or_endless_sample_is_found(peak, finite, passed):
    copy = SimpleNamespace(blocks=lambda: iter([np.array([[0.0], [-peak]])]))
    sound = SimpleNamespace(playback_copy=copy, is_finite=finite)
    assert no_sample_clipped(sound).passed == passed


@pytest.mark.parametrize(
    ("value", "margin", "answer"),
    [
        (2.1, 0.0, "yes"),
        (3.2, 0.0, "yes"),
        (3.21, 0.0, "no"),
        (2.1, 0.4, "undecided"),
        (1.7, 0.2, "undecided"),
        (1.0, 0.2, "no"),
        (3.3, 0.2, "undecided"),
        (3.7, 0.2, "no"),
        (float("inf"), 0.2, "no"),
    ],
)
def test_a_finding_is_undecided_where_its_margin_reaches_across_the_threshold(
    value, margin, answer
):
    """The range is 1.8 to 3.2; an undecided claim neither holds nor fails and may give a reason."""
    found = Finding(
        value=value, margin=margin, at_least=2.0, at_most=3.0, tolerance=0.2, **ABOUT
    )
    assert (found.verdict, found.answer) == (answer, answer)
    assert found.holds is {"yes": True, "no": False, "undecided": None}[answer]
    chaotic = replace(found, undecided_because="chaotic")
    assert (chaotic.verdict, chaotic.holds, chaotic.answer) == (
        "undecided",
        None,
        "undecided: chaotic",
    )


@pytest.mark.parametrize(
    "wrong", [{"value": float("nan")}, {"value": 1.0, "margin": float("nan")}]
)
def test_a_finding_without_a_number_is_refused(wrong):
    with pytest.raises(ValueError, match=r"x = .*nan.*: a finding needs a number"):
        Finding(**ABOUT, **wrong)


def test_terminal_page_and_record_give_one_verdict(result, record):
    """Terminal, page and record agree on every finding of the scene `published`; yes and no both
    occur."""
    told = {
        finding["key"]: (finding["verdict"], finding["holds"])
        for finding in record["findings"]
    }
    assert told == {
        finding.key: (finding.verdict, finding.holds) for finding in result.findings
    }
    page = (result.out / "report.html").read_text(encoding="utf-8")
    shown = re.findall(
        r'<details class="(\w+)"><summary>[^<]* <strong>(\w+)</strong>', page
    )
    words = {"yes": "agrees", "no": "differs", "undecided": "undecided"}
    assert shown == [
        (finding.verdict, words[finding.verdict]) for finding in result.findings
    ]
    assert record["headline"] in page
    assert record["headline"] in repr(result)


def test_of_a_motion_in_which_nothing_happens_nothing_is_claimed():
    """A motion of 0.01 s has no force peaks; a motion without resistance loses no energy."""
    short = load_scene("published").replace("numerics.time_limit=0.01")
    assert "rates_are_alike" not in {row.key for row in paper_rows(simulate(short), [])}
    free = "friction={mu_static=inf,mu_dynamic=inf}"
    assert literature_claims(simulate(short.replace(free))) == []


@pytest.mark.parametrize(("share", "error", "answer"), SHARES)
def test_modes_that_own_nearly_as_much_as_the_disk_decide_nothing(share, error, answer):
    """The modes hold `share` of the disk's energy over the last second, known within a factor of (1
    + error)^2."""
    t = np.linspace(0, 10, 1001)
    motion = SimpleNamespace(t=np.array([0.0, 10.0]), energy=lambda t: 1 + 0 * t)
    sound = SimpleNamespace(energy_time=t, energy=np.where(t > 9, share, 0.0))
    finding = modes_take_little(motion, sound, error)
    assert finding.answer == answer
    assert finding.value == pytest.approx(0.99 if share > 1 else 0.0)


def test_a_finding_states_its_range():
    finding = Finding(value=2.0, at_least=2.0, at_most=3.0, **ABOUT)
    assert finding.holds
    assert finding.expectation == "at least 2 and at most 3"
    above = replace(finding, at_least=-np.inf, tolerance=0.5)
    assert above.expectation == "at most 3 ± 0.5"
    assert replace(finding, tolerance=1e-6).expectation == finding.expectation


@pytest.fixture(scope="module")
def cut(tmp_path_factory):
    """A run that is cut off by its time limit."""
    scene = load_scene("published").replace("numerics.time_limit=0.6", "name=cut")
    return run(scene, out=tmp_path_factory.mktemp("cut"))


def test_a_motion_that_is_cut_off_says_so(cut):
    assert cut.passed
    assert cut.motion.outcome.name == "ROLLING_ON"
    assert any("time limit" in line for line in cut.plan.left_out)
    assert cut.sound.source_end == pytest.approx(0.6, abs=0.01)
    assert cut.sound.duration > 1.0  # the modes ring out


@pytest.mark.slow
def test_a_full_disk_leaves_no_half_wav(tmp_path):
    scene = load_scene("published").replace("numerics.time_limit=2.0", "name=full")
    with (
        files_of_at_most(200_000),
        pytest.raises(OSError, match="could not be written in full"),
    ):
        run(scene, tmp_path, "draft")
    assert [p.name for p in tmp_path.rglob("*") if p.is_file()] == []


def test_the_results_page_has_the_numbers_of_the_published_run(result):
    """The page states the run's level of the modes in the last second and the time before the end at
    which one-way coupling fails."""
    page = (ROOT / "docs" / "results.md").read_text(encoding="utf-8")
    found = {f.key: f.value for f in result.findings}
    level = re.search(
        r"relative to that of the rigid motion is\s+(\S+) ± 1\s+dB\(A\)", page
    ).group(1)
    assert found["modes_carry_the_end"] == pytest.approx(
        float(level.replace("−", "-")), abs=1.0
    )
    claim = "The modes hold too little energy to affect the motion"
    one_way_time = next(f.value for f in result.findings if f.claim == claim)
    seconds = re.search(
        r"In the last (\S+) s, however, the modes\s+would hold", page
    ).group(1)
    assert one_way_time == pytest.approx(float(seconds), abs=5e-4)

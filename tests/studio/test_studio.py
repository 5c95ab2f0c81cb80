"""Claim: the studio runs what the command line runs, one run after the other, for this machine only.

Source: the studio's how-to in docs/how_to.md. Oracle: the scene's own sentences, the pressure that
`sonify run` writes, and a worker whose calls the test controls.
"""

import json
import queue
import threading
import time
from contextlib import closing
from http.client import HTTPConnection
from random import Random
from types import SimpleNamespace
from urllib.parse import quote, urlsplit

import numpy as np
import pytest
import soundfile
from browser import CHROMIUM, until
from click.testing import CliRunner
from legal_scenes import any_document
from scipy.signal import sosfilt
from servers import address_of

from sonify import load_scene, shipped_scenes
from sonify.__main__ import main
from sonify.pipeline import TableModesCache
from sonify.plan.preflight import check_solvable_scene
from sonify.report.page import page_assets
from sonify.report.run_names import RunName, run_name
from sonify.runtime.workers import WorkerDiedError
from sonify.scene import from_document, scene_record
from sonify.scene_errors import InputError, SceneError
from sonify.sound.playback import a_weighting
from sonify.studio import application as studio_pages
from sonify.studio.controls import (
    _number_control,
    changed_scene,
    control_key_of_error,
    controls,
    slider_keys,
)
from sonify.studio.job_queue import Job, JobQueue
from sonify.studio.recording_summary import write_recording
from sonify.studio.slider_ends import slider_ends
from sonify.studio.worker import (
    PROGRESS_FILE,
    RECORDING_FILE,
    STREAM_FILE,
    ProgressFile,
    analyse_recording,
    run_scene,
    write_takes,
)

WRONG = "%7B%22disk.radius%22%3A-1%7D"
"""A value that no scene allows, quoted for an address."""


class ControlledWorker:
    """Worker whose calls wait for `release`; `began` holds their arguments."""

    def __init__(self):
        self.began = queue.Queue()
        self.release = threading.Semaphore(0)
        self.killed = threading.Event()

    def call(self, function, *arguments):
        self.began.put(arguments)
        while not self.release.acquire(timeout=0.02):
            if self.killed.is_set():
                raise WorkerDiedError("killed")
        return {"outcome": "settled", "arguments": len(arguments)}

    def kill(self):
        self.killed.set()


@pytest.fixture
def workers():
    return []


@pytest.fixture
def jobs(workers):
    def start():
        workers.append(ControlledWorker())
        return workers[-1]

    held = JobQueue(start, warm=False)
    yield held
    held.close()


class Client:
    """Sends requests to a studio; addresses without the token begin with `/`."""

    def __init__(self, port, token):
        self.port = port
        self.token = token

    def get(self, path, **headers):
        return self.request("GET", path, None, headers)

    def post(self, path, body):
        return self.request("POST", path, body, {})

    def request(self, method, path, body, headers):
        """Return status and text of the answer."""
        place = path if path.startswith("/") else f"/{self.token}/{path}"
        with closing(HTTPConnection("127.0.0.1", self.port, timeout=30)) as connection:
            connection.request(method, place, body, headers)
            answer = connection.getresponse()
            return answer.status, answer.read().decode()


@pytest.fixture
def client(monkeypatch, tmp_path, jobs):
    return Client(*served(monkeypatch, tmp_path / "runs", jobs))


def run_of(scene, values):
    """Return the body of the request for a run."""
    return json.dumps({"scene": scene, "values": values})


def job(tmp_path, name):
    return Job(tmp_path, print, name)


def test_an_address_without_the_token_does_not_exist(client):
    assert client.get("")[0] == 200
    assert client.get("/")[0] == 404
    assert client.get("/another-token/")[0] == 404
    assert client.post("/runs", run_of("published", {}))[0] == 404


def test_the_pages_of_finished_runs_are_those_of_the_read_only_server(client, tmp_path):
    (tmp_path / "runs" / "one").mkdir()
    record = {
        "scene": {"name": "one"},
        "outcome": {"sentence": "it lies"},
        "checks": [],
    }
    (tmp_path / "runs" / "one" / "run.json").write_text(json.dumps(record))
    (tmp_path / "runs" / "one" / "report.html").write_text(
        '<script type="application/json" class="run">{}</script>'
    )
    status, text = client.get("list")
    reader = client_of(read_only(tmp_path / "runs"))
    row = '<a href="runs/one/">one</a>'
    assert status == 200
    assert row in text
    assert row in reader.get("/list")[1]
    assert "shipped with the studio" in text
    assert "shipped with the studio" not in reader.get("/list")[1]
    assert client.get("data/one") == (200, "{}") == reader.get("/data/one")


def read_only(folder):
    """Return the port of the server of finished runs."""
    return urlsplit(address_of(studio_pages.serve, folder, "127.0.0.1", 0)).port


def client_of(port):
    return Client(port, "")


def test_the_read_only_server_starts_no_run(tmp_path):
    client = client_of(read_only(tmp_path))
    for path in ("/", "/runs/", "/list"):
        assert client.post(path, run_of("published", {}))[0] == 405
    for path in ("/recordings", "/takes", "/controls/toy", "/stream/1", "/session/1"):
        assert client.get(path)[0] == 404
    assert '<form id="scene-form"' not in client.get("/")[1]


def test_another_host_name_is_refused(client):
    assert client.get("", Host="elsewhere.example")[0] == 400


@pytest.mark.parametrize(
    "path", ["runs/%2e%2e/secret.txt", "session/%2e%2e/%2e%2e/etc/passwd"]
)
def test_no_file_outside_the_folder_is_sent(client, tmp_path, path):
    (tmp_path / "secret.txt").write_text("secret")
    assert client.get(path)[0] == 404


def test_the_page_loads_nothing_from_elsewhere(client):
    text = client.get("")[1]
    bundle = str(page_assets()["script"])  # its libraries name the sources of formulas
    assert bundle in text
    text = text.replace(bundle, "")
    assert "http://" not in text
    assert "https://" not in text
    assert '<option value="granite"' in text


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("disk.radius", -1),
        ("disk.radius", "wide"),
        ("audio.distance", 0.01),
        ("air.film", "thick"),
    ],
)
def test_a_wrong_value_has_the_sentence_of_the_command_line(client, key, value):
    with pytest.raises(SceneError) as error:
        load_scene("published").replace(f"{key}={value}")
    status, text = client.post("runs", run_of("published", {key: value}))
    assert status == 422
    assert json.loads(text) == {"error": str(error.value), "key": key}


@pytest.mark.parametrize(
    "name", ["nothing", "../published", "/etc/passwd", "published.toml"]
)
def test_only_shipped_scenes_are_read(client, name):
    status, text = client.post("runs", run_of(name, {}))
    assert status == 422
    assert "must be one of coin" in json.loads(text)["error"]
    with pytest.raises(SceneError, match="surface = "):
        changed_scene("published", {"surface": name})


def test_what_is_no_run_is_refused(client):
    assert client.post("runs", b"{")[0] == 400
    assert client.post("runs", b'{"scene": "published"}')[0] == 400


@pytest.mark.slow
@pytest.mark.parametrize("scene", ["published", "granite", "wood-table", "coin"])
def test_the_controls_have_the_values_and_limits_of_the_scene(scene):
    given = {control["key"]: control for control in controls(load_scene(scene))}
    assert given["disk.radius"]["value"] == load_scene(scene).disk.radius
    elevation = given["audio.elevation_deg"]
    assert (elevation["low"], elevation["high"], elevation["unit"]) == (
        0,
        90,
        "degrees",
    )
    assert [*given["air.film"]["choices"]] == ["auto", "none", "acts"]
    for control in given.values():
        if control["low"] is not None and control["value"] is not None:
            assert control["low"] <= control["value"] <= control["high"]


def test_the_tables_of_a_list_differ_in_words():
    (table,) = (c for c in controls(load_scene("toy")) if c["key"] == "surface")
    words = [*table["choices"].values()]
    assert len(set(words)) == len(words)
    assert table["choices"]["published"] == "rigid"
    assert table["choices"]["glass-plate"] == "that of glass-plate, 6 mm"
    sounding = "that of coin-wood, sounds without moving the disk"
    assert table["choices"]["coin-wood"] == sounding
    assert table["choices"]["wood-table"] == "that of wood-table"


SCENES_OF_SLIDERS = ("published", "wavy", "light-plate")
"""Scenes of the quick test: a rigid, a wavy and an elastic table."""


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in SCENES_OF_SLIDERS else pytest.mark.slow)
        for name in shipped_scenes()
    ],
)
def test_a_run_with_the_value_at_the_end_of_a_slider_is_accepted(name):
    """The ends are where the checks of the command line begin to refuse, or less."""
    for control in controls(load_scene(name)):
        if control["choices"]:
            continue
        assert control["low"] < control["high"]
        for end in (control["low"], control["high"]):
            scene = changed_scene(name, {control["key"]: end})
            assert check_solvable_scene(scene, None).name == name
            assert end == float(f"{end:.4g}")  # the page shows four digits


def test_every_slider_has_its_ends_in_the_file():
    """Those of a scene that is quickly checked are found again."""
    for name in shipped_scenes():
        scene = load_scene(name)
        written = {
            control["key"]: (control["low"], control["high"])
            for control in controls(scene)
            if not control["choices"]
        }
        assert list(written) == slider_keys(scene)
        if name == "published":
            assert slider_ends(scene) == written


@pytest.mark.slow
def test_the_end_of_a_slider_is_close_to_the_first_value_that_is_refused():
    """The radius may not exceed half the diameter of the mirror, nor the contact's fillet half the
    thickness of a coin."""
    ends = {
        scene: {control["key"]: control for control in controls(load_scene(scene))}
        for scene in ("toy", "coin")
    }
    mirror = load_scene("toy").surface.diameter
    assert ends["toy"]["disk.radius"]["high"] == pytest.approx(mirror / 2, rel=2e-3)
    fillet = load_scene("coin").contact.fillet
    assert ends["coin"]["disk.thickness"]["low"] == pytest.approx(2 * fillet, rel=2e-3)


def test_keys_without_effect_are_named_as_on_the_command_line(tmp_path, monkeypatch):
    """Both name them before they solve anything."""
    seen = []

    def stopped(scene, motion_plan, tools):
        seen.append(tools.stages)
        raise InputError("stopped")

    monkeypatch.setattr("sonify.pipeline.solve_stages", stopped)
    given = ["--set", "roughness.rms=1e-7", "--out", str(tmp_path / "command")]
    told = CliRunner().invoke(main, ["run", "published", *given])
    values = {"roughness.rms": 1e-7}
    document = changed_scene("published", values).document
    with pytest.raises(InputError, match="stopped"):
        run_scene(document, tmp_path / "studio", tmp_path)
    written = json.loads((tmp_path / PROGRESS_FILE).read_text("utf-8"))
    assert written["notices"] == ["unused: roughness.rms (no effect on this run)"]
    assert written["notices"][0] in told.stderr.splitlines()
    assert len(seen) == 2


def test_a_named_material_brings_its_density_and_a_table_its_section():
    scene = changed_scene(
        "published", {"material.name": "glass", "surface": "glass-plate"}
    )
    assert scene.disk.density == 2500.0
    assert scene.surface == load_scene("glass-plate").surface
    assert changed_scene("granite", {"roughness.rms": None}).roughness is None
    assert changed_scene("granite", {"roughness.rms": 1e-7}).roughness.rms == 1e-7


def test_a_table_brings_its_elasticity_at_an_elastic_contact():
    """Young's modulus of [contact] is that of the table; the name of the run mentions the
    table only."""
    scene = changed_scene("toy", {"surface": "wood-table"})
    wood = load_scene("wood-table").contact
    assert (scene.contact.young, scene.contact.poisson) == (wood.young, wood.poisson)
    assert scene.contact.fillet == load_scene("toy").contact.fillet
    named = run_name(scene_record(scene))
    assert named.words == "toy, on the table of wood-table"
    assert not any("contact" in change for change in named.changes)
    assert changed_scene("published", {"surface": "wood-table"}).contact.law == "rigid"


def test_modes_of_a_table_are_solved_once(monkeypatch):
    """Another table, another disk and another plan need other modes."""
    solved = []
    monkeypatch.setattr(
        "sonify.pipeline.solve_table", lambda *scene: solved.append(scene)
    )
    toy, plate = load_scene("toy"), load_scene("light-plate")
    wider = toy.replace("disk.radius=0.04")
    undecided = SimpleNamespace(lacks_surface_modes=True)
    decided = SimpleNamespace(lacks_surface_modes=False)
    cache = TableModesCache()
    for scene, plan in [(toy, undecided)] * 2 + [(plate, undecided), (toy, undecided)]:
        cache(scene, plan)
    assert solved == [(toy, undecided), (plate, undecided)]
    cache(wider, undecided)
    cache(wider, decided)
    assert len(solved) == 4


def test_the_first_results_of_a_recording_are_part_of_the_progress(tmp_path):
    stages = ProgressFile(tmp_path)
    stages.expect(120.0)
    stages.results_so_far({"summary": ["It stopped at 2.00 s."]})
    progress = json.loads((tmp_path / PROGRESS_FILE).read_text("utf-8"))
    assert progress["found"] == {"summary": ["It stopped at 2.00 s."]}
    assert (progress["expected"], progress["exceeded"]) == ("2 min", False)
    stages.expect(0.0)
    assert json.loads((tmp_path / PROGRESS_FILE).read_text("utf-8"))["exceeded"]


def test_the_sliders_do_the_experiments_of_the_classroom():
    """The scenes are those of the commands in docs/classroom.md, and the slider of the rolling
    friction reaches 20 times the value of the toy."""
    toy = load_scene("toy")
    rolling = "dissipation.contour_moment"
    assert changed_scene("toy", {rolling: 6.4e-5}).dissipation == (
        toy.replace(f"{rolling}=6.4e-5").dissipation
    )
    steeper = {"release.inclination_deg": 24, "release.omega": 16.78}
    assert changed_scene("toy", steeper).release == (
        toy.replace("release.inclination_deg=24", "release.omega=[0,2,16.78]").release
    )
    assert _number_control(toy, rolling).high >= 6.4e-5
    grip = changed_scene("published", {"friction.mu_static": 1.0}).friction
    assert (grip.mu_static, grip.mu_dynamic) == (1.0, pytest.approx(0.6))
    assert changed_scene("toy", {"roughness.rms_edge": 1e-7}).roughness.rms == 1e-9


@pytest.mark.parametrize(
    ("scene", "values", "words"),
    [
        ("glass", {}, "glass"),
        ("glass", {"roughness.rms_edge": 1e-7}, "glass, edge rougher"),
        ("granite", {"roughness.rms": 1e-8}, "granite, table smoother"),
        ("granite", {"roughness.rms": None}, "granite, without roughness of the table"),
        ("toy", {"roughness.rms": 1e-8}, "toy, table rougher"),
        ("toy", {"material.name": "wood"}, "toy, of wood"),
        ("toy", {"surface": "wood-table"}, "toy, on the table of wood-table"),
        ("wood-table", {"surface": "published"}, "wood-table, on a rigid table"),
        ("toy", {"air.film": "none"}, "toy, without air film"),
        ("published", {"release.omega": -20.0}, "published, spun faster"),
        ("published", {"friction.mu_static": 0.2}, "published, less friction"),
    ],
)
def test_a_run_is_named_in_words(scene, values, words):
    record = json.loads(json.dumps(scene_record(changed_scene(scene, values))))
    assert run_name(record).words == words


def test_every_legal_scene_has_a_name():
    """Lists of listeners and angular velocities are no numbers to compare."""
    named = 0
    for seed, name in enumerate(3 * [*shipped_scenes()]):
        try:
            drawn = from_document(any_document(Random(seed)) | {"name": name})
        except SceneError:
            continue  # impossible values
        assert run_name(scene_record(drawn)).words.startswith(name)
        named += 1
    assert named > len(shipped_scenes())
    rocking = load_scene("glass").replace("release.omega=[1.0, 4.5, 24.0]")
    changes = run_name(scene_record(rocking)).changes
    assert changes == ("release.omega = [1.0, 4.5, 24.0]",)


def test_a_record_of_another_version_is_named():
    """A key that one of the two lacks is no change; a scene of the user has its own name."""
    record = scene_record(load_scene("glass"))
    record["disk"].pop("thickness")
    record["friction"]["former_key"] = 3.0
    assert run_name(record).words == "glass"
    assert run_name({"name": "mine"}) == RunName(words="mine")
    assert run_name({"name": "glass"}) == RunName(words="glass")
    toy = scene_record(load_scene("toy"))
    assert run_name(toy | {"name": "mirror-base"}).words == "toy"


def test_a_sentence_belongs_to_the_control_that_it_names_first():
    assert (
        control_key_of_error("disk.radius = -1: must be greater than 0")
        == "disk.radius"
    )
    assert (
        control_key_of_error("surface.radius = 0.01: must be at least disk.radius")
        == "surface"
    )
    assert control_key_of_error("friction.arm_nutation = 1: too little") == ""
    assert control_key_of_error("") == ""


def test_two_jobs_are_done_one_after_the_other(jobs, workers, tmp_path):
    first = jobs.submit(job(tmp_path, "first"))
    second = jobs.submit(job(tmp_path, "second"))
    assert_soon(lambda: workers and workers[0].began.qsize() == 1)
    assert jobs.jobs_before(first) == 0
    assert jobs.jobs_before(second) == 1
    workers[0].release.release(2)
    assert second.ended.wait(5)
    assert [workers[0].began.get() for _ in range(2)] == [("first",), ("second",)]
    assert len(workers) == 1


def test_a_cancelled_job_ends_its_worker_and_the_next_one_has_another(
    jobs, workers, tmp_path
):
    first = jobs.submit(job(tmp_path, "first"))
    second = jobs.submit(job(tmp_path, "second"))
    third = jobs.submit(job(tmp_path, "third"))
    assert_soon(lambda: workers and workers[0].began.qsize() == 1)
    jobs.cancel(first)
    jobs.cancel(second)
    assert first.ended.wait(5)
    assert workers[0].killed.is_set()
    assert_soon(lambda: len(workers) == 2)
    workers[1].release.release()
    assert third.ended.wait(5)
    assert third.error is None
    assert workers[1].began.get() == ("third",)
    assert second.result is None


def assert_soon(condition, limit=5.0):
    """Assert that a condition becomes true within `limit` [s]."""
    end = time.monotonic() + limit
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)
    assert condition()


def served(monkeypatch, folder, jobs):
    """Return the port and the token of a studio that runs in a thread."""
    monkeypatch.setattr(studio_pages, "JobQueue", lambda: jobs)
    address = urlsplit(address_of(studio_pages.studio, folder, 0))
    return address.port, address.path.strip("/")


def test_a_reader_that_leaves_ends_its_run(monkeypatch, jobs, workers, tmp_path):
    port, token = served(monkeypatch, tmp_path, jobs)
    connection = HTTPConnection("127.0.0.1", port, timeout=30)
    body = run_of("published", {})
    connection.request("POST", f"/{token}/runs", body)
    answer = connection.getresponse()
    assert json.loads(answer.readline())["place"] == "studio-published"
    assert "frame-ancestors 'none'" in answer.headers["content-security-policy"]
    assert_soon(lambda: workers and workers[0].began.qsize() == 1)
    answer.close()
    connection.close()
    assert_soon(workers[0].killed.is_set)
    assert_soon(lambda: not (tmp_path / "studio-published").exists())


def test_a_port_in_use_is_one_line(monkeypatch, jobs, tmp_path):
    port, _ = served(monkeypatch, tmp_path, jobs)
    with pytest.raises(InputError, match=f"--port = {port}: unavailable"):
        studio_pages.studio(tmp_path, port, print)
    with pytest.raises(InputError, match="--port = 70000"):
        studio_pages.studio(tmp_path, 70_000, print)


def test_a_recording_is_limited_and_deleted(monkeypatch, client, workers):
    monkeypatch.setattr(studio_pages, "MAX_UPLOAD_BYTES", 1000)
    place = "recordings?scene=toy"
    assert client.post(place, bytes(1001))[0] == 413
    assert_soon(lambda: workers)
    workers[0].release.release()
    assert client.post("recordings?scene=toy&values=3", bytes(1000))[0] == 400
    assert (
        json.loads(client.post(f"{place}&values={WRONG}", b"")[1])["key"]
        == "disk.radius"
    )
    lines = client.post(f"{place}&from=1.5", bytes(1000))[1].splitlines()
    path, document, folder, span = workers[0].began.get()
    assert json.loads(lines[-1])["result"]["arguments"] == 4
    assert span == (1.5, np.inf)
    assert document["name"] == "toy"
    assert folder.is_dir()
    assert not path.exists()
    assert path.name == "recording"
    workers[0].release.release()
    name = quote("../New Recording 5's.m4a")
    client.post(f"{place}&name={name}", bytes(1000))
    path, _, folder, _ = workers[0].began.get()
    assert path == folder / "upload" / "_New Recording 5's.m4a"


def test_takes_are_those_of_the_command_line(client, workers, tmp_path):
    assert_soon(lambda: workers)
    workers[0].release.release()
    wanted = {"scene": "toy", "values": {}, "takes": 6, "last": 10, "audible": True}
    lines = client.post("takes", json.dumps(wanted))[1].splitlines()
    document, out, _, *settings = workers[0].began.get()
    assert json.loads(lines[-1])["place"] == out.name == "takes-toy"
    assert (document["name"], settings) == ("toy", [6, 10.0, True])
    for wrong, sentence in (
        ({"takes": 0}, "takes = 0: must be from 1 to 99"),
        ({"last": 0.1}, "last = 0.1: must be at least 0.5 s"),
        ({"values": {"disk.radius": -1}}, "disk.radius = -1"),
    ):
        status, text = client.post("takes", json.dumps(wanted | wrong))
        assert status == 422
        assert json.loads(text)["error"].startswith(sentence)
    assert client.post("takes", b"{}")[0] == 400
    brief = load_scene("published").replace(
        "numerics.time_limit=0.7", "numerics.accuracy=draft"
    )
    (tmp_path / "session").mkdir()
    folders = tmp_path / "takes", tmp_path / "session"
    written = write_takes(brief.document, *folders, 1, 0.5, False)
    assert written == {"files": ["published-01.wav"]}
    assert soundfile.info(tmp_path / "takes" / "published-01.wav").frames == 24_000


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("take.wav", "take.wav"),
        ("a/b\\c\0\n:.wav", "a_b_c___.wav"),
        ("..", "recording"),
        (" .hidden ", "hidden"),
    ],
)
def test_the_name_of_a_recording_is_a_file_name(given, name):
    assert studio_pages.file_name(given) == name


def test_a_long_name_keeps_its_end():
    given = "録音" * 100 + ".m4a"
    found = studio_pages.file_name(given)
    assert given.endswith(found)
    assert 190 < len(found.encode()) <= 200


def test_a_file_that_is_no_sound_is_one_line(tmp_path):
    """It has no advice on commands, and no path of this machine."""
    path = tmp_path / "upload" / "New Recording 5's.m4a"
    path.parent.mkdir()
    path.write_bytes(b"\0\0\0\x1cftypM4A " + bytes(100))
    told = analyse_recording(path, load_scene("toy").document, tmp_path)
    assert told["summary"] == [
        "New Recording 5's.m4a: this file is not a readable sound."
    ]
    assert told["details"] == told["pictures"] == told["runs"] == []
    assert not path.exists()


def test_the_sound_streams_while_it_is_rendered(tmp_path):
    """It is A-weighted; the header states the final length, and no block is louder than half of
    full scale."""
    rng = np.random.default_rng(1)
    blocks = [level * rng.uniform(-1, 1, 48000) for level in (0.001, 0.1, 0.01)]
    stages = ProgressFile(tmp_path)
    for block in blocks:
        stages.pressure(block.astype(np.float32), 48000, 3 * 48000)
    assert stages.streams
    samples, rate = soundfile.read(tmp_path / STREAM_FILE)
    assert rate == 48000
    assert len(samples) == 3 * 48000
    weighted = sosfilt(a_weighting(48000), np.concatenate(blocks)).reshape(3, 48000)
    loudest = np.abs(samples).reshape(3, 48000).max(axis=1)
    assert loudest[:2] == pytest.approx([0.5, 0.5], abs=1e-3)
    last = samples[2 * 48000 :]
    assert last == pytest.approx(
        weighted[2] * 0.5 / np.max(np.abs(weighted[1])), abs=2e-5
    )


@pytest.mark.slow
def test_a_recording_without_a_disk_has_a_plain_sentence(tmp_path):
    path = tmp_path / "recording.wav"
    noise = 0.01 * np.random.default_rng(1).standard_normal(48000 * 3)
    soundfile.write(path, noise, 48000, "PCM_16")
    noisy = path.read_bytes()
    toy = load_scene("toy").document
    outside = analyse_recording(path, toy, tmp_path, (5.0, np.inf))
    assert outside["summary"] == [
        "from = 5: must be less than the duration of the sound, 3 s"
    ]
    path.write_bytes(noisy)
    told = analyse_recording(path, toy, tmp_path)
    assert told["summary"] == ["No disk or coin that comes to rest was detected."]
    assert "no disk or coin that comes to rest was detected" in told["details"]
    assert str(tmp_path) not in " ".join(told["summary"] + told["details"])
    assert "spectrogram.png" in told["pictures"]
    assert not path.exists()


@pytest.mark.slow
def test_a_run_has_the_pressure_of_the_command_line(tmp_path):
    from sonify import run

    values = {"numerics.time_limit": 1.0, "disk.radius": 0.038}
    scene = changed_scene("published", values)
    (tmp_path / "session").mkdir()
    run_scene(scene.document, tmp_path / "studio", tmp_path / "session")
    run(
        load_scene("published").replace(
            *(f"{key}={value}" for key, value in values.items())
        ),
        tmp_path / "command",
        accuracy="draft",
    )
    here, there = (
        (tmp_path / name / "pressure.wav").read_bytes()
        for name in ("studio", "command")
    )
    assert here == there
    heard, _ = soundfile.read(tmp_path / "session" / STREAM_FILE)
    assert len(heard) == soundfile.info(tmp_path / "studio" / "audible.wav").frames
    progress = json.loads((tmp_path / "session" / PROGRESS_FILE).read_text("utf-8"))
    assert progress["heard"]


@pytest.fixture
def browser():
    """Return a browser; skip where none is installed."""
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as started:
        try:
            opened = started.chromium.launch(
                executable_path=CHROMIUM, args=["--no-sandbox"]
            )
        except playwright.Error:
            pytest.skip("no browser is installed")
        yield opened
        opened.close()


@pytest.mark.slow
def test_a_file_that_the_browser_cannot_decode_is_sent_as_it_is(
    monkeypatch, tmp_path, browser
):
    """The studio reads a table of phyphox, and says in one line what it cannot read."""
    jobs = JobQueue(warm=False)
    port, token = served(monkeypatch, tmp_path / "runs", jobs)
    rows = "".join(f"{k / 8000};{k * 37 % 251}\n" for k in range(24_000))
    (tmp_path / "take 1.csv").write_text("Time (s);Recording (a.u.)\n" + rows)
    (tmp_path / "New Recording 5.amr").write_bytes(b"#!AMR\n" + bytes(100))
    page = browser.new_page()
    page.set_default_timeout(300_000)
    page.goto(f"http://127.0.0.1:{port}/{token}/")
    for name, sentence in (
        ("take 1.csv", "3.000 s at 8000 Hz"),
        (
            "New Recording 5.amr",
            "New Recording 5.amr: this file is not a readable sound.",
        ),
    ):
        page.set_input_files("#file", tmp_path / name)
        page.wait_for_selector(f'#recording p:has-text("{sentence}")', state="attached")
    jobs.close()


class AnalysingWorker:
    """Worker that finds two runs in a recording, and one, ending at 2 s, in a part of it."""

    def __init__(self):
        self.spans = queue.Queue()

    def call(self, function, path, document, folder, span):
        assert function is analyse_recording
        self.spans.put(span)
        write_recording(path, folder / RECORDING_FILE, 2.0, span)
        ends = (2.0,) if span[1] < 10 else (2.0, 4.5)
        runs = [{"start": end - 1, "end": end, "high": end + 0.1} for end in ends]
        summary = [f"sentence {i}" for i in range(3)]
        return {"summary": summary, "runs": runs, "details": ["more"], "pictures": []}

    def kill(self):
        """Do nothing; no call lasts."""


@pytest.mark.slow
def test_a_recording_is_heard_beside_a_run_with_its_end_at_the_end_of_the_run(
    monkeypatch, tmp_path, browser
):
    """A click chooses one of several runs; details are folded; the switch changes to the
    recording while it plays."""
    worker = AnalysingWorker()
    jobs = JobQueue(lambda: worker, warm=False)
    port, token = served(monkeypatch, tmp_path, jobs)
    noise = 0.1 * np.random.default_rng(1).standard_normal(48_000 * 5)
    soundfile.write(tmp_path / "take.wav", noise, 48_000)
    page = browser.new_page()
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(f"http://127.0.0.1:{port}/{token}/")
    until(page, "Boolean(window.sonify) && sonify.spectrograms.length === 1")
    page.set_input_files("#file", tmp_path / "take.wav")
    until(page, "document.querySelectorAll('#recording .actions button').length === 2")
    until(page, "sonify.runs.length === 2")
    page.click("#recording .actions button >> nth=0")
    until(page, "document.querySelectorAll('#recording > p').length === 3")
    until(page, "sonify.runs.length === 2 && sonify.spectrograms.length === 2")
    assert [worker.spans.get() for _ in range(2)] == [(0.0, np.inf), (0.0, 3.1)]
    assert page.locator("#recording > p").all_inner_texts() == [
        f"sentence {i}" for i in range(3)
    ]
    assert not page.locator("#recording details p").is_visible()
    run, recording = page.evaluate("sonify.runs.map((run) => run.source_end)")
    assert recording == pytest.approx(run)
    assert page.evaluate("sonify.runs[1].start") == pytest.approx(run - 2.0)
    page.click("#play")
    until(page, "sonify.player.playing")
    page.click("input[name=run][value='1']")
    until(page, "sonify.player.run === 1 && sonify.player.playing")
    assert faults == []
    jobs.close()


@pytest.mark.slow
def test_an_analysis_and_takes_can_be_stopped(
    monkeypatch, tmp_path, jobs, workers, browser
):
    port, token = served(monkeypatch, tmp_path, jobs)
    (tmp_path / "take.csv").write_text("Time (s);Recording (a.u.)\n0;0\n")
    page = browser.new_page()
    page.goto(f"http://127.0.0.1:{port}/{token}/")
    until(page, "Boolean(window.sonify)")
    for button, state, sentence in (
        ("#recording-stop", "#recording-state", "The analysis was stopped."),
        ("#takes-stop", "#takes-state", "The takes were cancelled."),
    ):
        if button == "#recording-stop":
            page.set_input_files("#file", tmp_path / "take.csv")
        else:
            page.click("#takes-write")
        until(page, f"!document.querySelector('{button}').hidden")
        page.click(button)
        until(page, f"document.querySelector('{button}').hidden")
        assert page.inner_text(state) == sentence
    assert page.inner_text("#fault") == ""


@pytest.mark.slow
def test_a_browser_hears_a_run(monkeypatch, tmp_path, browser):
    """The page opens with a shipped run, plays a new one while it is rendered, shows it with the
    sound at the same time, and keeps run and values after a reload."""
    jobs = JobQueue()
    port, token = served(monkeypatch, tmp_path, jobs)
    page = browser.new_page()
    page.set_default_timeout(300_000)
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(f"http://127.0.0.1:{port}/{token}/")
    until(page, "Boolean(window.sonify) && sonify.spectrograms.length === 1")
    assert page.inner_text("#run-name") == "toy"
    page.select_option("#scene", "published")
    until(page, "document.getElementById('summary').textContent.includes('Kessler')")
    until(page, "Boolean(document.getElementById('control-friction.arm_rolling'))")
    page.fill('[id="control-release.inclination_deg"]', "5")
    page.fill('[id="control-roughness.rms"]', "0.1")
    with page.expect_response(lambda answer: "/stream/" in answer.url) as sound:
        page.click("#run")
    assert sound.value.status in (200, 206)
    until(page, "document.getElementById('run-name').textContent !== 'toy'")
    assert page.inner_text("#remarks") == (
        "unused: roughness.rms (no effect on this run)"
    )
    name = page.inner_text("#run-name")
    assert name.startswith("published, released flatter")
    until(page, "sonify.spectrograms.length === 1")
    assert page.evaluate("sonify.runs[0].duration") > 1.0
    assert page.locator("iframe").count() == 0
    assert page.inner_text("#compare") == "Compare with toy"
    page.click("#compare")
    until(page, "sonify.runs.length === 2 && sonify.spectrograms.length === 2")
    assert page.inner_text("#comparison").startswith("B lasts 81.5 s, ")
    assert not page.is_visible("#compare")
    page.click("#run-list input[name=b][value='']")
    until(page, "sonify.runs.length === 1")
    assert page.inner_text("#comparison") == ""
    page.reload()
    until(page, "Boolean(document.getElementById('control-friction.arm_rolling'))")
    assert page.input_value('[id="control-roughness.rms"]') == "0.1"
    until(page, "Boolean(window.sonify)")
    assert page.inner_text("#run-name") == name
    assert faults == []
    jobs.close()

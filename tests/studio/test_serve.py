"""Claim: `serve` delivers the files of its folder, in byte ranges on request, and no file outside
it.

Source: RFC 9110, section 14 (ranges); the README's command line. Oracle: the bytes of the files on
disk.
"""

import json
import os
import re
from contextlib import closing
from http.client import HTTPConnection
from types import SimpleNamespace
from urllib.parse import urlsplit

import pytest
from servers import address_of

from sonify.scene import load_scene, scene_record
from sonify.scene_errors import InputError
from sonify.studio.application import serve

RECORD = {
    "scene": {"name": "one"},
    "outcome": {"sentence": "it lies"},
    "headline": "The disk never leaves the table.",
}
PASSED = {
    "name": "no sample is clipped",
    "value": 0.9,
    "expected": 1.0,
    "tolerance": 0.0,
}
PASSED |= {"one_sided": True, "passed": True}
FAILED = PASSED | {
    "name": "energy adds up",
    "value": 2.5e-7,
    "expected": 0.0,
    "tolerance": 1e-8,
}
FAILED |= {"one_sided": False, "passed": False}
RECORD["checks"] = [PASSED]
NUMBERS = '{"name": "one"}'


@pytest.fixture(scope="module")
def root(tmp_path_factory):
    top = tmp_path_factory.mktemp("serve")
    root = top / "runs"
    for place in ("one", "deep/two"):
        (root / place).mkdir(parents=True)
        (root / place / "run.json").write_text(json.dumps(RECORD))
        (root / place / "report.html").write_text(
            f'<script type="application/json" class="run">{NUMBERS}</script>'
        )
    (root / "bad").mkdir()
    checks = {"checks": [PASSED, FAILED, FAILED | {"name": "mass", "value": "inf"}]}
    (root / "bad" / "run.json").write_text(json.dumps(RECORD | checks))
    (root / "one" / "sound.wav").write_bytes(bytes(range(200)))
    (root / "one" / "motion.npz").write_bytes(b"<script>")
    (root / "broken").mkdir()
    (root / "broken" / "run.json").write_text("{}")
    (top / "secret.txt").write_text("secret")
    (root / "one" / ".hidden").write_text("secret")
    (root / "one" / "link.txt").symlink_to(top / "secret.txt")
    return root


@pytest.fixture(scope="module")
def get(root):
    return client(root)


def client(root):
    """Return get(path, **headers) -> status, headers and body from a running server."""
    port = urlsplit(address_of(serve, root, "127.0.0.1", 0)).port

    def get(path, **headers):
        with closing(HTTPConnection("127.0.0.1", port, timeout=60)) as connection:
            connection.request("GET", path, headers=headers)
            answer = connection.getresponse()
            return SimpleNamespace(
                status=answer.status, headers=answer.headers, body=answer.read()
            )

    return get


def test_the_list_names_every_finished_run(get):
    page = get("/").body.decode()
    assert 'href="runs/one/"' in page
    assert 'href="runs/deep/two/"' in page
    assert page.count('<p class="basis">The disk never leaves the table.</p>') == 3
    assert "broken" not in page


def test_a_run_in_a_folder_whose_name_is_not_utf8_is_listed(tmp_path):
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    try:
        folder.mkdir()
    except (OSError, UnicodeError):
        pytest.skip("the file system requires names in Unicode")
    (folder / "run.json").write_text(json.dumps(RECORD))
    (folder / "report.html").touch()
    listed = client(tmp_path)("/")
    assert listed.status == 200
    assert '<p class="basis">caf\\xe9</p>' in listed.body.decode()
    assert 'href="runs/' not in listed.body.decode(), "it has no address"


def test_the_list_says_which_check_failed(get):
    page = get("/").body.decode()
    assert page.count("all 1 self-checks passed") == 2
    assert "FAILED: energy adds up: 2.5e-07, expected 0 ± 1e-08" in page
    assert "FAILED: mass: inf, expected 0 ± 1e-08" in page
    assert "FAILED: no sample" not in page


EVERY = ["/", "/runs/one/", "/runs/one", "/runs/one/sound.wav", "/nothing"]
EVERY += ["/list", "/opening", "/data/deep/two"]


@pytest.mark.parametrize("path", EVERY)
@pytest.mark.parametrize(
    "options", [{}, {"Host": "elsewhere.example"}, {"Range": "bytes=500-"}]
)
def test_every_response_forbids_what_a_page_does_not_need(get, path, options):
    """A page contains its scripts and pictures; it contacts no other server."""
    headers = get(path, **options).headers
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    allowed = dict(
        rule.split(" ", 1) for rule in headers["content-security-policy"].split("; ")
    )
    assert (
        allowed["default-src"]
        == allowed["base-uri"]
        == allowed["frame-ancestors"]
        == "'none'"
    )
    known = {"'none'", "'self'", "data:", "'unsafe-inline'", "'wasm-unsafe-eval'"}
    assert {word for words in allowed.values() for word in words.split()} == known
    assert "data:" in allowed["script-src"].split()  # the stretcher
    assert {"'self'", "data:"} <= set(allowed["media-src"].split())


def test_a_file_that_no_browser_shows_is_not_sent_as_a_page(get):
    assert (
        get("/runs/one/motion.npz").headers["content-type"]
        == "application/octet-stream"
    )


def test_a_page_and_its_files_are_those_on_disk(get, root):
    assert get("/runs/one/").body == (root / "one" / "report.html").read_bytes()
    assert get("/runs/one").headers["location"] == "/runs/one/"
    assert get("/runs/one/sound.wav").body == bytes(range(200))


def test_a_player_gets_the_piece_it_asks_for(get):
    piece = get("/runs/one/sound.wav", Range="bytes=50-59")
    assert (piece.status, piece.body) == (206, bytes(range(50, 60)))
    assert piece.headers["content-range"] == "bytes 50-59/200"
    assert get("/runs/one/sound.wav", Range="bytes=500-").status == 416


@pytest.mark.parametrize(
    "path",
    [
        "/runs/nothing/",
        "/runs/../secret.txt",
        "/runs/%2e%2e/secret.txt",
        "/runs/one/%2e%2e/%2e%2e/secret.txt",
        "/runs//etc/passwd",
        "/runs/one/link.txt",
        "/runs/one/.hidden",
        "/runs/one/%00",
        f"/runs/{'x' * 5000}",
        "/nothing",
        "/data/../secret.txt",
        "/data/%2e%2e/secret.txt",
        "/data/broken",
    ],
    ids=range(13),
)
def test_what_is_not_in_the_folder_does_not_exist(get, path):
    answer = get(path)
    assert answer.status == 404
    assert b"secret" not in answer.body


def test_the_data_of_a_run_are_those_of_its_page(get):
    answer = get("/data/deep/two")
    assert answer.body.decode() == NUMBERS
    assert answer.headers["content-type"] == "application/json"


def test_a_run_is_listed_in_words_with_its_values_length_date_and_picture(tmp_path):
    """The changed values are relative to the shipped scene; a run of another name has none."""
    glass = scene_record(load_scene("glass").replace("roughness.rms_edge=1e-7"))
    for name, scene in (("run", glass), ("own", glass | {"name": "own"})):
        (tmp_path / name).mkdir()
        sound = {"loudness_lufs": -23.0, "full_scale_pascal": 0.2}  # 80 dB - 23 dB
        record = RECORD | {"scene": scene, "motion": {"end": 109.17}, "sound": sound}
        (tmp_path / name / "run.json").write_text(json.dumps(record))
        (tmp_path / name / "report.html").touch()
    (tmp_path / "run" / "spectrogram.png").touch()
    os.utime(tmp_path / "run" / "run.json", (0, 86_400 * 365))
    page = client(tmp_path)("/").body.decode()
    assert '<a href="runs/run/">glass, edge rougher</a>' in page
    assert "<p>roughness of the edge 0.1 µm</p>" in page
    assert '<a href="runs/own/">own</a>' in page
    assert page.count("<td>109 s</td>") == page.count("<td>57 dB</td>") == 2
    assert re.search("<td>197[01]-", page)
    assert page.count('<img src="runs/') == 1
    assert '<img src="runs/run/spectrogram.png"' in page


def test_a_name_that_is_not_this_machine_is_refused(get):
    assert get("/", Host="elsewhere.example").status == 400


def test_a_folder_or_port_that_cannot_be_had_is_one_line(root):
    with pytest.raises(InputError, match="no such folder"):
        serve(root / "nowhere", "127.0.0.1", 0, print)
    with pytest.raises(InputError, match="--port"):
        serve(root, "127.0.0.1", 70_000, print)

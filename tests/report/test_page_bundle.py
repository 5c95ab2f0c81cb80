"""Claim: the script and the style of the page are reproduced bit for bit from their sources and the
locked libraries.

Source: sonify/report/web/package-lock.json. Oracle: a fresh build. Skipped if npm is missing.
"""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

import sonify.report

REPORT = Path(sonify.report.__file__).parent
NPM = shutil.which("npm")


@pytest.mark.slow
@pytest.mark.skipif(NPM is None, reason="needs npm")
def test_the_bundle_is_what_its_sources_build(tmp_path):
    web = tmp_path / "web"
    shutil.copytree(REPORT / "web", web, ignore=shutil.ignore_patterns("node_modules"))
    subprocess.run(
        [NPM, "ci", "--ignore-scripts", "--no-audit", "--no-fund"],
        cwd=web,
        check=True,
        timeout=300,
    )
    subprocess.run(
        ["node", "build.mjs", str(tmp_path)], cwd=web, check=True, timeout=300
    )
    for name in ("page.js", "page.css", "page.licenses.txt"):
        assert (tmp_path / name).read_bytes() == (
            REPORT / "templates" / name
        ).read_bytes(), name


def test_the_page_says_under_which_licences_its_libraries_stand():
    text = (REPORT / "templates" / "page.licenses.txt").read_text(encoding="utf-8")
    for name in ("three", "uplot", "fft.js", "signalsmith-stretch"):
        assert f"{name} " in text
    assert text.count("MIT") >= 4


def test_the_stretcher_is_in_the_bundle_once_as_text():
    """The page loads the stretcher on demand from an address of its own; a second copy would waste
    110 kB."""
    text = (REPORT / "templates" / "page.js").read_text(encoding="utf-8")
    assert len(re.findall(r"registerProcessor\(", text)) == 1

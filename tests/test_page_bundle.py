"""Claim: the script and the style of the page are what their sources and the locked libraries
build, bit for bit.

Source: sonify/report/web/package-lock.json. Oracle: building them anew. Skipped where there is no
npm."""

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
        [NPM, "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=web, check=True, timeout=300
    )
    subprocess.run(["node", "build.mjs", str(tmp_path)], cwd=web, check=True, timeout=300)
    for name in ("page.js", "page.css", "page.licenses.txt"):
        assert (tmp_path / name).read_bytes() == (REPORT / "templates" / name).read_bytes(), name


def test_the_page_says_under_which_licences_its_libraries_stand():
    text = (REPORT / "templates" / "page.licenses.txt").read_text(encoding="utf-8")
    for name in ("three", "uplot", "fft.js", "signalsmith-stretch"):
        assert f"{name} " in text
    assert text.count("MIT") >= 4


def test_the_stretcher_is_in_the_bundle_once_as_text():
    """It is loaded when it is needed, by an address of its own; a second copy of its 110 kB would
    be dead weight."""
    text = (REPORT / "templates" / "page.js").read_text(encoding="utf-8")
    assert len(re.findall(r"registerProcessor\(", text)) == 1

"""Claim: the digest of the sources changes with their content and names, and with nothing else.

Source: dynamics/source_digest.py. Oracle: folders that differ in one respect.
"""

import pytest

from dynamics.source_digest import source_digest

FILES = {"a/x.py": "1\n", "a/sub/y.py": "2\n", "b/z.py": "3\n"}


def digest(root, files=FILES, newline="\n"):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.replace("\n", newline).encode())
    return source_digest(root, ("a", "b"))


def test_place_line_ends_and_other_files_do_not_matter(tmp_path):
    one = digest(tmp_path / "one")
    assert digest(tmp_path / "two", newline="\r\n") == one
    assert digest(tmp_path / "three", FILES | {"c/q.py": "", "a/x.txt": "7"}) == one


@pytest.mark.parametrize("change", [{"a/x.py": "10\n"}, {"a/w.py": ""}])
def test_content_and_names_matter(tmp_path, change):
    assert digest(tmp_path / "one") != digest(tmp_path / "two", FILES | change)

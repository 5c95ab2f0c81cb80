"""Claim: the form of a table follows from its header, and its text from its bytes.

Source: sonify/hearing/phyphox.py. Oracle: headers written out; test_phyphox_tables.py reads whole
tables.
"""

import codecs

import pytest

from sonify.hearing.phyphox import (
    TableForm,
    decoded_text,
    may_contain_table,
    table_form,
)


@pytest.mark.parametrize(
    ("header", "form"),
    [
        ("Time (s),Recording (a.u.)", TableForm(",", 2, 0, 1, 1.0)),
        ('"Zeit (ms)"\t"Aufnahme"', TableForm("\t", 2, 0, 1, 1e3)),
        ("Amplitude;t [s];x", TableForm(";", 3, 1, 0, 1.0)),
    ],
)
def test_a_header_has_a_column_of_times_and_one_of_amplitudes(header, form):
    assert table_form(header + "\n1,2\n") == form


def test_bytes_of_text_are_decoded_and_others_are_not():
    for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1"):
        assert decoded_text("é,1\n".encode(encoding)) == "é,1\n"
    assert decoded_text(b"\x00\x01") is None
    assert decoded_text(b"") is None
    assert may_contain_table(codecs.BOM_UTF16_LE + b"a\0")
    assert not may_contain_table(b"fLaC\0\0")

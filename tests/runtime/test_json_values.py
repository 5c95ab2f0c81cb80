"""Claim: JSON files hold every value that NumPy can return, and strict JSON only.

Source: RFC 8259, which knows no NaN and no infinity; the scalar types of NumPy (`np.sctypeDict`).
Oracle: `json.loads` of the written file with a hook that refuses non-finite constants; the exact
conversion by `int`, `float` and `complex`.
"""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as st_numpy

from sonify.runtime.json_values import json_safe, write_json

SCALAR_TYPES = sorted(
    {kind for kind in np.sctypeDict.values() if kind is not np.object_},
    key=lambda kind: kind.__name__,
)
"""Types of NumPy scalars; an object is no NumPy scalar."""


def refuse(constant):
    raise AssertionError(f"{constant} is not JSON")


def stored(value, folder):
    """Return what a reader finds in a file into which the value was written."""
    path = folder / "value.json"
    write_json(value, path)
    return json.loads(path.read_text(encoding="utf-8"), parse_constant=refuse)


def examples(kind):
    """Return values of a type: zero, extreme and non-finite ones."""
    if kind is np.bool_:
        return [kind(False), kind(True)]
    if issubclass(kind, (np.datetime64, np.timedelta64)):
        return [kind(5, unit) for unit in ("s", "ns", "D", "Y")] + [kind("NaT")]
    if issubclass(kind, np.integer):
        limits = np.iinfo(kind)
        return [kind(0), kind(limits.min), kind(limits.max)]
    if issubclass(kind, np.floating):
        limits = np.finfo(kind)
        finite = [kind(0), kind(0.1), limits.tiny, limits.max, limits.min]
        return finite + [kind(name) for name in ("nan", "inf", "-inf")]
    if issubclass(kind, np.complexfloating):
        return [kind(1 - 2j), kind(complex("nan")), kind(complex("inf"))]
    if kind is np.void:
        pair = np.array([(1, 0.5)], dtype=[("a", "i4"), ("b", "f4")])[0]
        return [pair, np.void(b"ab")]
    return [kind("café") if kind is np.str_ else kind(b"caf\xe9")]


@pytest.mark.parametrize("kind", SCALAR_TYPES, ids=lambda kind: kind.__name__)
def test_every_scalar_of_numpy_is_written(kind, tmp_path):
    for value in examples(kind):
        alone = stored(json_safe(value), tmp_path)
        nested = {"list": [value, (value,)], "array": np.array([value] * 2)}
        found = stored(json_safe(nested), tmp_path)
        assert found["list"] == [alone, [alone]]
        assert len(found["array"]) == 2
        if issubclass(kind, np.timedelta64):
            assert alone == str(value)
        elif issubclass(kind, (np.integer, np.bool_)):
            assert alone == value
            assert type(alone) is (bool if kind is np.bool_ else int)
        if issubclass(kind, np.floating):
            assert alone == float(value) or alone == str(value)
            assert isinstance(alone, float) == bool(np.isfinite(float(value)))
        if issubclass(kind, np.complexfloating) and np.isfinite(value):
            assert complex(*alone) == value
        if issubclass(kind, np.str_):
            assert alone == value


def test_values_without_plain_numbers_become_text(tmp_path):
    found = stored(
        json_safe([np.datetime64("2020-01-02"), np.bytes_(b"caf\xe9"), b"a", 1 + 0j]),
        tmp_path,
    )
    assert found == ["2020-01-02", "caf\\xe9", "a", [1.0, 0.0]]
    keys = {np.int64(3): 1, np.str_("a"): 2, np.float64("inf"): 3, np.float16(0.5): 4}
    assert stored(json_safe(keys), tmp_path) == {"3": 1, "a": 2, "inf": 3, "0.5": 4}


@settings(max_examples=200, deadline=None)
@given(
    st_numpy.arrays(
        st_numpy.scalar_dtypes(),
        st.one_of(st.just(()), st_numpy.array_shapes(max_dims=2, max_side=3)),
    )
)
def test_arrays_of_any_type_and_shape_are_written(tmp_path_factory, values):
    found = stored(json_safe({"values": values}), tmp_path_factory.getbasetemp())
    if values.dtype.kind in "iub":
        assert np.array_equal(np.array(found["values"], values.dtype), values)
    if values.ndim:
        assert len(found["values"]) == len(values)


def test_numbers_that_are_not_finite_are_refused_unless_made_safe(tmp_path):
    """Without `json_safe`, plain values are written, and a non-finite one is an error."""
    assert stored([np.bool_(True), np.float32(0.5)], tmp_path) == [True, 0.5]
    for value in (np.float32("nan"), np.float64("inf"), np.longdouble("-inf"), np.nan):
        with pytest.raises(ValueError, match="not JSON compliant"):
            write_json({"value": value}, tmp_path / "bad.json")
    assert not (tmp_path / "bad.json").exists()
    with pytest.raises(TypeError, match="object has no representation"):
        write_json(object(), tmp_path / "bad.json")

"""Plain values for JSON, which knows neither NumPy scalars nor non-finite numbers."""

import json
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from sonify.runtime.files import write_text


def write_json(value: Any, path: Path) -> None:
    """Write strict JSON; NumPy scalars and arrays are written as plain values.

    Raises ValueError if a value is not finite."""
    text = json.dumps(value, indent=1, allow_nan=False, default=plain_value)
    write_text(text + "\n", path)


def json_safe(value: Any) -> Any:
    """Return nested values as values that JSON can represent.

    NumPy scalars and arrays become plain values (`plain_value`), and non-finite floats
    strings."""
    if isinstance(value, dict):
        return {json_safe(key): json_safe(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [json_safe(item) for item in value]
    if isinstance(value, (np.generic, np.ndarray, complex, bytes)):
        return json_safe(plain_value(value))
    return str(value) if isinstance(value, float) and not isfinite(value) else value


def plain_value(value: Any) -> Any:
    """Return a NumPy scalar as a plain Python value, and an array as a list of scalars.

    A complex number becomes a list [real, imaginary]; dates, durations and bytes become
    strings, and so does a number that no Python float can represent. Raises TypeError
    for other types."""
    if isinstance(value, np.ndarray):
        return list(value) if value.ndim else value[()]
    if isinstance(value, (np.datetime64, np.timedelta64, np.str_)):
        return str(value)
    if isinstance(value, np.bool_):
        return bool(value)
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, np.floating):
        number = float(value)
        return str(value) if np.isfinite(value) and not isfinite(number) else number
    if isinstance(value, (complex, np.complexfloating)):
        return [value.real, value.imag]
    if isinstance(value, bytes):
        return value.decode("utf-8", "backslashreplace")
    if isinstance(value, np.void):
        return [value[name] for name in value.dtype.names or ()] or value.item()
    raise TypeError(f"{type(value).__name__} has no representation in JSON")

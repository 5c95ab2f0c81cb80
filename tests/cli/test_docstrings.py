"""Claim: everything that `dynamics`, `modal` and `sonify` export is documented in numpydoc form,
and the examples in all docstrings of the three packages run and print the output shown.

Source: the docstrings; numpydoc's rules of validation. Oracle: numpydoc; the output written in the
examples.
"""

import ast
import dataclasses
import doctest
import importlib
import inspect
import re
from functools import cached_property
from types import FunctionType

import pytest
from numpydoc.validate import validate
from paths import ROOT

import dynamics
import modal
import sonify

PACKAGES = (dynamics, modal, sonify)
OPTIONAL = {
    "GL01",  # the summary begins on the line of the quotes
    "GL02",  # the quotes end a docstring of one line
    "ES01",  # no extended summary
    "EX01",  # no example of its own for every method
    "SA01",  # no section See Also
    "SA04",
    "SS06",  # a summary of two lines
}
"""Rules of numpydoc that a docstring need not keep."""
MODULES = [
    ".".join(file.relative_to(ROOT).with_suffix("").parts)
    for package in PACKAGES
    for file in sorted((ROOT / package.__name__).rglob("*.py"))
    if ">>> " in file.read_text("utf-8")
]
EXPORTED = [
    getattr(package, name)
    for package in PACKAGES
    for name in package.__all__
    if name != "__version__"  # a string
]


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_a_module(name):
    result = doctest.testmod(importlib.import_module(name), raise_on_error=False)
    assert result.attempted > 0
    assert result.failed == 0


def own_classes(kind: type) -> list[type]:
    """Return a class and its base classes within the three packages."""
    names = {package.__name__ for package in PACKAGES}
    return [base for base in kind.__mro__ if base.__module__.split(".")[0] in names]


def documented_fields(kind: type) -> set[str]:
    """Return the fields of a class that have a docstring of their own."""
    (body,) = ast.parse(inspect.getsource(kind)).body
    return {
        field.target.id
        for field, below in zip(body.body, body.body[1:], strict=False)
        if isinstance(field, ast.AnnAssign)
        and isinstance(below, ast.Expr)
        and isinstance(below.value, ast.Constant)
    }


def is_documented_elsewhere(owner: type, name: str) -> bool:
    """Return True for a method that the protocol `Motion` documents."""
    motion = dynamics.Motion
    return owner is not motion and any(name in vars(b) for b in own_classes(motion))


def public_parts(kind: type) -> set[str]:
    """Return the names of the public methods and properties of a class."""
    return {
        name
        for base in own_classes(kind)
        for name, part in vars(base).items()
        if name[0] != "_"
        and isinstance(part, FunctionType | property | cached_property)
        and not is_documented_elsewhere(kind, name)
    }


def complaints(thing) -> list[str]:
    """Return what numpydoc finds wrong with an exported class or function and its public parts."""
    optional = set(OPTIONAL)
    if inspect.isclass(thing):
        optional |= {
            "PR01",
            "PR02",
        }  # parameters are those of fields, or of Enum and Protocol
    names = [""]
    if inspect.isclass(thing):
        names += [f".{name}" for name in sorted(public_parts(thing))]
    found = []
    for name in names:
        result = validate(f"{thing.__module__}.{thing.__qualname__}{name}")
        allowed = OPTIONAL if name else optional
        found += [
            f"{thing.__qualname__}{name}: {e}"
            for e in result["errors"]
            if e[0] not in allowed
        ]
    return found


@pytest.mark.parametrize("thing", EXPORTED, ids=lambda thing: thing.__name__)
def test_what_is_exported_has_a_numpydoc_docstring_with_an_example(thing):
    assert complaints(thing) == []
    assert ">>> " in thing.__doc__


@pytest.mark.parametrize(
    "kind",
    [thing for thing in EXPORTED if dataclasses.is_dataclass(thing)],
    ids=lambda k: k.__name__,
)
def test_every_field_of_an_exported_record_is_documented(kind):
    own = set()
    listed = set()
    for base in own_classes(kind):
        own |= documented_fields(base)
        listed |= set(re.findall(r"\w+", base.__doc__.partition("----")[2]))
    names = {field.name for field in dataclasses.fields(kind)}
    assert names <= own | listed

"""Docstrings: complete, and their examples run."""

import doctest
import importlib
import pkgutil
import sys
from pathlib import Path

import pytest

import libration as lb
from ufuncs import ALL


@pytest.mark.parametrize("ufunc", ALL)
def test_ufuncs_are_documented_and_their_examples_run(ufunc):
    text = ufunc.__doc__
    for section in ("Parameters", "Returns", "Notes", "References", "Examples"):
        assert f"\n{section}\n{'-' * len(section)}\n" in text
    assert "Accuracy: " in text
    test = doctest.DocTestParser().get_doctest(text, {}, ufunc.__name__, None, None)
    found = doctest.DocTestRunner().run(test)
    assert found.attempted >= 2 and found.failed == 0


MODULES = ["libration"] + [
    it.name
    for it in pkgutil.walk_packages(lb.__path__, "libration.") if it.name != "libration._native"
]


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_modules_run(name):
    importlib.import_module(name)
    if name == "libration.sweeps":
        pytest.importorskip("zarr", minversion="3")
    assert doctest.testmod(sys.modules[name]).failed == 0


def test_all_names_are_there():
    for module in (lb, lb.special, lb.figure, lb.questions):
        assert (
            module.__all__ == sorted(module.__all__, key=str.swapcase)
            or module.__all__ == sorted(module.__all__)
        )
        assert all(hasattr(module, name) for name in module.__all__)


@pytest.mark.parametrize("name", ["README.md", "python/README.md"])
def test_examples_of_the_readmes_run(name):
    pytest.importorskip("dask.array")
    found = doctest.testfile(str(Path(__file__).parents[2] / name), module_relative=False)
    assert found.attempted >= 4 and found.failed == 0

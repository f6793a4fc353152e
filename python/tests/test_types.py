"""The types of calls, as mypy and pyright see them, each where it is installed."""

import subprocess
import sys
from pathlib import Path

import pytest

import libration as lb
from ufuncs import ALL

FILE = Path(__file__).with_name("types_of_calls.py")
CACHE = Path(__file__).parents[2] / "target/mypy"


def test_mypy():
    api = pytest.importorskip("mypy.api")
    package = Path(lb.__file__).parent
    # Among installed packages mypy takes the neighbours of this one for modules of the user.
    sources = [] if "site-packages" in package.parts else [str(package)]
    report, errors, status = api.run(["--strict", f"--cache-dir={CACHE}", str(FILE), *sources])
    assert status == 0, report + errors


def test_the_stub_has_what_the_compiled_module_has(tmp_path):
    pytest.importorskip("mypy.stubtest")
    # In the annotations of NumPy 1 arrays and numbers overlap, and so do the calls of ufuncs.
    pytest.importorskip("numpy", "2.0")
    # The stub types the calls of ufuncs, and has aliases.
    others = [it.__name__ for it in ALL] + ["_.*"]
    allowed = tmp_path / "allowed"
    allowed.write_text("".join(f"libration._native.{it}\n" for it in others), encoding="utf-8")
    words = ["--concise", "--allowlist", allowed, "--ignore-disjoint-bases"]
    found = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "libration._native", *words],
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert found.returncode == 0, found.stdout + found.stderr


def test_pyright():
    pytest.importorskip("pyright")
    found = subprocess.run(
        [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, FILE],
        capture_output=True,
        text=True,
    )
    assert found.returncode == 0, found.stdout

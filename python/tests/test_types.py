"""The types of calls, as mypy and pyright see them, each where it is installed."""

import subprocess
import sys
from pathlib import Path

import pytest

FILE = Path(__file__).with_name("types_of_calls.py")
CACHE = Path(__file__).parents[2] / "target/mypy"


def test_mypy():
    api = pytest.importorskip("mypy.api")
    report, errors, status = api.run(["--strict", f"--cache-dir={CACHE}", str(FILE)])
    assert status == 0, report + errors


def test_pyright():
    pytest.importorskip("pyright")
    found = subprocess.run(
        [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, FILE],
        capture_output=True,
        text=True,
    )
    assert found.returncode == 0, found.stdout

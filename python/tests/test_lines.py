"""The width of lines in the package and in its tests."""

from pathlib import Path

import pytest

import libration as lb

FOLDERS = [Path(lb.__file__).parent, Path(__file__).parent]
FILES = sorted(
    it for folder in FOLDERS for ending in ("py", "pyi") for it in folder.rglob(f"*.{ending}")
)


@pytest.mark.parametrize("file", FILES, ids=lambda it: it.name)
def test_lines_have_at_most_100_characters(file):
    lines = file.read_text(encoding="utf-8").splitlines()
    assert [number for number, line in enumerate(lines, 1) if len(line) > 100] == []

"""Pictures that the command draws, as SVG.

>>> from libration import questions
>>> picture = questions.figure_errors(formulas=["bernoulli", "black_vel_2"])
>>> picture.svg[:4], picture.to_dict()["series"][0]["label"]
('<svg', 'Bernoulli')
"""

import json
import os
import tempfile
from collections.abc import Mapping
from typing import Any

from ._ask import Asked, Path, answered, asked
from .errors import Interrupted

__all__ = ["Picture"]


class Picture:
    """A picture; a notebook shows it."""

    __slots__ = ("_asked", "_option", "svg")

    def __init__(
        self, question: Asked, option: str, layout: Mapping[str, Any], progress: Any = False
    ) -> None:
        self._asked = question._replace(words=_laid_out(question, layout))
        self._option = option
        self.svg = self._drawn("-", [], progress)
        """The picture as text."""

    def _drawn(self, file: str, form: list[str], progress: Any = False) -> str:
        text, error = answered(self._asked, [f"--{self._option}={file}", *form], progress)
        if error is not None:
            raise Interrupted(text or None) from error
        return text

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<picture of {self._asked.command}, {len(self.svg)} bytes of SVG>"

    def save(self, file: Path) -> None:
        """Writes it to a file whose name ends in .svg, .pdf or .png."""
        self._drawn(os.fspath(file), [])

    def to_dict(self) -> dict[str, Any]:
        """The content of the picture as numbers: the JSON of the command."""
        with tempfile.TemporaryDirectory() as folder:
            text = self._drawn(os.path.join(folder, "picture.svg"), ["--json"])
            fields: dict[str, Any] = json.loads(text)
        return fields


def _laid_out(question: Asked, layout: Mapping[str, Any]) -> tuple[str, ...]:
    given = {name.replace("_", "-"): value for name, value in layout.items() if value}
    options = [f"--{name}" if it is True else f"--{name}={it}" for name, it in given.items()]
    count = len(question.command.split())
    return (*question.words[:count], *options, *question.words[count:])


def drawn(words: str, given: Mapping[str, Any]) -> Picture:
    """The picture of a command, with the arguments of a function."""
    return Picture(asked(words, given), "output", {}, given.get("progress") or False)

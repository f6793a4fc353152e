"""Pictures that the command draws, as SVG.

>>> from libration import questions
>>> picture = questions.figure_errors(formulas=["bernoulli", "black_vel_2"])
>>> picture.svg[:4], picture.to_dict()["series"][0]["label"]
('<svg', 'Bernoulli')
"""

import json
import os
import tempfile
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from . import _chart, _native
from ._ask import Asked, Path, asked, charted
from .errors import Interrupted

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Picture"]


class Picture:
    """A picture; a notebook shows it."""

    __slots__ = ("_asked", "_drawing", "_option", "svg")
    _drawing: "_native.Chart | None"

    def __init__(
        self, question: Asked, option: str, layout: Mapping[str, Any], progress: Any = False
    ) -> None:
        self._asked = question._replace(words=_laid_out(question, layout))
        self._option = option
        self.svg = self._drawn("-", [], progress)
        """The picture as text."""

    def _drawn(self, file: str, form: list[str], progress: Any = False) -> str:
        words = [f"--{self._option}={file}", *form]
        text, error, self._drawing = charted(self._asked, words, progress)
        if error is not None:
            raise Interrupted(text or None) from error
        return text

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<picture of {self._asked.command}, {len(self.svg)} bytes of SVG>"

    def save(self, file: Path) -> None:
        """Writes it to a file whose name ends in .svg, .pdf, .png or .json."""
        self._drawn(os.fspath(file), [])

    def chart(self) -> dict[str, Any]:
        """The content of the picture as data, for other programs: that of a file .json."""
        return _chart.read(self._drawing)

    def plot(self, ax: "Axes | Iterable[Axes] | None" = None) -> Any:
        """Draws the picture with matplotlib, as `Answer.plot` does."""
        return _chart.draw(self.chart(), ax)

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

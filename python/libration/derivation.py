"""Worked derivations, each formula checked as it is written.

>>> import libration as lb
>>> derivation = lb.derive("perturbation", order=3)
>>> print(derivation.markdown.splitlines()[0])
# Perturbation theory of an oscillator, order by order
"""

from __future__ import annotations

import html
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from . import questions
from ._ask import Given, Path, Say, Values

__all__ = ["Derivation", "derive"]


@dataclass(frozen=True)
class Derivation:
    """A derivation; a notebook shows it, each section folded."""

    given: dict[str, Any] = field(repr=False)
    """The arguments of the call."""
    markdown: str = field(repr=False)
    """The text, with formulas between dollars."""

    @property
    def title(self) -> str:
        """The first line."""
        return self.markdown.splitlines()[0].lstrip("# ")

    def __str__(self) -> str:
        return self.markdown

    def __repr__(self) -> str:
        return f"<derivation: {self.title}>"

    def to_html(self) -> str:
        """A page that needs no other file."""
        return questions.derive(**self.given, format="html")

    def to_latex(self) -> str:
        """A document for LaTeX."""
        return questions.derive(**self.given, format="latex")

    def to_notebook(self) -> str:
        """A Jupyter notebook that computes each check again, or compares answers to exercises."""
        return questions.derive(**self.given, format="ipynb")

    def judge(self, number: str, answer: str) -> str:
        """The judgement of an answer to an exercise: right, not simplified, or wrong and why.

        >>> import libration as lb
        >>> lb.derive("short").judge("3.1", "omega0^2*(1 - theta0^2/8)")
        'right'
        """
        return questions.derive(**self.given, answer=f"{number}={answer}").rstrip()

    def save(self, file: Path) -> None:
        """Writes it to a file in the format of its extension: .md, .html, .tex or .ipynb."""
        forms = {".md": "markdown", ".html": "html", ".tex": "latex", ".ipynb": "ipynb"}
        ending = os.path.splitext(os.fspath(file))[1].lower()
        if ending not in forms:
            known = ", ".join(forms)
            raise ValueError(f"`{os.fspath(file)}` has no known extension: give one of {known}")
        questions.derive(**self.given, format=forms[ending], output=file)  # type: ignore[arg-type]

    def _repr_html_(self) -> str:
        """The page in a frame of its own, which keeps its style, with its sections folded."""
        section = r"<section id=\"[^\"]*\">\s*<h2>(.*?)</h2>(.*?)</section>"
        page = html.escape(re.sub(section, _folded, self.to_html(), flags=re.DOTALL))
        style, title = "width: 100%; height: 36rem; border: 0", html.escape(self.title)
        return f'<iframe srcdoc="{page}" style="{style}" title="{title}"></iframe>'


def _folded(section: "re.Match[str]") -> str:
    title = re.sub("<[^>]*>", "", section[1])
    return f"<details><summary><b>{title}</b></summary>{section[2]}</details>"


def derive(
    method: Literal["elliptic", "short", "formulas", "perturbation", "averaging", "limit-cycle"],
    oscillator: Given | None = None,
    *,
    order: Given | None = None,
    damping_order: Given | None = None,
    small: Given | None = None,
    resonance: Given | None = None,
    gauge: Given | None = None,
    set: Values | Sequence[str] | None = None,
    about: Given | None = None,
    amplitude: Given | None = None,
    length: Given | None = None,
    gravity: Given | None = None,
    exercises: bool = False,
    progress: Say = False,
) -> Derivation:
    """A worked derivation, step by step, with each formula checked by computing it.

    Parameters
    ----------
    method : str
        The method: "elliptic", "short", "formulas", "perturbation", "averaging" or "limit-cycle".
    oscillator : str, optional
        A key of the catalogue, or an equation.
    order, damping_order, small, resonance, gauge, set, about : optional
        As `libration.questions.derive` has them.
    amplitude, length, gravity, exercises, progress : optional
        As `libration.questions.derive` has them.

    Returns
    -------
    Derivation

    Examples
    --------
    >>> import libration as lb
    >>> lb.derive("elliptic")
    <derivation: The period of a pendulum at any amplitude>
    """
    own = {name: it for name, it in locals().items() if name != "progress"}
    given = {name: it for name, it in own.items() if it is not None and it is not False}
    return Derivation(given, questions.derive(**given, progress=progress))

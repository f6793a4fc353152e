"""Two published derivations, statement by statement, with verdict and evidence.

>>> import libration as lb
>>> paper = lb.paper("black-vel")
>>> paper.wrong.label.tolist()[5:7]
['(25)', '(27)']
"""

from __future__ import annotations

from typing import Literal

from ._ask import Given
from .answer import Answer, Rows, answer

__all__ = ["Paper", "paper"]


class Paper(Answer):
    """Statements with their verdicts."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Rows:
        """The statements with a verdict: ``verified``, ``typo``, ``wrong``, ``not_decided``."""
        verdict = name.replace("_", " ")
        if verdict in ("verified", "typo", "wrong", "not decided"):
            return Rows(it for it in self["equations"] if it["verdict"] == verdict)
        found: Rows = super().__getattr__(name)
        return found


def paper(
    document: Literal["black-vel", "cote"] | None = None,
    *,
    only: Given | None = None,
    label: Given | None = None,
) -> Paper:
    """Every equation of two published derivations, checked by computation and corrected.

    Parameters
    ----------
    document : str, optional
        "black-vel" (Am. J. Phys. 91, 776 (2023)) or "cote"; both, if it is not given.
    only : str, optional
        A verdict: "verified", "typo", "wrong" or "not-decided".
    label : str, optional
        A number or words of labels, such as 25, "C2" or "Fig. 1".

    Returns
    -------
    Paper

    Examples
    --------
    >>> import libration as lb
    >>> len(lb.paper().equations)
    139
    """
    return answer(Paper, "paper", locals())

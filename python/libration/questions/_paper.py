"""`libration paper`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Given, Say
from ..answer import Answer, answer


def paper(
    *,
    only: str | None = None,
    document: str | None = None,
    label: Given | None = None,
    progress: Say = False,
) -> Answer:
    """Every equation of two published derivations, checked by computation and corrected where it is
    wrong.

    The documents are B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), and J. Côté, Period of a
    Pendulum. What they print is compared with what the program computes, exactly where possible.
    Where they state something in words, ``paraphrase`` marks the formula.

    Parameters
    ----------
    only : str, optional
        Show only statements with this verdict.
    document : str, optional
        Show only one document: black-vel or cote.
    label : number or text, optional
        Show only labels that contain this number or these words, such as 25, C2 or "Fig. 1".
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    Answer

    Raises
    ------
    UsageError
        An argument is not valid.
    NoAnswer
        There is no result.
    Interrupted
        Ctrl-C; its ``partial`` is the result up to then.

    Examples
    --------
    >>> from libration import questions
    >>> questions.paper(document="black-vel", label=25).equations.verdict.tolist()
    ['wrong']
    """
    return answer(Answer, "paper", locals())

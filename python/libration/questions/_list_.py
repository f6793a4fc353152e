"""`libration list`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Given, Say
from ..answer import Answer, answer


def list_(
    entries: Given | None = None,
    *,
    progress: Say = False,
) -> Answer:
    """The built-in oscillators and systems: equations of motion, parameters, sources.

    Parameters
    ----------
    entries : number or text, or several, optional
        The catalogues ``oscillators`` and ``systems``, or keys of their entries [default: both
        catalogues].
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
    >>> questions.list_("duffing").oscillators[0].equation
    "x'' + x + epsilon*x^3 = 0"
    """
    return answer(Answer, "list", locals())

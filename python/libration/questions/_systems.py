"""`libration systems`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Given, Say
from ..answer import Answer, answer


def systems(
    keys: Given | None = None,
    *,
    progress: Say = False,
) -> Answer:
    """The built-in systems: equations of motion, parameters with units, energies, and sources.

    Parameters
    ----------
    keys : number or text, or several, optional
        List only these.
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    Answer

    Raises
    ------
    UsageError
        What is given cannot be understood.
    NoAnswer
        There is no answer.
    Interrupted
        Ctrl-C; its ``partial`` is what there is of the answer.

    Examples
    --------
    >>> from libration import questions
    >>> questions.systems("lorenz").systems[0].key
    'lorenz'
    """
    return answer(Answer, "systems", locals())

"""`libration fields`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Given, Say
from ..answer import Answer, answer


def fields(
    command: Given | None = None,
    *,
    progress: Say = False,
) -> Answer:
    """The fields of JSON and CSV results: names, units, meanings.

    In names, [] stands for each entry of a list, and capitals for a name that depends on the
    command line: KEY is the key of a formula, NAME the name of a parameter, a coordinate or a
    velocity, K the number of a harmonic. Nested fields are preceded by their path. The unit is
    empty where there is none, or where it depends on the command line.

    Parameters
    ----------
    command : number or text, or several, optional
        The command, such as period or fit trace [default: all commands].
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
    >>> questions.fields("fourier").commands[0].json[0].name
    'schema'
    """
    return answer(Answer, "fields", locals())

"""`libration sweep status`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence

from .._ask import Path, Say
from ..answer import Answer, answer


def sweep_status(
    directories: Path | Sequence[Path],
    *,
    progress: Say = False,
) -> Answer:
    """Show the progress of a sweep and the missing shards.

    Parameters
    ----------
    directories : str or path, or several
        The directories of the shards; a single one if all write to it.
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
    """
    return answer(Answer, "sweep status", locals())

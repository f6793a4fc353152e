"""`libration sweep join`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence

from .._ask import Path, Say
from ..answer import Answer, answer


def sweep_join(
    directories: Path | Sequence[Path],
    *,
    output: Path | None = None,
    progress: Say = False,
) -> Answer:
    """Put the shards of a sweep together as one file of CSV or JSON.

    The file is the same, byte for byte, however many shards, threads and interruptions there were.

    Parameters
    ----------
    directories : str or path, or several
        The directories of the shards; a single one if all have written to it.
    output : str or path, optional
        The file, whose extension chooses its format: .csv or .json [default: CSV on the standard
        output].
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
    return answer(Answer, "sweep join", locals())

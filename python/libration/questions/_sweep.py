"""`libration sweep`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence

from .._ask import Given, Path, Say, Values, text


def sweep(
    question: Given,
    *,
    over: Values | Sequence[str],
    output: Path,
    keep: Given | None = None,
    shard: str | None = None,
    chunk: int | None = None,
    progress: Say = False,
) -> str:
    """Run a command over a parameter grid, in chunks that survive interruptions.

    Each ``over`` is an axis. Its values replace {NAME} in the command, or go to its option or
    argument of this name, or they are initial values or parameters of its system.

    Parameters
    ----------
    question : number or text, or several
        The command and its options, as after ``libration``; ``json`` is implied.
    over : dict
        An axis and its values: A=1:1.5:0.01, theta=1deg:9deg:1deg or n=1,2,5; separated by
        semicolons if values contain commas.
    output : str or path
        The directory for the chunks; a sweep begun there is continued.
    keep : number or text, or several, optional
        Keep this number of the result, by its path in JSON: exponent, results[0].ratio,
        samples[-1].state[0], points[0:100].state[1], with a name as in angle=samples[-1].state[0]
        [default: all numbers outside lists].
    shard : str, optional
        Compute this part of the sweep only, such as 3/64.
    chunk : int, optional
        Largest number of points in a chunk [default: about 256 chunks].
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    str

    Raises
    ------
    UsageError
        An argument is not valid.
    NoAnswer
        There is no result.
    Interrupted
        Ctrl-C; its ``partial`` is the result up to then.
    """
    return text("sweep", locals(), progress)

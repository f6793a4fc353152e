"""`libration formulas`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence

from .._ask import Angle, Say, Value
from ..answer import Answer, answer


def formulas(
    keys: str | Sequence[str] | None = None,
    *,
    amplitude: Angle | None = None,
    tolerance: Value | None = None,
    crossovers: bool = False,
    formulas: str | Sequence[str] | None = None,
    progress: Say = False,
) -> Answer:
    """The catalogue of formulas for the period: their errors, ranges of validity and crossovers.

    Parameters
    ----------
    keys : str, or several, optional
        Keys of formulas whose sheets are shown: formula, derivation, source, error curve.
    amplitude : angle, optional
        List only formulas within the tolerance at this amplitude and all smaller ones.
    tolerance : float or str, optional
        Largest acceptable fractional error of the period, such as 1e-3 or 0.1%.
    crossovers : bool
        List the amplitudes at which one formula becomes better than another.
    formulas : str, or several, optional
        Keys of formulas (``libration formulas`` lists them).
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
    >>> questions.formulas(amplitude="90deg", tolerance=1e-3).rows.key[0]
    'black_vel_2'
    """
    return answer(Answer, "formulas", locals())

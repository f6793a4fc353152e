"""`libration lyapunov`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Given, Path, Say, Values
from ..answer import Answer, answer


def lyapunov(
    system: Given,
    *,
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    intervals: Given | None = None,
    time: Given | None = None,
    transient: Given | None = None,
    tolerance: Given | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Given | None = None,
    height: Given | None = None,
    progress: Say = False,
) -> Answer:
    """The largest Lyapunov exponent: how fast neighbouring motions diverge, and whether the motion
    is chaotic.

    Parameters
    ----------
    system : number or text
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    intervals : number or text, optional
        Number of intervals to measure, each about one period of the motion [default: 1000].
    time : number or text, optional
        Duration of the measurement in seconds, instead of a number of intervals.
    transient : number or text, optional
        Time before the measurement, in seconds [default: 100 intervals].
    tolerance : number or text, optional
        The relative error allowed in each step [default: 1e-13].
    figure : str or path, optional
        Draw the convergence of the exponent to FILE.svg or FILE.png instead of listing it.
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : number or text, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : number or text, optional
        Height of the picture [default: chosen to suit the picture].
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
    >>> questions.lyapunov("pendulum", initial={"theta": 1}, intervals=100).verdict
    'regular'
    """
    return answer(Answer, "lyapunov", locals())

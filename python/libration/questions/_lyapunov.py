"""`libration lyapunov`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def lyapunov(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    intervals: int | None = None,
    time: Value | None = None,
    transient: Value | None = None,
    tolerance: Value | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """The largest Lyapunov exponent: the rate at which neighbouring motions diverge, and whether
    the motion is chaotic.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    intervals : int, optional
        Number of intervals to measure, each about one period of the motion [default: 1000].
    time : float or str, optional
        Duration of the measurement in seconds, instead of a number of intervals.
    transient : float or str, optional
        Time before the measurement, in seconds [default: 100 intervals].
    tolerance : float or str, optional
        The relative error allowed in each step [default: 1e-13].
    figure : str or path, optional
        Draw the convergence of the exponent to FILE.svg, .pdf, .png or .json instead of listing it.
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : quantity, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : quantity, optional
        Height of the picture [default: chosen to suit the picture].
    no_title : bool
        Leave out the title and the parameters under it, for a figure with a caption.
    curve_labels : bool
        Write the names of curves next to them where there is room, and the others in the legend.
    angles : {"degrees", "radians"}, optional
        Unit of the angles along the axes [default: the usual one of the picture].
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
    >>> questions.lyapunov("pendulum", initial={"theta": 1}, intervals=100).verdict
    'regular'
    """
    return answer(Answer, "lyapunov", locals())

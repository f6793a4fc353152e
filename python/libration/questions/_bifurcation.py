"""`libration bifurcation`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Coordinate, Equation, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def bifurcation(
    system: Equation,
    *,
    over: Values | Sequence[str],
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    sweep: Literal["up", "down", "both"] | None = None,
    period: Value | None = None,
    phase: Value | None = None,
    at: Equation | None = None,
    direction: Literal["rising", "falling", "any"] | None = None,
    skip: int | None = None,
    points: int | None = None,
    tolerance: Value | None = None,
    fold: bool = False,
    no_errors: bool = False,
    axis: Coordinate | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """Bifurcation diagram: the Poincaré section of a motion for each value of a parameter.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    over : dict
        The parameter and its values, from A to B in steps, such as A=1:1.5:0.01.
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    sweep : {"up", "down", "both"}, optional
        Start each motion where the previous one ended, taking the values in this order.
    period : float or str, optional
        Take a point once per period of this length, in seconds [default: the period of the drive].
    phase : float or str, optional
        Take the points at this fraction of the period, from 0 to 1 [default: 0].
    at : formula, optional
        Take a point whenever this formula of coordinates, velocities, parameters and t changes its
        sign, or two are equal, such as "theta = 0.5".
    direction : {"rising", "falling", "any"}, optional
        Direction in which the formula crosses zero [default: rising].
    skip : int, optional
        Number of points to discard as transient [default: 100, but 0 for a section with ``at``].
    points : int, optional
        Number of points to record.
    tolerance : float or str, optional
        The relative error allowed in each step [default: 1e-12].
    fold : bool
        Reduce angles to the range from −π to π, as pictures always do.
    no_errors : bool
        Do not estimate the errors of the states, which saves time.
    axis : coordinate, optional
        The state variable that the picture shows [default: the first coordinate, or its velocity if
        it is an angle, unless ``at`` fixes it].
    figure : str or path, optional
        Draw the diagram to FILE.svg, .pdf, .png or .json instead of listing the points.
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
    >>> given = {"set": {"c": 0.5}, "initial": {"theta": 0.2}, "points": 2, "skip": 0}
    >>> diagram = questions.bifurcation("driven_pendulum", over="A=1:1.1:0.1", **given)
    >>> diagram.points.value.tolist()
    [1.0, 1.0, 1.1, 1.1]
    """
    return answer(Answer, "bifurcation", locals())

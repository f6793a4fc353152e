"""`libration stability`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Path, Quantity, Say, Values
from ..answer import Answer, answer


def stability(
    system: Equation,
    *,
    map: Values,
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    drive_periods: int | None = None,
    generations: int | None = None,
    lines: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """Stability over two parameters: stability boundaries of an equilibrium, curves of folds,
    symmetry breakings and period doublings, cusps.

    An equilibrium, such as the hanging or the upright pendulum whose pivot moves, has its stability
    boundaries where a Floquet multiplier leaves the unit circle. Driven motions are followed on
    some lines of the map, and their singular points from there in both parameters.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    map : dict
        Two parameters and their ranges, such as omega=1:3,a=0:0.5.
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    drive_periods : int, optional
        Number of periods of the drive in one period of the response [default: 1].
    generations : int, optional
        Maximum depth of secondary branches (symmetry breaking, period doubling) [default: 1].
    lines : int, optional
        Number of lines in each direction on which driven motions are followed; 0 for the
        equilibrium alone [default: 3].
    figure : str or path, optional
        Draw the map to FILE.svg, .pdf, .png or .json instead of listing the curves.
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
    >>> given = {"set": {"c": 0.1}, "initial": {"theta": "180deg"}, "lines": 0}
    >>> edges = questions.stability("kapitza", map="omega=5:6,a=0.1:0.4", **given)
    >>> edges.curves.kind.tolist(), round(float(edges.curves[0].points.parameters[0, 1]), 12)
    (['branch_point'], 0.28778617467)
    """
    return answer(Answer, "stability", locals())

"""`libration response`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Coordinate, Equation, Given, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def response(
    system: Equation,
    *,
    over: Values | Sequence[str],
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    drive_periods: int | None = None,
    turns: int | None = None,
    orders: Given | None = None,
    at: Value | None = None,
    generations: int | None = None,
    coordinate: Coordinate | None = None,
    digits: int | None = None,
    sweeps: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """The periodic responses of a driven system, or limit cycles, over a parameter: amplitude,
    stability, folds and jumps, symmetry breakings, period doublings.

    Branches begin with the solutions found at both ends of the range, from the start and by
    harmonic balance, and are followed through their folds; secondary branches are followed too.
    Every point has an error, special points are exact to their last digits.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    over : dict
        The parameter and its range, such as omega=0.3:1.4.
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    drive_periods : int, optional
        Number of periods of the drive in one period of the response, for subharmonic responses
        [default: 1].
    turns : int, optional
        Number of turns of the angle of ``coordinate`` in one period, for rotating responses;
        negative for backward rotation.
    orders : float or str, or several, optional
        Search for sub- and superharmonic responses too: oscillations per drive periods, such as
        1/3,1/2.
    at : float or str, optional
        The value at which solutions are searched, for isolated closed branches (isolas) within the
        range [default: the ends of the range].
    generations : int, optional
        Maximum depth of secondary branches (symmetry breaking, period doubling) [default: 2].
    coordinate : coordinate, optional
        The coordinate of the amplitude [default: the first].
    digits : int, optional
        Compute the parameter at special points to this number of digits, up to 100.
    sweeps : int, optional
        Also sweep the parameter slowly up and down through N values by integration [default: 48 if
        a picture is drawn, else none].
    figure : str or path, optional
        Draw amplitude against parameter to FILE.svg, .pdf, .png or .json instead of listing the
        points.
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
    >>> drive = {"A": 0.15, "c": 0.1}
    >>> response = questions.response("driven_pendulum", set=drive, over="omega=0.7:1")
    >>> response.branches[0].special.parameter.round(12).tolist()
    [0.872157569138, 0.780632653519]
    """
    return answer(Answer, "response", locals())

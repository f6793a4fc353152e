"""`libration orbit`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Coordinate, Equation, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def orbit(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    initial: Values | None = None,
    period: Value | None = None,
    drive_periods: int | None = None,
    hold: Coordinate | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """A periodic orbit: its period, harmonics, Floquet multipliers and stability, with errors.

    For a driven system, the periodic response near the start, or the one to which the start leads;
    without a drive, the motion from the start if it returns, a limit cycle, or the orbit near a
    guess of its period. Without a drive the period is the least one.

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
    period : float or str, optional
        A guess of the period, in seconds; for a driven system, the period of the response, to a
        thousandth of that of the drive.
    drive_periods : int, optional
        Number of periods of the drive in one period of the orbit, for subharmonic orbits [default:
        1].
    hold : coordinate, optional
        The coordinate whose value at the start is kept, in a family of orbits near a guess
        [default: the farthest from zero].
    figure : str or path, optional
        Draw the orbit to FILE.svg, .pdf, .png or .json, in time and in the plane of coordinate and
        velocity.
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
    >>> orbit = questions.orbit("x'' = (1 - x^2) x' - x", initial={"x": 0.5})
    >>> round(orbit.period_s, 12), orbit.stability
    (6.663286859323, 'attracting')
    """
    return answer(Answer, "orbit", locals())

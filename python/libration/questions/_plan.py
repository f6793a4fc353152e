"""`libration plan`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Angle, Given, Path, Quantity, Say, Value
from ..answer import Answer, answer


def plan(
    *,
    g_to: Value,
    length: Quantity,
    angle_noise: Angle,
    rate: Value,
    amplitudes: Given | None = None,
    linear: Quantity | None = None,
    angle_scale: Value | None = None,
    clock: Value | None = None,
    gravity: Value | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """Plan a measurement of g: amplitude of release, number of swings, uncertainty of the length.

    The rows have independent errors of the angle, and a fit finds ω0, damping and start from them,
    as ``libration fit trace --model linear`` does; without a model the fit does not know the law of
    damping either, and its uncertainties for few swings are about half as large again. The
    uncertainty of ω0 is the Cramér–Rao bound; length, clock and the scale of the angles add their
    parts, as in the budget of the measurement.

    Parameters
    ----------
    g_to : float or str
        The target relative standard uncertainty of g, such as 1e-3 or 0.1%.
    length : quantity
        Distance from the pivot to the centre of the bob, with its uncertainty, such as 1.0000(5)m.
    angle_noise : angle
        Standard deviation of the angle in a row, such as 0.2deg.
    rate : float or str
        Rows per second, such as 60.
    amplitudes : number or text, or several, optional
        Amplitudes to choose from, such as 5deg,20deg or 5deg:60deg:5deg [default:
        5deg,10deg,15deg,20deg,30deg,45deg,60deg,90deg].
    linear : quantity, optional
        Coefficient of linear damping, such as 0.03/s: the amplitude falls as exp(-b t/2) [default:
        none].
    angle_scale : float or str, optional
        Relative uncertainty of the scale of all angles [default: 1%].
    clock : float or str, optional
        Relative uncertainty of the clock or frame rate [default: 0].
    gravity : float or str, optional
        Approximate acceleration of free fall [default: 9.80665m/s^2].
    figure : str or path, optional
        Draw the result to FILE.svg, .pdf, .png or .json.
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
    >>> plan = questions.plan(g_to=1e-3, length="1.0000(5)m", angle_noise="0.2deg", rate=60)
    >>> plan.advice.tolist()
    ['release at 15 degrees and record 2 swings, 4.03 s']
    """
    return answer(Answer, "plan", locals())

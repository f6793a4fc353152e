"""`libration motion`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Angle, Given, Path, Quantity, Say, Value
from ..answer import Answer, answer


def motion(
    angle: Angle,
    *,
    velocity: Value | None = None,
    times: Given | None = None,
    times_from: Path | None = None,
    compare: str | Sequence[str] | None = None,
    figure: Path | None = None,
    animate: bool = False,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    length: Quantity | None = None,
    gravity: Quantity | None = None,
    progress: Say = False,
) -> Answer:
    """Angle and velocity in time, from any starting angle and velocity.

    Parameters
    ----------
    angle : angle
        The starting angle, such as 60deg, 1.2rad or pi-1e-6; beyond the top, whole turns are
        counted.
    velocity : float or str, optional
        The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s [default:
        0rad/s].
    times : number or text, or several, optional
        Times START:STOP:STEP or t1,t2,…, in seconds or with a unit [default: one period in 24
        steps].
    times_from : str or path, optional
        Read the times from a file, one per line; - for standard input.
    compare : str, or several, optional
        Approximate motions to compare with: small-angle, fourier-3, fourier-5, fourier-7.
    figure : str or path, optional
        Draw the motion to FILE.svg, .pdf, .png or .json instead of listing it.
    animate : bool
        Animate the pendulum next to its curve (an SVG animation, for browsers).
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
    length : quantity, optional
        Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m].
    gravity : quantity, optional
        Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default:
        9.80665m/s^2].
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
    >>> motion = questions.motion("60deg", times=[0.0, 0.5])
    >>> motion.samples.angle_rad.round(9).tolist()
    [1.047197551, 0.119684411]
    """
    return answer(Answer, "motion", locals())

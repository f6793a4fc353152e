"""`libration melnikov`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Path, Quantity, Say, Values
from ..answer import Answer, answer


def melnikov(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    over: Values | Sequence[str] | None = None,
    max_drive_periods: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """Conditions for chaotic motion of a weakly perturbed pendulum: the Melnikov function with its
    zeros and thresholds, resonances, their widths and overlap.

    Everything in the equation but −ω0²·sin of the angle, counted from where the pendulum hangs, is
    taken as the perturbation, to first order. Where the Melnikov function has simple zeros, the
    motions that leave the upright position and those that return to it cross, and there is chaos
    next to them.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    over : dict, optional
        A parameter and the range in which to look for thresholds, such as A=0:1.
    max_drive_periods : int, optional
        The largest number of periods of the drive, q, of a resonance p:q [default: 5].
    figure : str or path, optional
        Draw the function, and the resonances on the curve of frequencies, to FILE.svg, .pdf, .png
        or .json instead of listing them.
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
    >>> melnikov = questions.melnikov("driven_pendulum", set={"c": 0.1, "omega": 1}, over="A=0:1")
    >>> melnikov.thresholds.value.round(12).tolist()
    [0.319478526383, 0.319478526383]
    """
    return answer(Answer, "melnikov", locals())

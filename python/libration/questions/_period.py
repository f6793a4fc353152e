"""`libration period`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Given, Path, Quantity, Say
from ..answer import Answer, answer


def period(
    amplitudes: Given | None = None,
    *,
    from_file: Path | None = None,
    period: Given | None = None,
    ratio: Given | None = None,
    excess: Given | None = None,
    formulas: str | Sequence[str] | None = None,
    sort: Literal["error", "catalogue"] | None = None,
    figure: Path | None = None,
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
    """The exact period at one or more amplitudes, or the amplitude of a period, and every published
    formula with its error.

    Parameters
    ----------
    amplitudes : number or text, or several, optional
        Angles such as 60deg, 1.2rad or pi-1e-6, or ranges such as 1deg:179deg:1deg.
    from_file : str or path, optional
        Read the amplitudes from a file, one per line; - for standard input.
    period : quantity, or several, optional
        The amplitude with this period, such as 2.1s or 2.10(1)s; an uncertainty of the period gives
        one of the amplitude.
    ratio : quantity, or several, optional
        The amplitude with this ratio of its period to that of small swings, T/T₀.
    excess : quantity, or several, optional
        The amplitude whose period exceeds that of small swings by this fraction, T/T₀ − 1; keeps
        all digits of small amplitudes.
    formulas : str, or several, optional
        Keys of formulas (``libration formulas`` lists them).
    sort : {"error", "catalogue"}, optional
        The order of the formulas [default: error].
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
    >>> round(questions.period("60deg").results[0].ratio, 12)
    1.073182007149
    """
    return answer(Answer, "period", locals())

"""`libration fit lengths`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Angle, Columns, Given, Path, Quantity, Say, Value
from ..answer import answer
from ..fit import Fit


def fit_lengths(
    file: Path | Columns,
    *,
    columns: Given | None = None,
    length_unit: Literal["m", "cm", "mm", "in"] | None = None,
    amplitude: Angle | None = None,
    amplitude_unit: Literal["rad", "deg"] | None = None,
    half_periods: bool = False,
    periods_per_row: Value | None = None,
    delimiter: Literal["comma", "semicolon", "tab", "space"] | None = None,
    header: Literal["detect", "present", "absent"] | None = None,
    bob_radius: Quantity | None = None,
    clock: Value | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    progress: Say = False,
) -> Fit:
    """Measured periods against length: gravity, and the offset common to all lengths.

    Parameters
    ----------
    file : str or path or columns
        A table of lengths and periods, optionally with uncertainties; - for standard input.
    columns : number or text, or several, optional
        Columns of both quantities, of the uncertainties of both, and of further ones, by number or
        name; - for none [default: the first two of values, with the uncertainties that the header
        names].
    length_unit : {"m", "cm", "mm", "in"}, optional
        Unit of the lengths and of their uncertainties [default: that of the header, else m].
    amplitude : angle, optional
        The amplitude of all swings, such as 10deg [default: negligible].
    amplitude_unit : {"rad", "deg"}, optional
        Unit of a column of amplitudes [default: that of the header, else rad].
    half_periods : bool
        The times are half periods, from one side to the other.
    periods_per_row : float or str, optional
        Each time spans this many periods [default: as the header says, such as 10T or half period,
        else 1].
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the columns [default: detected].
    header : {"detect", "present", "absent"}, optional
        Row of column names: detected, present or absent [default: detect].
    bob_radius : quantity, optional
        Radius of the bob, a sphere, whose moment of inertia is then part of every law; without it a
        radius of gyration is fitted.
    clock : float or str, optional
        Relative uncertainty of the clock or frame rate, such as 0.1% where 29.97 frames/s may have
        been taken for 30.
    figure : str or path, optional
        Draw the data, the line and the residuals to FILE.svg or FILE.png.
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : quantity, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : quantity, optional
        Height of the picture [default: chosen to suit the picture].
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    Fit

    Raises
    ------
    UsageError
        An argument is not valid.
    NoAnswer
        There is no result.
    Interrupted
        Ctrl-C; its ``partial`` is the result up to then.
    """
    return answer(Fit, "fit lengths", locals())

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
    role: Given | None = None,
    group: int | str | None = None,
    length_unit: Literal["m", "cm", "mm", "in"] | None = None,
    amplitude: Angle | None = None,
    amplitude_unit: Literal["rad", "deg"] | None = None,
    half_periods: bool = False,
    swings_per_reading: Value | None = None,
    reaction_time: Value | None = None,
    shared_timing: Value | None = None,
    sheet: int | str | None = None,
    delimiter: Literal["comma", "semicolon", "tab", "space"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    header: int | str | None = None,
    bob_radius: Quantity | None = None,
    model: Literal["simple", "bar", "reversible"] | None = None,
    edges: Quantity | None = None,
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
        name; - for none [default: as headings, units and values say].
    role : number or text, or several, optional
        Role of a column: a quantity, as in 2=period (several columns are repeated readings); its
        uncertainty, as in 3=period-uncertainty, period-half-width or period-resolution; swings,
        group, ignore.
    group : int or str, optional
        Column of the names of groups, whose results are compared and averaged [default: a column
        whose header says so].
    length_unit : {"m", "cm", "mm", "in"}, optional
        Unit of the lengths and of their uncertainties [default: that of the header, else m].
    amplitude : angle, optional
        The amplitude of all swings, such as 10deg [default: negligible].
    amplitude_unit : {"rad", "deg"}, optional
        Unit of a column of amplitudes [default: that of the header, else rad].
    half_periods : bool
        The times are half periods, from one side to the other.
    swings_per_reading : float or str, optional
        Each time lasts this many swings, full periods [default: as the header says, such as 10T or
        time for 10 swings, else 1].
    reaction_time : float or str, optional
        Standard uncertainty of a single timing by hand, such as 0.1s; repeated readings have it in
        their scatter.
    shared_timing : float or str, optional
        Standard uncertainty of what all timings share, such as 0.05s for an observer who stops
        late.
    sheet : int or str, optional
        Sheet of a workbook or file of an archive, by number or name.
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the cells.
    decimal : {"point", "comma"}, optional
        Decimal point or decimal comma.
    header : int or str, optional
        Line that names the columns: detect, present, absent, or its number.
    bob_radius : quantity, optional
        Radius of the bob, a sphere, whose moment of inertia is then part of every law; without it a
        radius of gyration is fitted.
    model : {"simple", "bar", "reversible"}, optional
        The pendulum: simple, a bar turned about points at these distances from its centre of mass
        or positions on a scale along it, or reversible with two knife edges [default: a bar where
        the periods show it, else simple].
    edges : quantity, optional
        Distance of the knife edges of a reversible pendulum [default: the sum of their distances
        from the centre of mass].
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

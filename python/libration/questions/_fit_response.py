"""`libration fit response`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Columns, Given, Path, Quantity, Say, Value
from ..answer import answer
from ..fit import Fit


def fit_response(
    file: Path | Columns,
    *,
    columns: Given | None = None,
    role: Given | None = None,
    from_: Value | None = None,
    to: Value | None = None,
    run: Given | None = None,
    frequency_unit: Literal["Hz", "kHz", "rad/s", "deg/s"] | None = None,
    amplitude_unit: Literal["rad", "deg", "m", "cm", "mm", "in", "counts"] | None = None,
    phase_unit: Literal["rad", "deg"] | None = None,
    errors: Literal["absolute", "relative"] | None = None,
    sheet: int | str | None = None,
    delimiter: Literal["comma", "semicolon", "tab", "space"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    header: int | str | None = None,
    model: Literal["linear", "pendulum", "duffing"] | None = None,
    measured: Literal["peak", "fundamental"] | None = None,
    figure: Path | None = None,
    report: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Fit:
    """Amplitudes and phases of a driven oscillator against frequency: natural frequency, damping
    and drive, through its jumps.

    Parameters
    ----------
    file : str or path or columns
        A table of drive frequencies, or periods, and amplitudes, optionally with phases and with
        uncertainties; - for standard input.
    columns : number or text, or several, optional
        Columns of both quantities, of the uncertainties of both, and of further ones, by number or
        name; - for none [default: from headings, units and values].
    role : number or text, or several, optional
        Role of a column: a quantity, as in 2=period (several columns are repeated readings); its
        uncertainty, as in 3=period-uncertainty, period-half-width, period-resolution or, of means
        of several readings, period-deviation; swings, readings, group, ignore.
    from_ : float or str, optional
        Ignore rows in which the first quantity (length, amplitude, frequency, time) is less than
        this, in the unit of its column unless it has one, such as 20cm.
    to : float or str, optional
        Ignore rows in which the first quantity is greater than this.
    run : number or text, or several, optional
        Use only these groups of the table, by name or number; several as 1,2,6.
    frequency_unit : {"Hz", "kHz", "rad/s", "deg/s"}, optional
        Unit of the frequencies and of their uncertainties [default: that of the header].
    amplitude_unit : {"rad", "deg", "m", "cm", "mm", "in", "counts"}, optional
        Unit of the amplitudes and of their uncertainties [default: that of the header, else rad].
    phase_unit : {"rad", "deg"}, optional
        Unit of the phases and of their uncertainties [default: that of the header, else rad].
    errors : {"absolute", "relative"}, optional
        Errors of all amplitudes if no uncertainties are stated: the same absolute error, or the
        same relative error [default: absolute].
    sheet : int or str, optional
        Sheet of a workbook or file of an archive, by number or name.
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the cells.
    decimal : {"point", "comma"}, optional
        Decimal point or decimal comma.
    header : int or str, optional
        Line that names the columns: detect, present, absent, or its number.
    model : {"linear", "pendulum", "duffing"}, optional
        The oscillator [default: the simplest consistent with the rows; a pendulum if amplitudes are
        angles].
    measured : {"peak", "fundamental"}, optional
        The quantity measured as the amplitude [default: peak].
    figure : str or path, optional
        Draw the data and the curve, its unstable part dashed, to FILE.svg, .pdf, .png or .json.
    report : str or path, optional
        Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next
        to it.
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
    return answer(Fit, "fit response", locals())

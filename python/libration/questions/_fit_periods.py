"""`libration fit periods`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Angle, Columns, Given, Path, Quantity, Say, Value
from ..answer import answer
from ..fit import Fit


def fit_periods(
    file: Path | Columns,
    *,
    columns: Given | None = None,
    role: Given | None = None,
    from_: Value | None = None,
    to: Value | None = None,
    run: Given | None = None,
    group: int | str | None = None,
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
    reject_outliers: Value | None = None,
    formulas: str | Sequence[str] | None = None,
    figure: Path | None = None,
    report: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    length: Quantity | None = None,
    bob_radius: Quantity | None = None,
    bob: str | None = None,
    bob_mass: Quantity | None = None,
    bob_density: Quantity | None = None,
    rod_mass: Quantity | None = None,
    rod_length: Quantity | None = None,
    air_density: Quantity | None = None,
    stretch: Quantity | None = None,
    expansion: Quantity | None = None,
    warmer: Quantity | None = None,
    support_stiffness: Quantity | None = None,
    edge_radius: Quantity | None = None,
    angle_scale: Value | None = None,
    clock: Value | None = None,
    correlation: str | Sequence[str] | None = None,
    latitude: Value | None = None,
    elevation: Value | None = None,
    linear: Quantity | None = None,
    progress: Say = False,
) -> Fit:
    """Measured periods against amplitude: T0 under the exact law and every other, a test of the
    exact law, gravity.

    Parameters
    ----------
    file : str or path or columns
        A table of amplitudes and periods, optionally with uncertainties; - for standard input.
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
    group : int or str, optional
        Column of the names of groups, whose results are compared and averaged [default: a column
        named so in the header].
    amplitude : angle, optional
        The amplitude of all swings, such as 10deg, for a table without amplitudes.
    amplitude_unit : {"rad", "deg"}, optional
        Unit of the amplitudes and of their uncertainties [default: that of the header, else rad, or
        deg for angles of π or more].
    half_periods : bool
        The times are half periods, from one side to the other.
    swings_per_reading : float or str, optional
        Number of swings, full periods, in each time [default: from the header, such as 10T or time
        for 10 swings, else 1].
    reaction_time : float or str, optional
        Standard uncertainty of a single timing by hand, such as 0.1s; for repeated readings it is
        part of their scatter.
    shared_timing : float or str, optional
        Standard uncertainty of the error common to all timings, such as 0.05s for an observer who
        stops late.
    sheet : int or str, optional
        Sheet of a workbook or file of an archive, by number or name.
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the cells.
    decimal : {"point", "comma"}, optional
        Decimal point or decimal comma.
    header : int or str, optional
        Line that names the columns: detect, present, absent, or its number.
    reject_outliers : float or str, optional
        Leave out rows more than this many robust standard deviations from the exact law.
    formulas : str, or several, optional
        Keys of formulas (``libration formulas`` lists them).
    figure : str or path, optional
        Draw the data, the laws and the residuals to FILE.svg, .pdf, .png or .json.
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
    length : quantity, optional
        Distance from the pivot to the centre of the bob, with its uncertainty, such as
        0.57m±0.004m, or "0.57m±5mm rectangular" for a half-width: gives gravity.
    bob_radius : quantity, optional
        Radius of the bob, a ball, such as 20.0(1)mm.
    bob : str, optional
        A bob that is not a ball: disc:radius=5cm,thickness=1cm (swings in its plane),
        cylinder:radius=2cm,height=5cm (along the rod), ring:radius=5cm,inner=3cm,
        cap:radius=5cm,height=3cm (of a ball), or gyration:radius=2cm, the root of its moment of
        inertia over its mass.
    bob_mass : quantity, optional
        Mass of the bob, or of a bar, such as 42.0g±0.5g.
    bob_density : quantity, optional
        Density of the bob, or of a bar, such as 7.85g/cm^3 [default: by its mass and size].
    rod_mass : quantity, optional
        Mass of the rod or string.
    rod_length : quantity, optional
        Distance from the pivot to the end of the rod [default: to the surface of the bob].
    air_density : quantity, optional
        Density of the air [default: 1.20(2)kg/m^3].
    stretch : quantity, optional
        Stretch of the string under the hanging bob.
    expansion : quantity, optional
        Coefficient of thermal expansion of the pendulum, such as 12(1)e-6/K for steel.
    warmer : quantity, optional
        Temperature of the pendulum during the swings minus that during the measurement of its
        length, such as 3K±1K, or -3K if it was colder.
    support_stiffness : quantity, optional
        Horizontal stiffness of the support, such as 20(2)N/mm: with the mass of the bob, L is
        longer by m g/K.
    edge_radius : quantity, optional
        Radius of curvature of a knife edge or rounded pivot that rolls: L is shorter by it.
    angle_scale : float or str, optional
        Relative uncertainty of the scale of all angles, such as 0.01 or 1%.
    clock : float or str, optional
        Relative uncertainty of the clock or frame rate, such as 0.1% if 29.97 frames/s may have
        been taken as 30.
    correlation : str, or several, optional
        Correlation coefficient of two inputs, such as length,bob-radius=0.9.
    latitude : float or str, optional
        Geographic latitude, such as 48.1deg, or -33.9deg in the south: gives the normal gravity
        there next to the result.
    elevation : float or str, optional
        Elevation, the height above sea level, such as 520m [default: not known].
    linear : quantity, optional
        Coefficient of linear damping, such as 0.030(1)/s: the amplitude falls as exp(-b t/2)
        [default: not corrected].
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
    return answer(Fit, "fit periods", locals())

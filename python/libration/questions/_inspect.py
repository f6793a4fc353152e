"""`libration inspect`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Columns, Given, Path, Quantity, Say, Value
from ..answer import Answer, answer


def inspect(
    file: Path | Columns,
    *,
    values: bool = False,
    spectrum: bool = False,
    harmonics: int | None = None,
    swings: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    time: int | str | None = None,
    time_unit: str | None = None,
    frame_rate: Value | None = None,
    angle: int | str | None = None,
    angular_velocity: int | str | None = None,
    angle_unit: str | None = None,
    counts_per_turn: Value | None = None,
    x: int | str | None = None,
    y: int | str | None = None,
    pivot: Given | None = None,
    uncertainty: int | str | None = None,
    gate: int | str | None = None,
    signal: int | str | None = None,
    from_: Value | None = None,
    to: Value | None = None,
    even_times: bool = False,
    times_as_written: bool = False,
    run: Given | None = None,
    sheet: int | str | None = None,
    delimiter: Literal["comma", "semicolon", "tab", "space"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    header: int | str | None = None,
    progress: Say = False,
) -> Answer:
    """The contents of a file of measurements: columns with quantities and units, faults, and the
    proposed fit.

    Everything is detected in the file; each finding names the option that overrides it, and the
    fits take the same options. Where a file leaves something open, it is described together with
    the options that would settle it.

    Parameters
    ----------
    file : str or path or columns
        File of the instrument: text, Excel, or an archive of text files; - for standard input.
    values : bool
        In JSON, list the numbers of all columns, and the rows that would be fitted in seconds and
        radians.
    spectrum : bool
        Measure the harmonics of the swings, each compared with that of the pendulum.
    harmonics : int, optional
        The highest harmonic [default: 7].
    swings : int, optional
        Number of swings in a window, at least three [default: 5].
    figure : str or path, optional
        Draw the spectrum with the pendulum's harmonics to FILE.svg, .pdf, .png or .json.
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
    time : int or str, optional
        Column of times, by number or name.
    time_unit : str, optional
        Unit of times: s, ms, us, min.
    frame_rate : float or str, optional
        Times are numbers of frames of a video, with this many frames per second.
    angle : int or str, optional
        Column of angles, by number or name.
    angular_velocity : int or str, optional
        Column of angular velocities, such as those of a gyroscope.
    angle_unit : str, optional
        Unit of angles or angular velocities: rad, deg, turn, rad/s, deg/s.
    counts_per_turn : float or str, optional
        Angles are encoder counts, with this many per turn.
    x : int or str, optional
        Column of horizontal positions, instead of an angle.
    y : int or str, optional
        Column of vertical positions.
    pivot : number or text, or several, optional
        Position of the pivot, in the unit of the positions, such as 0.1,1.5; otherwise a circle is
        fitted.
    uncertainty : int or str, optional
        Column of uncertainties of the angles or angular velocities.
    gate : int or str, optional
        Column of the photogate's state, 1 or blocked, 0 or unblocked.
    signal : int or str, optional
        Column of a continuous signal whose dips or peaks are passages, as of a light sensor or of
        an accelerometer along the string.
    from_ : float or str, optional
        Ignore rows before this time, on the clock of the file.
    to : float or str, optional
        Ignore rows after this time.
    even_times : bool
        Take the times in the file as rounded, and use the equally spaced times from which they
        come.
    times_as_written : bool
        Use the times as written, even if they look like rounded, equally spaced ones.
    run : number or text, or several, optional
        The run: its name, or its number as in ``Run #3``; several as 1,2,6.
    sheet : int or str, optional
        Sheet of a workbook or file of an archive, by number or name.
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the cells.
    decimal : {"point", "comma"}, optional
        Decimal point or decimal comma.
    header : int or str, optional
        Line that names the columns: detect, present, absent, or its number.
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
    >>> columns = {"t (s)": [0, 0.1, 0.2], "angle (deg)": [61, 55, 38]}
    >>> questions.inspect(columns).traces.rows.tolist()
    [3]
    """
    return answer(Answer, "inspect", locals())

"""`libration fit trace`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Columns, Given, Path, Quantity, Say, Value
from ..answer import answer
from ..fit import Fit


def fit_trace(
    files: Path | Columns | Sequence[Path | Columns],
    *,
    model: str | None = None,
    robust: bool = False,
    free_scale: bool = False,
    report: Path | None = None,
    figure: Path | None = None,
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
) -> Fit:
    """Measured swings: ω0, damping and gravity from angles or angular velocities in time, at any
    amplitude.

    The equation of motion θ″ = −ω0² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′| is integrated and fitted to
    all rows of all traces, which share ω0 and the damping; each has its own zero of the angle and
    its own start. Every cycle is also measured by itself, which tests the exact law of the period:
    T = T0·[1 + β(R − 1)] with β = 1.

    Parameters
    ----------
    files : str or path or columns, or several
        Recordings of the same pendulum: angle, angular velocity or position against time; - for
        standard input.
    model : str, optional
        Damping: auto to compare all kinds, or undamped, dry, linear, quadratic, or sums such as
        dry+linear [default: auto].
    robust : bool
        Give less weight to rows far from the fitted motion (robust fit).
    free_scale : bool
        Fit the scale of the angles too, from the dependence of the period on the amplitude.
    report : str or path, optional
        Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next
        to it.
    figure : str or path, optional
        Draw the data, the fitted motion and the residuals to FILE.svg, .pdf, .png or .json.
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
    return answer(Fit, "fit trace", locals())

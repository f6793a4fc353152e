"""`libration fit gates`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Columns, Given, Path, Say
from ..answer import answer
from ..fit import Fit


def fit_gates(
    file: Path | Columns,
    *,
    signals: Literal["edges", "passages"] | None = None,
    diameter: Given | None = None,
    shape: Literal["ball", "flag"] | None = None,
    gate_distance: Given | None = None,
    amplitude: Given | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Given | None = None,
    height: Given | None = None,
    length: Given | None = None,
    bob_radius: Given | None = None,
    bob_mass: Given | None = None,
    bob_density: Given | None = None,
    rod_mass: Given | None = None,
    rod_length: Given | None = None,
    air_density: Given | None = None,
    stretch: Given | None = None,
    angle_scale: Given | None = None,
    clock: Given | None = None,
    correlation: Given | None = None,
    linear: Given | None = None,
    time: Given | None = None,
    time_unit: Given | None = None,
    angle: Given | None = None,
    angular_velocity: Given | None = None,
    angle_unit: Given | None = None,
    counts_per_turn: Given | None = None,
    x: Given | None = None,
    y: Given | None = None,
    pivot: Given | None = None,
    uncertainty: Given | None = None,
    gate: Given | None = None,
    from_: Given | None = None,
    to: Given | None = None,
    even_times: bool = False,
    times_as_written: bool = False,
    run: Given | None = None,
    sheet: Given | None = None,
    delimiter: Literal["comma", "semicolon", "tab", "space"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    header: Given | None = None,
    progress: Say = False,
) -> Fit:
    """Times of a photogate: periods, T0 and gravity; double triggers and missed passages are
    detected.

    Parameters
    ----------
    file : str or path or columns
        Times of one photogate, optionally with its state (blocked or not); - for standard input.
    signals : {"edges", "passages"}, optional
        Meaning of the times: edges (blocked, free, …) or whole passages [default: detected from
        their pattern].
    diameter : number or text, optional
        Diameter of what passes the gate with its middle [default: the bob is what passes it, by its
        radius, cut where the gate is].
    shape : {"ball", "flag"}, optional
        Shape of what has this diameter: a ball, or a flat flag with edges parallel to the rod
        [default: ball].
    gate_distance : number or text, optional
        Distance of the gate from the pivot [default: the length of the pendulum].
    amplitude : number or text, optional
        Amplitude of the release, a quarter period before the first passage, such as 20deg.
    figure : str or path, optional
        Draw the periods against time to FILE.svg or FILE.png.
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : number or text, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : number or text, optional
        Height of the picture [default: chosen to suit the picture].
    length : number or text, optional
        From the pivot to the centre of the bob, with its uncertainty, such as 0.57m±0.004m: gives
        gravity.
    bob_radius : number or text, optional
        Radius of the bob, a sphere, such as 20.0(1)mm.
    bob_mass : number or text, optional
        Mass of the bob, such as 42.0g±0.5g.
    bob_density : number or text, optional
        Density of the bob, such as 7.85g/cm^3 [default: by its mass and radius].
    rod_mass : number or text, optional
        Mass of the rod or string.
    rod_length : number or text, optional
        From the pivot to the end of the rod [default: to the surface of the bob].
    air_density : number or text, optional
        Density of the air [default: 1.20(2)kg/m^3].
    stretch : number or text, optional
        Stretch of the string under the hanging bob.
    angle_scale : number or text, optional
        Relative uncertainty of the scale of all angles, such as 0.01 or 1%.
    clock : number or text, optional
        Relative uncertainty of the clock or frame rate, such as 0.1% where 29.97 frames/s may have
        been taken for 30.
    correlation : number or text, or several, optional
        Correlation coefficient of two inputs, such as length,bob-radius=0.9.
    linear : number or text, optional
        Coefficient of linear damping, such as 0.030(1)/s: the amplitude falls as exp(-b t/2)
        [default: not corrected].
    time : number or text, optional
        Column of times, by number or name.
    time_unit : number or text, optional
        Unit of times: s, ms, us, min.
    angle : number or text, optional
        Column of angles, by number or name.
    angular_velocity : number or text, optional
        Column of angular velocities, such as those of a gyroscope.
    angle_unit : number or text, optional
        Unit of angles or angular velocities: rad, deg, turn, rad/s, deg/s.
    counts_per_turn : number or text, optional
        Angles are encoder counts, with this many per turn.
    x : number or text, optional
        Column of horizontal positions, instead of an angle.
    y : number or text, optional
        Column of vertical positions.
    pivot : number or text, or several, optional
        Position of the pivot, in the unit of the positions, such as 0.1,1.5; otherwise a circle is
        fitted.
    uncertainty : number or text, optional
        Column of uncertainties of the angles or angular velocities.
    gate : number or text, optional
        Column of the photogate's state, 1 or blocked, 0 or unblocked.
    from_ : number or text, optional
        Ignore rows before this time, on the clock of the file.
    to : number or text, optional
        Ignore rows after this time.
    even_times : bool
        Take the times in the file to be rounded, and use the equally spaced ones they come from.
    times_as_written : bool
        Use the times as written, even where they look like rounded, equally spaced ones.
    run : number or text, or several, optional
        The run: its name, or its number as in ``Run #3``; several as 1,2,6.
    sheet : number or text, optional
        Sheet of a workbook or file of an archive, by number or name.
    delimiter : {"comma", "semicolon", "tab", "space"}, optional
        Separator of the cells.
    decimal : {"point", "comma"}, optional
        Decimal point or decimal comma.
    header : number or text, optional
        Line that names the columns: detect, present, absent, or its number.
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    Fit

    Raises
    ------
    UsageError
        What is given cannot be understood.
    NoAnswer
        There is no answer.
    Interrupted
        Ctrl-C; its ``partial`` is what there is of the answer.
    """
    return answer(Fit, "fit gates", locals())

"""`libration simulate`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Columns, Equation, Given, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def simulate(
    system: Equation,
    *,
    times: Given,
    set: Values | Sequence[str] | None = None,
    length: Value | None = None,
    gravity: Value | None = None,
    initial: Values | None = None,
    each: Path | Columns | None = None,
    tolerance: Value | None = None,
    events: Given | None = None,
    until: Given | None = None,
    direction: Literal["any", "rising", "falling"] | None = None,
    count: int | None = None,
    columns: Values | Sequence[str] | None = None,
    sensitivity: Given | None = None,
    no_errors: bool = False,
    figure: Path | None = None,
    axes: Given | None = None,
    animate: bool = False,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    output: Path | None = None,
    resume: Path | None = None,
    progress: Say = False,
) -> Answer:
    """The motion of any system in time: damped, driven, coupled, or given by its equations.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    times : number or text, or several
        Times START:STOP:STEP or t1,t2,…, in seconds or with a unit, leading away from 0, or
        ascending through it; negative ones run backward.
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    length : float or str, optional
        Length of the rods of a named pendulum, such as 1m or 57cm [default: see ``libration
        list``].
    gravity : float or str, optional
        Acceleration of free fall of a named pendulum, such as 9.81m/s^2.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    each : str or path or columns, optional
        One motion for each line of a CSV file (- for standard input) whose first line names
        parameters and initial values, and may have a column ``name``.
    tolerance : float or str, optional
        The relative error allowed in each step, for all coordinates or each by its name: 1e-12,
        "phi=1e-6", "1e-12, phi=1e-6" [default: 1e-12].
    events : number or text, or several, optional
        Find turning points (turning), crossings of the equilibrium (crossing), or zeros of a
        formula, such as theta-0.5.
    until : number or text, optional
        End the motion where a formula vanishes or two are equal, such as "x = 0" or theta-0.5;
        ``times`` limits the search.
    direction : {"any", "rising", "falling"}, optional
        Direction of the crossings that count for ``until``: rising, falling, or any [default: any].
    count : int, optional
        End the motion at the n-th crossing that counts for ``until`` [default: 1].
    columns : dict, optional
        Formulas of the state, the time t and the parameters as further columns, such as "energy =
        x'^2/2 - cos(x), p = 2*x'".
    sensitivity : number or text, or several, optional
        Derivatives of the motion with respect to parameters and initial values, as further columns,
        such as "c, theta": dtheta/dc, dtheta/dtheta(0).
    no_errors : bool
        Do not estimate the errors of the states, which saves time.
    figure : str or path, optional
        Draw the coordinates and the formulas of ``columns`` against time to FILE.svg, .pdf, .png or
        .json instead of listing the samples.
    axes : number or text, or several, optional
        Draw one state variable against another instead of the coordinates against time, such as
        theta,theta'.
    animate : bool
        Animate the bodies next to the curves (an SVG animation, for browsers).
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
    output : str or path, optional
        Write the output to a file, which is replaced only when complete, or to a stream; the
        extensions .json and .csv choose the format, - is standard output.
    resume : str or path, optional
        Continue an earlier run from its JSON output, or its CSV output with FILE.state; the new
        output includes the earlier one.
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
    >>> answer = questions.simulate("pendulum", initial={"theta": "60deg"}, times=[1, 2])
    >>> answer.samples.state[:, 0].round(9).tolist()
    [0.634361507, -0.30912778]
    """
    return answer(Answer, "simulate", locals())

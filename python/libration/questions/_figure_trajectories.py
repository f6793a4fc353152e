"""`libration figure trajectories`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Coordinate, Equation, Given, Quantity, Say, Value, Values
from ..picture import Picture, drawn


def figure_trajectories(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    length: Value | None = None,
    gravity: Value | None = None,
    initial: Values | Sequence[Values] | None = None,
    over: Values | Sequence[str] | None = None,
    from_: Value | None = None,
    to: Value | None = None,
    axis: Coordinate | None = None,
    axes: Given | None = None,
    spectrum: Coordinate | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Picture:
    """Motions of any system in one picture: against time, in the plane of two state variables, or
    their spectra.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    length : float or str, optional
        Length of the rods of a named pendulum, such as 1m or 57cm [default: see ``libration
        list``].
    gravity : float or str, optional
        Acceleration of free fall of a named pendulum, such as 9.81m/s^2.
    initial : dict, or several, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0; those not given start
        at rest; repeat the option for several motions.
    over : dict, optional
        A parameter and its values, with a motion for each, such as c=0.05,0.2,2 or A=1:1.2:0.1.
    from_ : float or str, optional
        The first time that is drawn, in seconds or with a unit [default: 0].
    to : float or str, optional
        The last time that is drawn [default: 60].
    axis : coordinate, optional
        The state variable that the picture shows [default: the first coordinate].
    axes : number or text, or several, optional
        Draw one state variable against another, such as theta,theta'.
    spectrum : coordinate, optional
        Draw the spectrum of a state variable, such as theta.
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
    Picture

    Raises
    ------
    UsageError
        An argument is not valid.
    NoAnswer
        There is no result.
    Interrupted
        Ctrl-C; its ``partial`` is the result up to then.
    """
    return drawn("figure trajectories", locals())

"""`libration figure series`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Given, Quantity, Say, Value, Values
from ..picture import Picture, drawn


def figure_series(
    oscillator: Equation | None = None,
    *,
    set: Values | Sequence[str] | None = None,
    about: Given | None = None,
    order: int | None = None,
    quantity: str | None = None,
    amplitudes: Given | None = None,
    to: Given | None = None,
    lowest: Value | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Picture:
    """The error of a perturbation series against the amplitude, with its radius of convergence, or
    against the number of terms.

    Parameters
    ----------
    oscillator : equation, optional
        A key of the catalogue, such as ``pendulum`` or ``van_der_pol``, or an equation, such as
        "x'' + x + x^3 = 0" or "\\ddot{x} + \\sin x = 0" [default: pendulum].
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    about : number or text, optional
        The equilibrium, if there are several [default: the stable one nearest to zero].
    order : int, optional
        The order of the expansion; partial sums are shown up to the powers 2, 4, 8, … below it
        [default: 33].
    quantity : str, optional
        The quantity that is expanded: period (T/T0), frequency (Ω/ω0), or a harmonic, such as a3
        [default: period].
    amplitudes : number or text, or several, optional
        Plot the error against the highest power of the partial sum instead, at these amplitudes,
        such as 30deg,90deg,150deg.
    to : number or text, optional
        The largest amplitude shown [default: a fifth beyond the radius of convergence].
    lowest : float or str, optional
        The smallest error shown [default: 1e-14].
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
    return drawn("figure series", locals())

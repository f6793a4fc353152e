"""`libration backbone`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Given, Path, Quantity, Say, Values
from ..answer import Answer, answer


def backbone(
    oscillator: Equation | None = None,
    *,
    amplitudes: Given,
    set: Values | Sequence[str] | None = None,
    about: Given | None = None,
    order: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """The frequency of an oscillator against its amplitude: from orbits, from the perturbation
    series, and exactly for the pendulum.

    Each orbit is a motion released from rest and integrated until it returns; its frequency comes
    with a bound on its error. Amplitudes are measured from the equilibrium; frequencies are in
    radians per unit of time.

    Parameters
    ----------
    oscillator : equation, optional
        A key of the catalogue, such as ``pendulum`` or ``van_der_pol``, or an equation, such as
        "x'' + x + x^3 = 0" or "\\ddot{x} + \\sin x = 0" [default: pendulum].
    amplitudes : number or text, or several
        Amplitudes START:STOP:STEP or a,b,…; with a unit if the variable is an angle.
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    about : number or text, optional
        The equilibrium, if there are several [default: the stable one nearest to zero].
    order : int, optional
        The order of the perturbation series [default: 9].
    figure : str or path, optional
        Draw the curves to FILE.svg, .pdf, .png or .json instead of listing the points.
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
    >>> backbone = questions.backbone("duffing", amplitudes=[0.5, 1.0], set={"epsilon": 1})
    >>> backbone.points.angular_frequency_rad_per_s.round(9).tolist()
    [1.089158179, 1.317776065]
    """
    return answer(Answer, "backbone", locals())

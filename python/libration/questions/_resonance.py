"""`libration resonance`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Equation, Given, Path, Quantity, Say, Value, Values
from ..answer import Answer, answer


def resonance(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    about: Values | None = None,
    initial: Values | None = None,
    order: int | None = None,
    small: Given | None = None,
    ratios: Given | None = None,
    resonance: Given | None = None,
    detuning: Value | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """Slow changes of the modes of a system near equilibrium: the normal form with its resonances,
    and the exchange of energy between modes.

    With aⱼ the complex amplitude of mode j, coordinates are xₑ + Re Σ aⱼφⱼ to first order. Terms
    that turn as fast as aⱼ stay in aⱼ′, exactly where the modes are exact; all others are removed,
    each divided by its divisor.

    With symbols in the equations the result is the slow flow of the coordinates as formulas, free
    or driven.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    about : dict, optional
        Coordinates near the equilibrium, such as x=1,theta=180deg; the others are taken at rest.
    initial : dict, optional
        Coordinates and velocities at the start, such as theta=60deg,theta'=0, or x[i]=sin(pi*i/33)
        for all of a chain; those not given start at rest.
    order : int, optional
        Highest order in the amplitudes [default: 3], or with symbols in the small parameters
        [default: the largest of these, and at least one at which all terms without small parameter
        act].
    small : number or text, or several, optional
        Small parameters with their orders, of equations with symbols, such as a:1,mu:2 [default:
        eps, if it occurs].
    ratios : number or text, optional
        Approximate ratios of the natural frequencies of equations with symbols, such as 1:2
        [default: those implied by equal symbols or numbers].
    resonance : number or text, optional
        Resonance of a drive cos(W*t) in equations with symbols: W = (P/Q)·ω, over the natural
        frequency of the first coordinate.
    detuning : float or str, optional
        Divisors below this fraction of the least frequency count as resonances [default: 0.1].
    figure : str or path, optional
        Draw the amplitudes in time to FILE.svg, .pdf, .png or .json instead of listing the terms;
        needs ``initial``.
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
    >>> resonance = questions.resonance("spring_pendulum", set={"kappa": 3}, order=2)
    >>> resonance.slow_terms.exact.tolist()
    ['9/32*sqrt(3)*i', '1/8*sqrt(3)*i']
    """
    return answer(Answer, "resonance", locals())

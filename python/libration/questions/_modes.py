"""`libration modes`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Coordinate, Equation, Given, Path, Quantity, Say, Values
from ..answer import Answer, answer


def modes(
    system: Equation,
    *,
    set: Values | Sequence[str] | None = None,
    about: Values | None = None,
    follow: int | None = None,
    amplitudes: Given | None = None,
    coordinate: Coordinate | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Answer:
    """The normal modes of a system about an equilibrium: frequencies and shapes, exact where
    possible, and their change with the amplitude.

    Shapes are scaled so that their largest part is 1. With a the amplitude of that coordinate, the
    frequency is Ω = ω + κa² as long as a is small.

    Parameters
    ----------
    system : equation
        A key from ``libration list``, or equations of motion, such as "x'' = y - x; y'' = x - y",
        or of the first order, such as "x' = x - x*y; y' = x*y - y".
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    about : dict, optional
        Coordinates near the equilibrium, such as x=1,theta=180deg; the others are taken at rest.
    follow : int, optional
        Follow the mode with this number, from 1, to large amplitudes, as periodic orbits with their
        stability.
    amplitudes : number or text, or several, optional
        Amplitudes of the followed mode: a list or a range, such as 10deg:90deg:10deg or 0.1,0.5.
    coordinate : coordinate, optional
        The coordinate of the amplitude [default: the first].
    figure : str or path, optional
        Draw the shapes to FILE.svg, .pdf, .png or .json.
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
    >>> questions.modes("double_pendulum").modes.exact_angular_frequency.tolist()
    ['sqrt(2 - sqrt(2))', 'sqrt(2 + sqrt(2))']
    """
    return answer(Answer, "modes", locals())

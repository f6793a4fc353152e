"""`libration figure errors`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Angle, Quantity, Say, Value
from ..picture import Picture, drawn


def figure_errors(
    *,
    formulas: str | Sequence[str] | None = None,
    from_: Angle | None = None,
    to: Angle | None = None,
    lowest: Value | None = None,
    highest: Value | None = None,
    near_top: bool = False,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Picture:
    """The errors of the formulas against the amplitude, as in the first figure of Black and Vel.

    Parameters
    ----------
    formulas : str, or several, optional
        Keys of formulas (``libration formulas`` lists them).
    from_ : angle, optional
        The amplitude at the left end [default: 0deg].
    to : angle, optional
        The amplitude at the right end [default: 180deg].
    lowest : float or str, optional
        The smallest error shown [default: 1e-8].
    highest : float or str, optional
        The largest error shown [default: 10].
    near_top : bool
        Add a panel with the errors against π − θ₀ on a logarithmic axis.
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

    Examples
    --------
    >>> from libration import questions
    >>> questions.figure_errors(formulas=["bernoulli"]).svg[:4]
    '<svg'
    """
    return drawn("figure errors", locals())

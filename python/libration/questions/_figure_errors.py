"""`libration figure errors`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Given, Say
from ..picture import Picture, drawn


def figure_errors(
    *,
    formulas: Given | None = None,
    from_: Given | None = None,
    to: Given | None = None,
    lowest: Given | None = None,
    highest: Given | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Given | None = None,
    height: Given | None = None,
    progress: Say = False,
) -> Picture:
    """The errors of the formulas against the amplitude, as in the first figure of Black and Vel.

    Parameters
    ----------
    formulas : number or text, or several, optional
        Keys of formulas (``libration formulas`` lists them).
    from_ : number or text, optional
        The amplitude at the left end [default: 0deg].
    to : number or text, optional
        The amplitude at the right end [default: 180deg].
    lowest : number or text, optional
        The smallest error shown [default: 1e-8].
    highest : number or text, optional
        The largest error shown [default: 10].
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : number or text, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : number or text, optional
        Height of the picture [default: chosen to suit the picture].
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

"""`libration figure phase`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Given, Quantity, Say
from ..picture import Picture, drawn


def figure_phase(
    *,
    amplitudes: Given | None = None,
    energies: Given | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    progress: Say = False,
) -> Picture:
    """The phase portrait: librations, the separatrix, and rotations.

    Parameters
    ----------
    amplitudes : number or text, or several, optional
        Amplitudes of the librations [default: 30deg,75deg,120deg,160deg].
    energies : float or str, or several, optional
        Energies of the rotations, E/(2mgl), each above 1 [default: 1.3,2].
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
    return drawn("figure phase", locals())

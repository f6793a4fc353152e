"""`libration fourier`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Angle, Path, Quantity, Say, Value
from ..answer import Answer, answer


def fourier(
    angle: Angle,
    *,
    velocity: Value | None = None,
    harmonics: int | None = None,
    tolerance: Value | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    length: Quantity | None = None,
    gravity: Quantity | None = None,
    progress: Say = False,
) -> Answer:
    """The Fourier coefficients of the angle and of the velocity.

    In libration θ(t) = Σ aₙ cos(nΩτ), where τ is the time since the positive turning point. In
    rotation θ(t) = mean velocity · τ + Σ aₙ sin(nΩτ), where τ is the time since the bottom.

    Parameters
    ----------
    angle : angle
        The starting angle, such as 60deg, 1.2rad or pi-1e-6.
    velocity : float or str, optional
        The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s [default:
        0rad/s].
    harmonics : int, optional
        Number of harmonics to list.
    tolerance : float or str, optional
        List all harmonics of the angle that are at least this large, in radians [default: 1e-16].
    figure : str or path, optional
        Draw the result to FILE.svg, .pdf, .png or .json.
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
    length : quantity, optional
        Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m].
    gravity : quantity, optional
        Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default:
        9.80665m/s^2].
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
    >>> questions.fourier("60deg", harmonics=2).harmonics.angle_rad.round(9).tolist()
    [1.05355417, -0.006425025]
    """
    return answer(Answer, "fourier", locals())

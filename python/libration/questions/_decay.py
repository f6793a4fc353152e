"""`libration decay`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Angle, Path, Quantity, Say, Value
from ..answer import Answer, answer


def decay(
    amplitude: Angle,
    *,
    dry: Value | None = None,
    linear: Value | None = None,
    quadratic: Value | None = None,
    cubic: Value | None = None,
    power: str | Sequence[str] | None = None,
    cycles: int | None = None,
    until: Value | None = None,
    order: int | None = None,
    damping_order: int | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Quantity | None = None,
    height: Quantity | None = None,
    no_title: bool = False,
    curve_labels: bool = False,
    angles: Literal["degrees", "radians"] | None = None,
    length: Quantity | None = None,
    gravity: Quantity | None = None,
    omega0: Value | None = None,
    progress: Say = False,
) -> Answer:
    """The decay of a damped pendulum, cycle by cycle.

    The amplitudes are found by integrating θ″ + Σ cₙ θ′|θ′|ⁿ⁻¹ + ω0² sin θ = 0. They are compared
    with the averaged law, in which the energy falls at its mean rate over an undamped cycle (exact
    at any amplitude), and with the small-amplitude law. The duration of each cycle is compared with
    the exact period at the amplitude in its middle.

    Parameters
    ----------
    amplitude : angle
        The release angle, such as 60deg, 1.2rad or pi-1e-6.
    dry : float or str, optional
        Dry friction, a constant deceleration in rad/s².
    linear : float or str, optional
        Viscous damping, proportional to the velocity, in 1/s.
    quadratic : float or str, optional
        Damping proportional to the square of the velocity, in 1/rad.
    cubic : float or str, optional
        Damping proportional to the cube of the velocity, in s/rad².
    power : str, or several, optional
        Damping proportional to any power of the velocity, such as 1.5:0.1; may be given several
        times.
    cycles : int, optional
        Number of cycles to follow, if the motion lasts that long [default: 20].
    until : float or str, optional
        Follow the cycles completed by this time, such as 60s; plain numbers are seconds.
    order : int, optional
        Compare with the slow flow too, up to this power of the amplitude (for whole powers of the
        velocity).
    damping_order : int, optional
        Power of the damping to which the slow flow is expanded [default: 2].
    figure : str or path, optional
        Draw amplitude and period against time to FILE.svg, .pdf, .png or .json instead of listing
        the cycles.
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
    omega0 : float or str, optional
        The frequency ω0 = √(g/l) of small swings, such as 1rad/s, instead of length and gravity.
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
    >>> decay = questions.decay("60deg", linear=0.1, cycles=1)
    >>> decay.turning_points.amplitude_rad.round(6).tolist()
    [1.047198, 0.989369, 0.935463]
    """
    return answer(Answer, "decay", locals())

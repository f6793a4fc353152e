"""`libration decay`. Written by scripts/questions."""

from __future__ import annotations

from typing import Literal

from .._ask import Given, Path, Say
from ..answer import Answer, answer


def decay(
    amplitude: Given,
    *,
    dry: Given | None = None,
    linear: Given | None = None,
    quadratic: Given | None = None,
    cubic: Given | None = None,
    power: Given | None = None,
    cycles: Given | None = None,
    until: Given | None = None,
    order: Given | None = None,
    damping_order: Given | None = None,
    figure: Path | None = None,
    size: Literal["page", "column", "slide"] | None = None,
    width: Given | None = None,
    height: Given | None = None,
    length: Given | None = None,
    gravity: Given | None = None,
    omega0: Given | None = None,
    progress: Say = False,
) -> Answer:
    """The decay of a damped pendulum, cycle by cycle.

    The amplitudes are found by integrating θ″ + Σ cₙ θ′|θ′|ⁿ⁻¹ + ω0² sin θ = 0. They are compared
    with the averaged law, in which the energy falls at its mean rate over an undamped cycle (exact
    at any amplitude), and with the small-amplitude law. The duration of each cycle is compared with
    the exact period at the amplitude in its middle.

    Parameters
    ----------
    amplitude : number or text
        The release angle, such as 60deg, 1.2rad or pi-1e-6.
    dry : number or text, optional
        Dry friction, a constant deceleration in rad/s².
    linear : number or text, optional
        Viscous damping, proportional to the velocity, in 1/s.
    quadratic : number or text, optional
        Damping proportional to the square of the velocity, in 1/rad.
    cubic : number or text, optional
        Damping proportional to the cube of the velocity, in s/rad².
    power : number or text, or several, optional
        Damping proportional to any power of the velocity, such as 1.5:0.1; may be given several
        times.
    cycles : number or text, optional
        Number of cycles to follow, if the motion lasts that long [default: 20].
    until : number or text, optional
        Follow the cycles completed by this time, such as 60s; plain numbers are seconds.
    order : number or text, optional
        Compare with the slow flow too, its amplitude law to this power of the amplitude (whole
        powers of the velocity).
    damping_order : number or text, optional
        Power of the damping to which the slow flow is expanded [default: 2].
    figure : str or path, optional
        Draw amplitude and period against time to FILE.svg or FILE.png instead of listing the
        cycles.
    size : {"page", "column", "slide"}, optional
        Size of the picture: the text width of a page (170 mm), a column (80 mm), or a slide with
        larger type [default: page].
    width : number or text, optional
        Width of the picture, such as 120mm, 12cm or 600px (96 px per inch) [default: set by
        ``size``].
    height : number or text, optional
        Height of the picture [default: chosen to suit the picture].
    length : number or text, optional
        Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m].
    gravity : number or text, optional
        Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default:
        9.80665m/s^2].
    omega0 : number or text, optional
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

"""`libration fourier`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Given, Say
from ..answer import Answer, answer


def fourier(
    angle: Given,
    *,
    velocity: Given | None = None,
    harmonics: Given | None = None,
    tolerance: Given | None = None,
    length: Given | None = None,
    gravity: Given | None = None,
    progress: Say = False,
) -> Answer:
    """The Fourier coefficients of the angle and of the velocity.

    In libration θ(t) = Σ aₙ cos(nΩτ), where τ is the time since the positive turning point. In
    rotation θ(t) = mean velocity · τ + Σ aₙ sin(nΩτ), where τ is the time since the bottom.

    Parameters
    ----------
    angle : number or text
        The starting angle, such as 60deg, 1.2rad or pi-1e-6.
    velocity : number or text, optional
        The starting velocity, such as 0.3rad/s or 20deg/s; plain numbers are rad/s [default:
        0rad/s].
    harmonics : number or text, optional
        Number of harmonics to list.
    tolerance : number or text, optional
        List all harmonics of the angle that are at least this large, in radians [default: 1e-16].
    length : number or text, optional
        Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m].
    gravity : number or text, optional
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

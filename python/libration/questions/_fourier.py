"""`libration fourier`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Angle, Quantity, Say, Value
from ..answer import Answer, answer


def fourier(
    angle: Angle,
    *,
    velocity: Value | None = None,
    harmonics: int | None = None,
    tolerance: Value | None = None,
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

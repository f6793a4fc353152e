"""`libration plan`. Written by scripts/questions."""

from __future__ import annotations

from .._ask import Angle, Given, Quantity, Say, Value
from ..answer import Answer, answer


def plan(
    *,
    g_to: Value,
    length: Quantity,
    angle_noise: Angle,
    rate: Value,
    amplitudes: Given | None = None,
    linear: Quantity | None = None,
    angle_scale: Value | None = None,
    clock: Value | None = None,
    gravity: Value | None = None,
    progress: Say = False,
) -> Answer:
    """Plan a measurement of g: amplitude of release, number of swings, uncertainty of the length.

    The rows have independent errors of the angle, and a fit finds ω0, damping and start from them,
    as ``libration fit trace --model linear`` does; without a model the fit does not know the law of
    damping either, and its uncertainties for few swings are about half as large again. The
    uncertainty of ω0 is the Cramér–Rao bound; length, clock and the scale of the angles add their
    parts, as in the budget of the measurement.

    Parameters
    ----------
    g_to : float or str
        The target relative standard uncertainty of g, such as 1e-3 or 0.1%.
    length : quantity
        Distance from the pivot to the centre of the bob, with its uncertainty, such as 1.0000(5)m.
    angle_noise : angle
        Standard deviation of the angle in a row, such as 0.2deg.
    rate : float or str
        Rows per second, such as 60.
    amplitudes : number or text, or several, optional
        Amplitudes to choose from, such as 5deg,20deg or 5deg:60deg:5deg [default:
        5deg,10deg,15deg,20deg,30deg,45deg,60deg,90deg].
    linear : quantity, optional
        Coefficient of linear damping, such as 0.03/s: the amplitude falls as exp(-b t/2) [default:
        none].
    angle_scale : float or str, optional
        Relative uncertainty of the scale of all angles [default: 1%].
    clock : float or str, optional
        Relative uncertainty of the clock or frame rate [default: 0].
    gravity : float or str, optional
        Approximate acceleration of free fall [default: 9.80665m/s^2].
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
    >>> plan = questions.plan(g_to=1e-3, length="1.0000(5)m", angle_noise="0.2deg", rate=60)
    >>> plan.advice.tolist()
    ['release at 15 degrees and record 2 swings, 4.03 s']
    """
    return answer(Answer, "plan", locals())

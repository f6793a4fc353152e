"""`libration expand`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence

from .._ask import Equation, Given, Say, Values
from ..answer import Answer, answer


def expand(
    oscillator: Equation | None = None,
    *,
    set: Values | Sequence[str] | None = None,
    about: Given | None = None,
    letters: Given | None = None,
    order: int | None = None,
    gauge: str | None = None,
    damping_order: int | None = None,
    small: Given | None = None,
    resonance: Given | None = None,
    evaluate: Given | None = None,
    quantity: str | None = None,
    progress: Say = False,
) -> Answer:
    """Exact series for an oscillator's frequency, harmonics and period, to any order.

    Periodic motions are expanded by Lindstedt and Poincaré's method in a parameter ε whose meaning,
    the gauge, can be chosen; frequency, period and harmonics are also given as functions of the
    amplitude, which is the same in every gauge. Self-excited oscillators with an open parameter,
    such as ``van_der_pol``, are expanded in that parameter. Other parameters without a value are
    symbolic: the coefficients are then polynomials in them.

    A force in proportion to one power of the displacement, such as x^3 or x*abs(x), has no small
    oscillations to expand about; the result is then its scaling law, Ω = C·√k·A^((p−1)/2) with the
    exact C, and its harmonics, which are the same at all amplitudes.

    Under weak damping or excitation of symbolic strength, the result is the slow flow: A′, the rate
    of the amplitude, and ψ′, the rate of the phase, as polynomials in the amplitude and the
    strength, with the motion x(A, ψ). Powers of the velocity may be even, x'*abs(x'), and zero,
    sign(x'). Where a limit cycle has no expansion in a symbolic strength, the slow flow is the
    result without ``damping_order`` too.

    Parameters
    ----------
    oscillator : equation, optional
        A key of the catalogue, such as ``pendulum`` or ``van_der_pol``, or an equation, such as
        "x'' + x + x^3 = 0" or "\\ddot{x} + \\sin x = 0" [default: pendulum].
    set : dict, optional
        The value of a parameter: a number, or a formula such as 1/2; may be given several times.
    about : number or text, optional
        The equilibrium, if there are several [default: the stable one nearest to zero].
    letters : number or text, or several, optional
        Symbolic parameters of a built-in oscillator, separated by commas.
    order : int, optional
        The highest power of the expansion parameter [default: 7; 31 with ``evaluate``, 15 if no
        powers vanish].
    gauge : str, optional
        Meaning of the expansion parameter [default: fundamental, of a slow flow ``x_max``].
    damping_order : int, optional
        Give the slow flow under weak damping or excitation to this power of its strength [default:
        2].
    small : number or text, or several, optional
        The symbol of this strength, if several have no value or the system is a named one; for a
        slow flow with symbols, small parameters with their orders, such as a2:1,a3:2,mu:2,F:2
        [default: eps, if it occurs].
    resonance : number or text, optional
        Give the slow flow of a driven oscillator near W = (P/Q)·ω0, drive over natural frequency:
        1/1 primary, 1/3 superharmonic, 3/1 subharmonic resonance.
    evaluate : number or text, optional
        Evaluate the series term by term at this amplitude, the largest displacement from the
        equilibrium, such as 0.5, or 40deg if the variable is an angle; for a limit cycle, at this
        value of its parameter.
    quantity : str, optional
        The quantity to evaluate: period (T/T0), frequency (Ω/ω0), or a harmonic, such as a3, the
        coefficient of cos 3Ωt or sin 3Ωt [default: period].
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
    >>> questions.expand("duffing", order=3)["frequency_ratio"]
    ['1', '0', '3/8']
    """
    return answer(Answer, "expand", locals())

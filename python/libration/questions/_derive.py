"""`libration derive`. Written by scripts/questions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from .._ask import Angle, Equation, Given, Path, Quantity, Say, Values, text


def derive(
    oscillator: Equation | None = None,
    *,
    method: Literal["elliptic", "short", "formulas", "perturbation", "averaging", "limit-cycle"],
    order: int | None = None,
    damping_order: int | None = None,
    small: Given | None = None,
    resonance: Given | None = None,
    gauge: str | None = None,
    set: Values | Sequence[str] | None = None,
    about: Given | None = None,
    amplitude: Angle | None = None,
    length: Quantity | None = None,
    gravity: Quantity | None = None,
    exercises: bool = False,
    answer: Given | None = None,
    format: Literal["markdown", "latex", "html", "ipynb"] | None = None,
    output: Path | None = None,
    progress: Say = False,
) -> str:
    """A worked derivation, step by step, with each formula checked by computing it.

    Each formula is followed by how it was checked: exactly in fractions, or to 77 digits at several
    amplitudes. With ``amplitude`` each step also shows its numbers for that pendulum.

    Parameters
    ----------
    oscillator : equation, optional
        Series: a key of the catalogue, such as duffing, or an equation [default: pendulum, for
        averaging ``damped_pendulum``, for limit-cycle ``van_der_pol``].
    method : {"elliptic", "short", "formulas", "perturbation", "averaging", "limit-cycle"}
        The derivation.
    order : int, optional
        Series: the highest power of the expansion parameter or amplitude, up to 9 [default: 5, of a
        limit cycle 4].
    damping_order : int, optional
        Averaging: the highest power of the small parameter, 1 to 4 [default: 2]; with several
        symbols or a drive 1 or 2 [default: the lowest that acts, and that of each symbol].
    small : number or text, optional
        Averaging, limit-cycle: the small symbol, if several have no value, or small symbols with
        orders, such as mu:1,F:1.
    resonance : number or text, optional
        Averaging: the resonance of a drive with W = (P/Q)·ω0, drive over natural frequency.
    gauge : str, optional
        Perturbation: meaning of the expansion parameter, such as energy or A1=1,A3=-1 [default:
        fundamental].
    set : dict, optional
        Series: the value of a parameter; may be given several times.
    about : number or text, optional
        Perturbation: the equilibrium, if there are several.
    amplitude : angle, optional
        Show the numbers at this amplitude, such as 40deg; for other oscillators, a plain number.
    length : quantity, optional
        Length of the pendulum, such as 1m or 57cm; plain numbers are metres [default: 1m].
    gravity : quantity, optional
        Acceleration of free fall, such as 9.81m/s^2; plain numbers are m/s² [default:
        9.80665m/s^2].
    exercises : bool
        Leave out the results, as exercises, and give them as solutions at the end.
    answer : number or text, optional
        Compare an answer to an exercise: the number of the formula, and the formula for its
        question mark, such as ``3.1=omega0^2*(1-theta0^2/8)``.
    format : {"markdown", "latex", "html", "ipynb"}, optional
        Format of the derivation [default: markdown].
    output : str or path, optional
        Write to this file instead of standard output.
    progress : bool or callable
        True for a line of progress, where tqdm is installed; or a function of a text.

    Returns
    -------
    str

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
    >>> print(questions.derive(method="elliptic").splitlines()[0])
    # The period of a pendulum at any amplitude
    """
    return text("derive", locals(), progress)

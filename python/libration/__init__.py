"""The pendulum at any amplitude, and from there any nonlinear oscillator.

Angles are radians from the downward vertical, times seconds, lengths metres. Periods, states and elliptic functions (`libration.special`) are NumPy ufuncs.

>>> import numpy as np
>>> import libration as lb
>>> lb.period_ratio(np.radians([30, 60, 90])).round(6).tolist()
[1.017409, 1.073182, 1.180341]
"""

from . import errors, special
from ._native import (
    STANDARD_GRAVITY,
    __version__,
    motion,
    nome,
    period,
    period_excess,
    period_ratio,
    period_ratio_near_top,
    state,
)
from .errors import Interrupted, LibrationError
from .expansion import Evaluation, Expansion, GaugeSeries, Series, expand
from .pendulum import Harmonics, Motion, Pendulum, State
from .period_formulas import PeriodFormula, PeriodFormulas
from .polynomial import Polynomial
from .simulation import Events, Simulation, States, simulate

formulas = PeriodFormulas()

__all__ = [
    "Evaluation",
    "Events",
    "Expansion",
    "GaugeSeries",
    "Harmonics",
    "Interrupted",
    "LibrationError",
    "Motion",
    "Pendulum",
    "PeriodFormula",
    "PeriodFormulas",
    "Polynomial",
    "STANDARD_GRAVITY",
    "Series",
    "Simulation",
    "State",
    "States",
    "__version__",
    "errors",
    "expand",
    "formulas",
    "motion",
    "nome",
    "period",
    "period_excess",
    "period_ratio",
    "period_ratio_near_top",
    "simulate",
    "special",
    "state",
]

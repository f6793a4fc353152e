"""The pendulum at any amplitude, and from there any nonlinear oscillator.

Angles are radians from the downward vertical, times seconds, lengths metres. Periods, states and elliptic functions (`libration.special`) are NumPy ufuncs.

>>> import numpy as np
>>> import libration as lb
>>> lb.period_ratio(np.radians([30, 60, 90])).round(6).tolist()
[1.017409, 1.073182, 1.180341]
"""

from . import errors, figure, lab, questions, special
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
from .answer import Answer, Fields, Rows
from .derivation import Derivation, derive
from .errors import Interrupted, LibrationError
from .expansion import Evaluation, Expansion, GaugeSeries, Series, expand
from .pendulum import Harmonics, Motion, Pendulum, State
from .period_formulas import PeriodFormula, PeriodFormulas
from .picture import Picture
from .polynomial import Polynomial
from .published import Paper, paper
from .questions import backbone, bifurcation, decay, fields, fourier, lyapunov, melnikov, modes, orbit, oscillators, resonance, response, section, stability, systems
from .simulation import Events, Simulation, States, simulate
from .sweeps import sweep

formulas = PeriodFormulas()

__all__ = [
    "Answer",
    "Derivation",
    "Evaluation",
    "Events",
    "Expansion",
    "Fields",
    "GaugeSeries",
    "Harmonics",
    "Interrupted",
    "LibrationError",
    "Motion",
    "Paper",
    "Pendulum",
    "PeriodFormula",
    "PeriodFormulas",
    "Picture",
    "Polynomial",
    "Rows",
    "STANDARD_GRAVITY",
    "Series",
    "Simulation",
    "State",
    "States",
    "__version__",
    "backbone",
    "bifurcation",
    "decay",
    "derive",
    "errors",
    "expand",
    "fields",
    "figure",
    "formulas",
    "fourier",
    "lab",
    "lyapunov",
    "melnikov",
    "modes",
    "motion",
    "nome",
    "orbit",
    "oscillators",
    "paper",
    "period",
    "period_excess",
    "period_ratio",
    "period_ratio_near_top",
    "questions",
    "resonance",
    "response",
    "section",
    "simulate",
    "special",
    "stability",
    "state",
    "sweep",
    "systems",
]

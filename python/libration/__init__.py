"""The pendulum at any amplitude, and from there any nonlinear oscillator.

Angles are radians from the downward vertical, times seconds, lengths metres. Periods, states and
elliptic functions (`libration.special`) are NumPy ufuncs.

>>> import numpy as np
>>> import libration as lb
>>> lb.period_ratio(np.radians([30, 60, 90])).round(6).tolist()
[1.017409, 1.073182, 1.180341]
"""

from typing import TYPE_CHECKING

from . import _ufuncs, errors, special
from ._lazy import lazily
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

_ufuncs.describe()

if TYPE_CHECKING:
    from . import figure, lab, questions
    from .answer import Answer, Fields, Rows
    from .browser import page
    from .derivation import Derivation, derive
    from .expansion import Evaluation, Expansion, GaugeSeries, Series, expand
    from .pendulum import Harmonics, Motion, Pendulum, State
    from .period_formulas import PeriodFormula, PeriodFormulas, formulas
    from .picture import Picture
    from .polynomial import Polynomial
    from .published import Paper, paper
    from .questions import (
        backbone,
        bifurcation,
        decay,
        fields,
        fourier,
        list_,
        lyapunov,
        melnikov,
        modes,
        orbit,
        resonance,
        response,
        section,
        stability,
    )
    from .simulation import Events, Simulation, States, simulate
    from .sweeps import sweep
else:
    # Modules are imported when one of their names is used; `python/tests/test_imports.py` compares
    # this table with the imports above.
    __getattr__, __dir__ = lazily(
        __name__,
        {
            "answer": ["Answer", "Fields", "Rows"],
            "browser": ["page"],
            "derivation": ["Derivation", "derive"],
            "expansion": ["Evaluation", "Expansion", "GaugeSeries", "Series", "expand"],
            "figure": [],
            "fit": [],
            "lab": [],
            "pendulum": ["Harmonics", "Motion", "Pendulum", "State"],
            "period_formulas": ["PeriodFormula", "PeriodFormulas", "formulas"],
            "picture": ["Picture"],
            "polynomial": ["Polynomial"],
            "published": ["Paper", "paper"],
            "questions": [
                "backbone",
                "bifurcation",
                "decay",
                "fields",
                "fourier",
                "list_",
                "lyapunov",
                "melnikov",
                "modes",
                "orbit",
                "resonance",
                "response",
                "section",
                "stability",
            ],
            "simulation": ["Events", "Simulation", "States", "simulate"],
            "sweeps": ["sweep"],
        },
    )

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
    "list_",
    "lyapunov",
    "melnikov",
    "modes",
    "motion",
    "nome",
    "orbit",
    "page",
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
]

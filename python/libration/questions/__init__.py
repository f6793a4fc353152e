"""Every command as a function. Written by scripts/questions."""

from typing import TYPE_CHECKING

from .._lazy import lazily

if TYPE_CHECKING:
    from ._backbone import backbone
    from ._bifurcation import bifurcation
    from ._decay import decay
    from ._derive import derive
    from ._expand import expand
    from ._fields import fields
    from ._figure_errors import figure_errors
    from ._figure_motion import figure_motion
    from ._figure_phase import figure_phase
    from ._figure_series import figure_series
    from ._figure_spectrum import figure_spectrum
    from ._figure_trajectories import figure_trajectories
    from ._fit_amplitudes import fit_amplitudes
    from ._fit_gates import fit_gates
    from ._fit_lengths import fit_lengths
    from ._fit_periods import fit_periods
    from ._fit_response import fit_response
    from ._fit_trace import fit_trace
    from ._formulas import formulas
    from ._fourier import fourier
    from ._inspect import inspect
    from ._list_ import list_
    from ._lyapunov import lyapunov
    from ._melnikov import melnikov
    from ._modes import modes
    from ._motion import motion
    from ._orbit import orbit
    from ._paper import paper
    from ._period import period
    from ._plan import plan
    from ._resonance import resonance
    from ._response import response
    from ._section import section
    from ._simulate import simulate
    from ._stability import stability
    from ._sweep import sweep
    from ._sweep_join import sweep_join
    from ._sweep_status import sweep_status

__all__ = [
    "backbone",
    "bifurcation",
    "decay",
    "derive",
    "expand",
    "fields",
    "figure_errors",
    "figure_motion",
    "figure_phase",
    "figure_series",
    "figure_spectrum",
    "figure_trajectories",
    "fit_amplitudes",
    "fit_gates",
    "fit_lengths",
    "fit_periods",
    "fit_response",
    "fit_trace",
    "formulas",
    "fourier",
    "inspect",
    "list_",
    "lyapunov",
    "melnikov",
    "modes",
    "motion",
    "orbit",
    "paper",
    "period",
    "plan",
    "resonance",
    "response",
    "section",
    "simulate",
    "stability",
    "sweep",
    "sweep_join",
    "sweep_status",
]

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazily(__name__, {f"_{name}": [name] for name in __all__})

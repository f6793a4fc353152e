"""Pictures of the pendulum and of other systems, as the command draws them.

>>> import libration as lb
>>> picture = lb.figure.phase()
>>> picture.svg.startswith("<svg")
True
"""

from .questions import figure_errors as errors
from .questions import figure_motion as motion
from .questions import figure_phase as phase
from .questions import figure_series as series
from .questions import figure_spectrum as spectrum
from .questions import figure_trajectories as trajectories

__all__ = ["errors", "motion", "phase", "series", "spectrum", "trajectories"]

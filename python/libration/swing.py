"""A pendulum that swings in a notebook, drawn with the small swings of the same length.

It needs anywidget: ``pip install 'libration[notebook]'``.

Python calculates a period of the exact motion, and the script draws it, with a cubic between the
states; the only motion that is calculated in JavaScript is the cosine of small swings. A start
that is dragged goes back to Python, which sends another course. As an anywidget it runs in
Jupyter, VS Code, Colab and marimo without a build of its own; ``web/tests/swing.test.mjs`` runs
the script in a browser with a replacement for their model.

>>> import libration as lb
>>> swing = lb.Pendulum(length=0.994).release("150deg").swing()
>>> swing.caption
'libration of 150°: T = 3.52508 s, 76.22 % longer than small swings'
>>> swing.angle = 60
>>> swing.caption
'libration of 60°: T = 2.14677 s, 7.318 % longer than small swings'
"""

from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets

from . import _native
from .pendulum import Motion, Pendulum

__all__ = ["Swing"]


class Swing(anywidget.AnyWidget):
    """A pendulum that swings; `Motion.swing` makes it.

    The bob is drawn at the exact angles, in real time where a period takes between half a second
    and ten, and otherwise slowed down or sped up, as stated there.
    Dragging the bob, and the sliders below, set the start; the motion that follows is calculated
    here and drawn anew. A pale second pendulum follows the small-angle approximation.

    Raises
    ------
    PendulumError, QuantityError
        When a start is assigned that `Motion` refuses.
    """

    _esm = Path(__file__).with_name("swing.js")
    _css = Path(__file__).with_name("swing.css")

    angle = traitlets.CFloat(help="At t = 0, in degrees.").tag(sync=True)
    velocity = traitlets.CFloat(help="At t = 0, in rad/s.").tag(sync=True)
    caption = traitlets.Unicode(read_only=True, help="The regime, and the period.").tag(sync=True)
    _course = traitlets.Dict().tag(sync=True)

    def __init__(self, motion: Motion) -> None:
        self._motion = motion
        start = motion(0.0)
        # 60° in radians and back are 60.00000000000001.
        angle = round(float(np.degrees(start.angle)), 12)
        super().__init__(angle=angle, velocity=float(start.velocity))
        self._show(motion)
        self.observe(self._begin, ["angle", "velocity"])

    @property
    def motion(self) -> Motion:
        """The motion that is drawn."""
        return self._motion

    @property
    def pendulum(self) -> Pendulum:
        """The pendulum of the motion."""
        return self._motion.pendulum

    @traitlets.validate("angle", "velocity")
    def _check(self, proposal: Any) -> float:
        start = {"angle": self.angle, "velocity": self.velocity}
        self._moved(**{**start, proposal["trait"].name: proposal["value"]})
        return float(proposal["value"])

    def _begin(self, _: Any) -> None:
        self._show(self._moved(self.angle, self.velocity))

    def _moved(self, angle: float, velocity: float) -> Motion:
        # As text degrees are exact: 180 is the upright position.
        return Motion(self.pendulum, f"{angle!r}deg", velocity)

    def _show(self, motion: Motion) -> None:
        self._motion = motion
        with self.hold_sync():
            self.set_trait("caption", caption(motion))
            self._course = course(motion)

    def __repr__(self) -> str:
        return f"Swing({self.motion!r})"


def caption(motion: Motion) -> str:
    """The regime of a motion, and its period beside that of small swings."""
    if motion.regime == "rotation":
        return f"rotation: a turn takes {motion.period:.6g} s"
    if motion.regime == "separatrix":
        return "separatrix: it approaches the upright position, and never reaches it"
    if motion.amplitude is None:
        return motion.regime
    excess = 100 * float(_native.period_excess(motion.amplitude))
    amplitude = f"{np.degrees(motion.amplitude):.6g}°"
    period = f"T = {motion.period:.6g} s, {excess:.4g} % longer than small swings"
    return f"libration of {amplitude}: {period}"


def course(motion: Motion) -> dict[str, Any]:
    """Angles in radians and velocities in rad/s at equal steps, for the drawing of a motion.

    They cover a period, or the time until it hardly moves.
    A cubic between them leaves the motion by less than 1e-4 rad.
    """
    omega0 = motion.pendulum.angular_frequency
    turns = {"rotation": 1, "libration": 0}.get(motion.regime)
    span = motion.period if turns is not None else 16 / omega0
    # |θ⁗| is at most 3·ω0⁴ in libration, so that a step h leaves 3·(ω0·h)⁴/384: 1e-6 with 0.1/ω0,
    # and 5e-5 with the longest, of a period of 2800/ω0 next to the separatrix. A turn of a rotation
    # has 128 steps at least, which leave 1e-7.
    steps = int(np.clip(span * omega0 / 0.1, 128, 10_000))
    angle, velocity = motion(np.linspace(0, span, steps + 1))
    return {
        "span": span,
        "angles": angle.tolist(),
        "velocities": velocity.tolist(),
        "repeats": turns is not None,
        "advance": float(angle[-1] - angle[0]) if turns else 0.0,
        "small_angle_period": motion.pendulum.small_angle_period,
    }

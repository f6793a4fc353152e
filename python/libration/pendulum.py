"""One pendulum and its motions: swings, rotations, the separatrix, rest.

>>> import libration as lb
>>> pendulum = lb.Pendulum(length=0.994, gravity=9.81)
>>> motion = pendulum.release("60deg")
>>> round(motion.period, 12)
2.146406325771
>>> angle, velocity = motion(motion.period / 2)
>>> round(angle, 12)
-1.047197551197
"""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _native, _plot, questions
from ._numbers import Number, Numbers, NumberOrText, floats, number, real, whole
from ._record import Record, Shown, all_digits, arguments

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .swing import Swing

__all__ = ["Harmonics", "Motion", "Pendulum", "State"]


@dataclass(frozen=True)
class Pendulum(Shown):
    """A simple pendulum: a point mass on a massless rod.

    Parameters
    ----------
    length : float or str
        Length in metres, or a text with a unit, such as ``"99.4cm"``. That of a physical pendulum
        is its moment of inertia over mass times the distance from pivot to centre of mass.
    gravity : float or str
        Acceleration of free fall in m/s², or a text, such as ``"9.81m/s^2"``; the standard one if
        it is not given.

    Raises
    ------
    PendulumError
        A length or gravity that is not positive and finite, or √(gravity/length) outside 1e-290 to
        1e290 rad/s.

    Examples
    --------
    >>> import libration as lb
    >>> lb.Pendulum("99.4cm", 9.81)
    Pendulum(length=0.994, gravity=9.81)
    """

    length: float
    """The length in metres."""
    gravity: float = _native.STANDARD_GRAVITY
    """The acceleration of free fall in m/s²."""
    angular_frequency: float = field(init=False, repr=False, compare=False)
    """√(gravity/length), that of small swings, in rad/s."""
    small_angle_period: float = field(init=False, repr=False, compare=False)
    """2π√(length/gravity) in seconds."""

    if TYPE_CHECKING:

        def __init__(self, length: NumberOrText, gravity: NumberOrText = ...) -> None: ...

    def __post_init__(self) -> None:
        names = ("length", "gravity", "angular_frequency", "small_angle_period")
        length, gravity = number("length", self.length), number("gravity", self.gravity)
        for name, value in zip(names, _native.pendulum(length, gravity)):
            object.__setattr__(self, name, value)

    def _facts(self) -> list[tuple[str, object]]:
        return [
            ("length", f"{self.length} m"),
            ("gravity", f"{self.gravity} m/s²"),
            ("angular frequency of small swings", f"{self.angular_frequency} rad/s"),
            ("period of small swings", f"{self.small_angle_period} s"),
        ]

    def release(self, angle: NumberOrText) -> "Motion":
        """The motion released at rest at t = 0.

        Parameters
        ----------
        angle : float or str
            Radians, or a text such as ``"60deg"``, or ``"pi-1e-6"``, which keeps the distance from
            the top.

        Examples
        --------
        >>> import libration as lb
        >>> round(lb.Pendulum(1.0, 9.80665).release("pi-1e-300").period, 6)
        884.99739
        """
        return Motion(self, angle)

    def launch(self, angle: NumberOrText, velocity: NumberOrText) -> "Motion":
        """The motion that passes an angle with a velocity at t = 0.

        Parameters
        ----------
        angle : float or str
            Radians, or a text such as ``"60deg"``.
        velocity : float or str
            In rad/s, or a text such as ``"360deg/s"``.

        Examples
        --------
        >>> import libration as lb
        >>> lb.Pendulum(1.0, 9.80665).launch(0.0, 7.0).regime
        'rotation'
        """
        return Motion(self, angle, velocity)

    def to_dict(self, *amplitudes: NumberOrText) -> dict[str, Any]:
        """The periods at amplitudes, exact and by every formula: the JSON of `libration period`.

        Examples
        --------
        >>> import libration as lb
        >>> round(lb.Pendulum(1.0).to_dict("60deg")["results"][0]["ratio"], 9)
        1.073182007
        """
        return questions.period(amplitudes, length=self.length, gravity=self.gravity).to_dict()


class State(NamedTuple):
    """The angle and the velocity of a pendulum."""

    angle: Any
    """The angle in radians, unwrapped: it grows with each turn."""
    velocity: Any
    """The angular velocity in rad/s."""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, State):
            return NotImplemented
        return all(np.array_equal(one, it, equal_nan=True) for one, it in zip(self, other))

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __repr__(self) -> str:
        with all_digits():
            return f"State({arguments(self._asdict())})"


# In the class itself type checkers would take it for a third value.
setattr(State, "__hash__", None)


@dataclass(frozen=True, eq=False, repr=False)
class Harmonics(Record):
    """The harmonics of a motion, by ascending n.

    A swing is Σ angle·cos(nΩτ), a rotation ±Ωτ + Σ angle·sin(nΩτ), with τ = t - epoch; the velocity
    is -Σ velocity·sin(nΩτ), or mean_velocity + Σ velocity·cos(nΩτ).
    """

    fundamental: float
    """Ω in rad/s; 0 where there is no period."""
    mean_velocity: float
    """The mean velocity in rad/s: ±Ω in rotation, else 0."""
    epoch: float
    """Time in seconds of a positive turning point, in rotation of a passage of the bottom."""
    n: NDArray[np.int64]
    """Multiples of the fundamental."""
    angle: NDArray[np.float64]
    """Coefficients of the angle in rad, each to 0.56 ulp."""
    velocity: NDArray[np.float64]
    """Coefficients of the velocity in rad/s."""

    def __len__(self) -> int:
        return len(self.n)


@dataclass(frozen=True)
class Motion(Shown):
    """A motion of a pendulum, exact at any time; `Pendulum.release` and `Pendulum.launch` make it.

    Calling it with times in seconds, a number or an array of any shape, gives `State`, the angle in
    radians and the velocity in rad/s: 2.2 ulp of the angle and 4·2⁻⁵³·abs(velocity·t), likewise the
    velocity.

    Raises
    ------
    PendulumError, QuantityError
        A start that floating-point numbers cannot tell from the separatrix, or from the upright
        position; a velocity that is not finite, or above 2e150 times the angular frequency; a
        text that is not an angle.

    Examples
    --------
    >>> import numpy as np
    >>> import libration as lb
    >>> motion = lb.Pendulum(1.0, 9.80665).release("170deg")
    >>> motion(np.array([0.0, 1.0])).angle.round(6).tolist()
    [2.96706, 1.293229]
    """

    pendulum: Pendulum
    """The pendulum of the motion."""
    angle: float | str
    """At t = 0, as it was given: radians, or a text."""
    velocity: float | str = 0.0
    """At t = 0, as it was given: rad/s, or a text."""
    _motion: "_native.Motion" = field(init=False, repr=False, compare=False)

    if TYPE_CHECKING:

        def __init__(
            self, pendulum: Pendulum, angle: NumberOrText, velocity: NumberOrText = ...
        ) -> None: ...

    def __post_init__(self) -> None:
        of = self.pendulum
        if not isinstance(of, Pendulum):
            got = type(of).__name__
            raise TypeError(f"pendulum: got {got}: give a Pendulum, such as Pendulum(length=1.0)")
        angle, velocity = number("angle", self.angle), number("velocity", self.velocity)
        motion = _native.Motion(of.length, of.gravity, (angle, velocity))
        for name, value in (("angle", angle), ("velocity", velocity), ("_motion", motion)):
            object.__setattr__(self, name, value)

    def __reduce__(self) -> tuple[Any, ...]:
        return Motion, (self.pendulum, self.angle, self.velocity)

    def _facts(self) -> list[tuple[str, object]]:
        amplitude = [("amplitude", f"{self.amplitude} rad")] if self.amplitude is not None else []
        angle, velocity = self.angle, self.velocity
        return [
            ("regime", self.regime),
            ("angle at t = 0", angle if isinstance(angle, str) else f"{angle} rad"),
            ("velocity at t = 0", velocity if isinstance(velocity, str) else f"{velocity} rad/s"),
            *amplitude,
            ("period", f"{self.period} s"),
            ("pendulum", self.pendulum),
        ]

    @property
    def regime(self) -> str:
        """``"libration"``, ``"rotation"``, ``"separatrix"``, ``"rest (stable)"`` or
        ``"rest (upright)"``.
        """
        return self._motion.regime

    @property
    def period(self) -> float:
        """The period in seconds, of a rotation the time of a turn; infinite on the separatrix; at
        rest that of small swings, NaN upright.
        """
        return self._motion.period

    @property
    def amplitude(self) -> float | None:
        """The amplitude in radians, of a libration."""
        return self._motion.amplitude[0] if self._motion.amplitude else None

    @property
    def complement(self) -> float | None:
        """π minus the amplitude in radians, however small, of a libration."""
        return self._motion.amplitude[1] if self._motion.amplitude else None

    @property
    def energy_ratio(self) -> float:
        """E/(2mgl), counted from the bottom: 0 at stable rest, 1 on the separatrix."""
        return self._motion.energy_ratio[0]

    @property
    def energy_excess(self) -> float:
        """The energy ratio minus one, with all digits next to the separatrix."""
        return self._motion.energy_ratio[1]

    @property
    def action(self) -> float:
        """∮p dθ/2π per m·l², in rad²/s."""
        return self._motion.action

    def __call__(self, t: Numbers) -> State:
        times = floats("t", t)
        angle, velocity = self._motion.states_at(np.ravel(times))
        if times.ndim == 0:
            return State(float(angle[0]), float(velocity[0]))
        return State(angle.reshape(times.shape), velocity.reshape(times.shape))

    def harmonics(self, tolerance: Number = 1e-12, limit: int = 1000) -> Harmonics:
        """The harmonics whose coefficient of the angle is at least a tolerance (rad).

        Parameters
        ----------
        tolerance : float
            In radians.
        limit : int
            The largest number of harmonics.

        Examples
        --------
        >>> import libration as lb
        >>> harmonics = lb.Pendulum(1.0).release("60deg").harmonics(tolerance=1e-6)
        >>> harmonics.n.tolist()
        [1, 3, 5]
        """
        smallest, largest = real("tolerance", tolerance), whole("limit", limit, 1000)
        if not smallest >= 0:
            raise ValueError(f"tolerance: got {smallest}: give zero or more radians, such as 1e-12")
        if largest < 0:
            raise ValueError(
                f"limit: got {largest}: give the largest number of harmonics, such as 1000"
            )
        of_all, terms = self._motion.harmonics(smallest, largest)
        return Harmonics(*of_all, *terms)

    def to_dict(self, t: Numbers | None = None) -> dict[str, Any]:
        """The motion at the times given, or over a period: the JSON of `libration motion`."""
        times = None if t is None else floats("t", t).ravel()
        return questions.motion(
            self.angle,
            velocity=self.velocity,
            times=times,
            length=self.pendulum.length,
            gravity=self.pendulum.gravity,
        ).to_dict()

    def plot(self, ax: "Axes | None" = None, t: Numbers | None = None) -> "Axes":
        """Draws the angle in degrees against the time; over two periods, where no times are given.

        Returns
        -------
        matplotlib.axes.Axes
        """
        if t is None:
            has_period = np.isfinite(self.period)
            span = 2 * self.period if has_period else 10 / self.pendulum.angular_frequency
            t = np.linspace(0, span, 601)
        times = floats("t", t).ravel()
        ax = _plot.axes(ax, ("t / s", "θ / °"))
        ax.plot(times, np.degrees(self(times).angle))
        return ax

    def swing(self) -> "Swing":
        """The pendulum in a notebook, in real time, next to the small swings of the same length.

        It can be dragged to another start.

        Returns
        -------
        libration.swing.Swing
        """
        try:
            from .swing import Swing
        except ImportError as error:
            raise ImportError(
                "a pendulum in a notebook needs anywidget: pip install 'libration[notebook]'"
            ) from error
        return Swing(self)

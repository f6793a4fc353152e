"""Motions of any system in time: damped, driven, coupled, or given by its equations.

>>> import numpy as np
>>> import libration as lb
>>> sol = lb.simulate("double_pendulum", {"theta1": "120deg"}, times=np.linspace(0, 10, 101))
>>> sol.t.shape, sol["theta1"].shape, sol.names
((101,), (101,), ('theta1', 'theta2', "theta1'", "theta2'"))
>>> round(float(sol(5.0)["theta1"]), 9) == round(float(sol["theta1"][50]), 9)
True
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native, _plot, questions
from ._ask import Value, by_name
from ._equations import is_of_sympy, motion_of_sympy
from ._numbers import Number, Numbers, floats, real
from ._progress import Tell, go_on, told
from ._record import Record, Shown, all_digits, arguments
from .errors import NoAnswer, SimulationError

if TYPE_CHECKING:
    import pandas
    import sympy
    import xarray
    from matplotlib.axes import Axes

__all__ = ["Events", "Simulation", "States", "simulate"]


@dataclass(frozen=True, eq=False, repr=False)
class States(Record):
    """States at some times; ``states["theta"]`` is a number of each state by its name."""

    t: NDArray[np.float64]
    """The time in seconds, or in the unit of time of the equations."""
    y: NDArray[np.float64]
    """The last axis counts the numbers of a state."""
    names: tuple[str, ...]
    """Coordinates, then velocities: ``theta``, ``theta'``."""

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        try:
            return self.y[..., self.names.index(name)]
        except ValueError:
            known = ", ".join(self.names)
            raise KeyError(f"the state has no variable `{name}`: it has {known}") from None

    def __len__(self) -> int:
        return len(self.t)


@dataclass(frozen=True, eq=False, repr=False)
class Events(States):
    """The times and states of an event."""

    contact: tuple[str, ...]
    """Kind of the zero: "rising", "falling", "grazing" or "start"."""
    errors: NDArray[np.float64] | None = None
    """Estimated error of each number of ``y``; None without an estimate."""
    t_errors: NDArray[np.float64] | None = None
    """Estimated error of each time; None without an estimate."""


@dataclass(frozen=True, eq=False, repr=False)
class Simulation(States, Shown):
    """A motion; `simulate` makes it.

    Calling it with times between its ends, a number or an array of any shape, gives `States` there,
    as accurate as those at the requested times.
    """

    title: str
    """The name of the system."""
    equation: str
    """The equations of motion, with the values of their parameters."""
    units: tuple[str, ...]
    """Units of the components of a state; empty if they are not known."""
    events: dict[str, Events]
    """The events by their formulas."""
    steps: int
    """The number of steps."""
    end: float
    """The last time that was reached: that of the event that ended the motion, if one did."""
    success: bool
    """True if the motion reached its end: the last time, or its terminal event."""
    message: str
    """The end of the motion, in words."""
    errors: NDArray[np.float64] | None
    """Estimated error of each number of ``y``; NaN where the motion is not determined. None with
    ``errors=False`` and for states of more than 64 numbers."""
    determined_until: float | None
    """Time after which an error exceeds a tenth of the largest size of its number; None where none
    does."""
    _question: Any = field(repr=False, compare=False)
    _motion: Any = field(repr=False, compare=False)

    def _facts(self) -> list[tuple[str, object]]:
        if not len(self):
            last = []
        elif self.errors is None:
            last = [f"{name} = {value:.9g}" for name, value in zip(self.names, self.y[-1])]
        else:
            ends = zip(self.names, self.y[-1], self.errors[-1])
            last = [f"{name} = {_to_its_error(value, error)}" for name, value, error in ends]
        return [
            ("system", self.title),
            ("equations", self.equation),
            ("samples", len(self)),
            ("ended", self.message),
            ("last sample", ", ".join(last)),
        ]

    def __repr__(self) -> str:
        """The call that makes it, or how it ended early."""
        if not self.success:
            return f"<Simulation of {self.title}, {len(self)} states: {self.message}>"
        (system, values, start, looked_for, ending, tolerance), times = self._question
        is_directed = any(way != "any" for _, way in looked_for)
        events = dict(looked_for) if is_directed else [formula for formula, _ in looked_for]
        until = ending[0] if ending and ending[1] == "any" else ending
        optional = {"set": dict(values), "events": events, "until": until, "tolerance": tolerance}
        given = {"initial": dict(start), "times": _Times(times)}
        is_default: dict[str, Any] = {"set": {}, "events": [], "until": None, "tolerance": 1e-12}
        given |= {name: it for name, it in optional.items() if it != is_default[name]}
        return f"simulate({system!r}, {arguments(given)})"

    def __str__(self) -> str:
        return "\n".join(f"{name}: {value}" for name, value in self._facts())

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_motion": None}

    def __call__(self, t: Numbers) -> States:
        times = floats("t", t)
        motion = self._motion
        if motion is None:  # after a pickle
            question, given = self._question
            motion, _ = _native.simulate(question, given, False, None)
            object.__setattr__(self, "_motion", motion)
        states = motion.states_at(np.ravel(times))
        return States(times, states.reshape(*times.shape, len(self.names)), self.names)

    def to_pandas(self) -> "pandas.DataFrame":
        """The states at the requested times, by time."""
        import pandas

        columns = {name: self[name] for name in self.names}
        return pandas.DataFrame(columns, index=pandas.Index(self.t, name="t"))

    def to_xarray(self) -> "xarray.Dataset":
        """The states at the requested times, with their units."""
        import xarray

        columns = {
            name: ("t", self[name], {"units": unit} if unit else {})
            for name, unit in zip(self.names, self.units)
        }
        about = {"title": self.title, "equation": self.equation}
        return xarray.Dataset(columns, coords={"t": self.t}, attrs=about)

    def to_dict(self) -> dict[str, Any]:
        """The motion as `libration simulate` has it in JSON."""
        (system, values, start, looked_for, ending, tolerance), times = self._question
        if any(way != "any" for _, way in looked_for):
            raise NoAnswer(
                "the command finds events in both directions: "
                'leave out "rising" and "falling"'
            )
        until, direction = ending or (None, None)
        return questions.simulate(
            system,
            set=dict(values),
            initial=dict(start) or None,
            times=times,
            events=[formula for formula, _ in looked_for] or None,
            until=until,
            direction=direction,
            tolerance=tolerance,
            no_errors=self.errors is None,
        ).to_dict()

    def plot(self, *names: str, ax: "Axes | None" = None) -> "Axes":
        """Draws numbers of the state against the time: the coordinates, if no names are given."""
        chosen = names or tuple(name for name in self.names if not name.endswith("'"))
        units = {self.units[self.names.index(name)] for name in chosen if name in self.names}
        unit = f" / {units.pop()}" if len(units) == 1 and "" not in units else ""
        ax = _plot.axes(ax, ("t", ", ".join(chosen) + unit))
        for name in chosen:
            ax.plot(self.t, self[name], label=name)
        if len(chosen) > 1:
            _plot.legend(ax)
        return ax


class _ByFormula(dict[str, Events]):
    """The events by their formulas; an unknown formula is refused with those that are known."""

    def __missing__(self, formula: str) -> Events:
        known = ", ".join(self) or "none"
        raise KeyError(f"the event `{formula}` was not looked for: there are {known}")


class _Times:
    """Times as they are printed: evenly spaced ones by their ends."""

    def __init__(self, times: NDArray[np.float64]) -> None:
        self.times = times

    def __repr__(self) -> str:
        first, last = self.times[[0, -1]].tolist() if len(self.times) else (0.0, 0.0)
        even = np.linspace(first, last, len(self.times))
        if len(self.times) > 5 and np.array_equal(self.times, even):
            return f"linspace({first!r}, {last!r}, {len(self.times)})"
        with all_digits():
            return repr(self.times if len(self.times) > 1000 else self.times.tolist())


def simulate(
    system: "str | sympy.Eq | sympy.Expr | list[sympy.Eq | sympy.Expr]",
    initial: Mapping[str, Value],
    times: Numbers,
    *,
    set: Mapping[str, Value] | None = None,
    events: str | Iterable[str] | Mapping[str, str] = (),
    until: str | tuple[str, str] | None = None,
    tolerance: Number = 1e-12,
    errors: bool = True,
    progress: bool | Tell = False,
) -> Simulation:
    """The motion of a system of ordinary differential equations, by Taylor series of high order.

    Parameters
    ----------
    system : str or sympy.Eq or sympy.Expr, or a list of these of SymPy
        A key of a catalogue, such as ``"double_pendulum"``, ``"damped_pendulum"``, ``"lorenz"`` or
        ``"duffing"``, or equations, such as ``"x'' + 0.1*x' + sin(x) = cos(t)"``, several with
        ``;`` between them; or one of SymPy for a function of one symbol, which is the time; or a
        list with one for each function.
    initial : dict
        Values at t = 0 by name, such as ``{"theta": "60deg", "theta'": 1.5}``: numbers, formulas,
        angles or quantities as text; ``{"x[i]": "sin(pi*i/33)"}`` for all of a chain. What is not
        given is at rest.
    times : array_like
        The times of the states: away from 0 in one direction, or ascending on both sides of it.
        A number is one time.
    set : dict
        Values of parameters: numbers, fractions, or formulas such as ``"1/2"``.
    events : str or list of str or dict
        Formulas whose zeros are events, such as ``"theta'"`` or ``"x = 0.5"``; in a dict with
        what counts, "rising", "falling" or "any".
    until : str or tuple
        The formula whose first zero ends the motion, and what counts.
    tolerance : float
        Relative error of a step, from 1e-18 to 0.1.
    errors : bool
        Whether the errors of all states are estimated; False saves the time for that.
    progress : bool or callable
        True for a bar, where tqdm is installed; or a function of how much is done and of how much,
        in thousandths of the time.

    Returns
    -------
    Simulation

    Raises
    ------
    SimulationError
        Invalid equations, names or times; a motion that stops at a singularity, whose part
        until there is the exception's ``partial``.
    UsageError
        What of SymPy has no formula, such as a delay; names that formulas read as something else.
    Interrupted
        Ctrl-C; its ``partial`` is the motion until then.

    Examples
    --------
    >>> import libration as lb
    >>> sol = lb.simulate("theta'' + sin(theta) = 0", {"theta": "90deg"}, [10.0], events=["theta"])
    >>> sol.events["theta"].t.round(9).tolist()
    [1.854074677, 5.562224032, 9.270373387]
    >>> bool(sol.errors[0].max() < 1e-11)
    True
    """
    if hasattr(system, "free_symbols") or is_of_sympy(system):
        system = motion_of_sympy(system).text
    if not isinstance(system, str):
        raise TypeError(
            f"system: got {type(system).__name__}: give the name of a system, or its equations as "
            "text, such as \"x'' + sin(x) = 0\", or an equation or a list of them as SymPy has it"
        )
    wanted = np.atleast_1d(floats("times", times))
    if wanted.ndim != 1:
        dimensions = f"the times have {wanted.ndim} dimensions"
        raise SimulationError(f"{dimensions}: give a number or a list of them")
    values, start = by_name("set", set), by_name("initial", initial)
    looked_for, ending = _looked_for(events), None if until is None else _ending(until)
    error = real("tolerance", tolerance)
    if not 1e-18 <= error <= 0.1:
        reason = f"got {error:g}: give a number from 1e-18 to 0.1, such as 1e-12"
        raise SimulationError(f"tolerance: {reason}")
    question = (system, values, start, list(looked_for.items()), ending, error)
    with told(progress, "simulate") as tell:
        contiguous = np.ascontiguousarray(wanted)
        motion, stopped_by = _native.simulate(question, contiguous, errors, tell)
    names = list(looked_for) + ([ending[0]] if ending else [])
    simulation = _simulation(motion, names, (question, wanted), stopped_by)
    if isinstance(stopped_by, SimulationError):
        stopped_by.partial = simulation
    go_on(stopped_by, simulation)
    return simulation


def _looked_for(events: Any) -> dict[str, str]:
    """The direction and kind of each event that counts."""
    is_one = isinstance(events, str) or not np.iterable(events)
    is_directed = isinstance(events, Mapping)
    found = dict(events) if is_directed else dict.fromkeys([events] if is_one else events, "any")
    if not all(isinstance(it, str) for pair in found.items() for it in pair):
        raise TypeError(
            f"events: got {events!r}: give formulas as text, such as [\"theta = 0\"], "
            'or with what counts, {"theta": "rising"}'
        )
    return found


def _ending(until: Any) -> tuple[str, str]:
    """The event that ends the motion, and what counts."""
    pair = (until, "any") if isinstance(until, str) else until
    is_pair = isinstance(pair, (tuple, list)) and len(pair) == 2
    if not is_pair or not all(isinstance(it, str) for it in pair):
        raise TypeError(
            f"until: got {until!r}: give a formula as text, such as \"theta = 0\", "
            'or with what counts, ("theta", "rising")'
        )
    return pair[0], pair[1]


def _to_its_error(value: float, error: float) -> str:
    """A number to the digit that its error begins with, and to nine digits at most."""
    if np.isnan(error):
        return "not determined"
    if value == 0 or error == 0:
        return f"{value:.9g}"
    digits = int(np.floor(np.log10(abs(value))) - np.floor(np.log10(error))) + 1
    return f"{value:.{min(digits, 9)}g}" if digits > 0 else "0"


def _simulation(
    motion: Any, looked_for: list[str], question: Any, stopped_by: BaseException | None
) -> Simulation:
    title, equation, names, units, steps, end = motion.words()
    t, y = motion.samples()
    errors, of_times, of_states, until = motion.errors() or (None, None, None, None)
    happened = motion.events()
    events = _ByFormula()
    for number, text in enumerate(looked_for):
        places = [place for place, it in enumerate(happened) if it[0] == number]
        own = [happened[place][1:] for place in places]
        states = np.array([it[1] for it in own]).reshape(len(own), len(names))
        contact = tuple(it[2] for it in own)
        events[text] = Events(
            np.array([it[0] for it in own]),
            states,
            tuple(names),
            contact,
            errors=None if of_states is None else of_states[places],
            t_errors=None if of_times is None else of_times[places],
        )
    return Simulation(
        t=t,
        y=y,
        names=tuple(names),
        title=title,
        equation=equation,
        units=tuple(units),
        events=events,
        steps=steps,
        end=end,
        success=stopped_by is None,
        message=str(stopped_by or f"it reached t = {end!r}"),
        errors=errors,
        determined_until=until,
        _question=question,
        _motion=motion,
    )

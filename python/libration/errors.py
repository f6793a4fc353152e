"""Exceptions, with the library's messages: the value received, the reason, and what would work."""

from collections.abc import Sequence
from typing import Any

__all__ = [
    "ExpansionError",
    "FormulaError",
    "Interrupted",
    "LibrationError",
    "MissingFile",
    "NoAnswer",
    "PendulumError",
    "QuantityError",
    "SimulationError",
    "UnknownKeyError",
    "UsageError",
]


class LibrationError(ValueError):
    """The base class of the exceptions of this package."""

    parameters: Sequence[str] = ()
    """The names in Python of the arguments that the error is about; may be empty."""
    item: str | None = None
    """The name of the value that it is about, in an argument that has several, such as
    ``set={"c": ...}``; else None.
    """
    hint: str | None = None
    """A call that has a result instead of this one; None where none is known."""
    suggestion: str | None = None
    """A value of the argument that would work; None where none is known."""

    @property
    def parameter(self) -> str | None:
        """The first of the `parameters`, or None."""
        return self.parameters[0] if self.parameters else None


class ExpansionError(LibrationError):
    """An equation that does not describe an oscillator, or an expansion that it does not have."""


class FormulaError(LibrationError):
    """A request that no period formula meets."""


class NoAnswer(LibrationError):
    """A valid query without a result; a file that cannot be read or written."""


class MissingFile(NoAnswer, FileNotFoundError):
    """A file that is to be read is not there."""


class PendulumError(LibrationError):
    """An invalid pendulum or motion."""


class QuantityError(LibrationError):
    """A text or a number that is not the angle, length or acceleration required."""


class SimulationError(LibrationError):
    """A motion that cannot begin, or did not reach its end: ``partial`` is its part up to there."""

    partial: Any = None
    """The `Simulation` up to then; None where there is none."""


class UnknownKeyError(LibrationError, KeyError):
    """A key that no entry of a catalogue has; the message names the nearest."""

    __str__ = ValueError.__str__


class UsageError(LibrationError):
    """An invalid query."""

    @classmethod
    def about(cls, parameter: str, reason: str) -> "UsageError":
        """The error in an argument."""
        error = cls(f"{parameter}: {reason}")
        error.parameters = (parameter,)
        return error


class Interrupted(KeyboardInterrupt):
    """Ctrl-C in a long call; ``partial`` is what was done, None where nothing is confirmed yet."""

    def __init__(self, partial: Any = None) -> None:
        super().__init__("interrupted; what was done is the attribute `partial` of this exception")
        self.partial = partial
        """The finished part, of the type of the call's result."""

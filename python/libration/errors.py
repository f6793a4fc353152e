"""Exceptions, with the library's messages: what was got, why it cannot be, and what would do."""

__all__ = ["FormulaError", "LibrationError", "PendulumError", "QuantityError", "UnknownKeyError"]


class LibrationError(ValueError):
    """Any refusal of this package."""


class FormulaError(LibrationError):
    """A question that a period formula has no answer to."""


class PendulumError(LibrationError):
    """A pendulum or a motion that cannot be."""


class QuantityError(LibrationError):
    """A text or a number that is no such angle, length or acceleration."""


class UnknownKeyError(LibrationError, KeyError):
    """A key that no entry of a catalogue has; the message names the nearest."""

    __str__ = ValueError.__str__

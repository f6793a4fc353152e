"""Common methods of the results of this package."""

import html
from dataclasses import fields
from typing import Any

import numpy as np


class Record:
    """A record: equal if all fields are, arrays by their numbers; printed with all digits."""

    __slots__ = ()

    def __repr__(self) -> str:
        shown = [it.name for it in fields(self) if it.repr]  # type: ignore[arg-type]
        with all_digits():
            return f"{type(self).__name__}({arguments({it: getattr(self, it) for it in shown})})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        names = [it.name for it in fields(self) if it.compare]  # type: ignore[arg-type]
        return all(_equal(getattr(self, name), getattr(other, name)) for name in names)

    __hash__ = None  # type: ignore[assignment]


def all_digits() -> Any:
    """Lets arrays be printed so that they can be read back, up to NumPy's limit of 1000 numbers."""
    return np.printoptions(floatmode="unique")


def arguments(given: dict[str, Any]) -> str:
    """The fields as arguments of a call."""
    return ", ".join(f"{name}={value!r}" for name, value in given.items())


class Shown:
    """A table of facts in notebooks."""

    __slots__ = ()

    def _facts(self) -> list[tuple[str, object]]:
        raise NotImplementedError

    def _repr_html_(self) -> str:
        left = 'style="text-align: left"'
        cells = [(html.escape(name), html.escape(str(value))) for name, value in self._facts()]
        rows = [f"<tr><th {left}>{name}</th><td {left}>{value}</td></tr>" for name, value in cells]
        return f"<table>{''.join(rows)}</table>"


def _equal(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return bool(np.array_equal(one, other, equal_nan=True))
    return bool(one == other)

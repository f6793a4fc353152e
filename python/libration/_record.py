"""What the results of this package have in common."""

from dataclasses import fields
from typing import Any

import numpy as np


class Record:
    """Equal where all fields are, arrays by their numbers."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(_equal(getattr(self, it.name), getattr(other, it.name)) for it in fields(self) if it.compare)  # type: ignore[arg-type]

    __hash__ = None  # type: ignore[assignment]


def _equal(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return bool(np.array_equal(one, other, equal_nan=True))
    return bool(one == other)

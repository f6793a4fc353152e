"""The compiled ufuncs without reductions, which have no meaning for them.

Where ufuncs take no attributes, as in NumPy 1.26, they stay as NumPy makes them.
"""

import re
from typing import Any, NoReturn

import numpy as np

from . import _native


def arguments(ufunc: Any) -> list[str]:
    """The names of the arguments, as the docstring has them."""
    return re.findall(r"^(\w+) : array_like$", ufunc.__doc__, re.MULTILINE)


class Refused:
    """A method of a ufunc of two arguments that has no meaning for it."""

    def __init__(self, ufunc: Any, method: str) -> None:
        self.ufunc, self.method = ufunc, method

    def __call__(self, *_: Any, **__: Any) -> NoReturn:
        name, given = self.ufunc.__name__, ", ".join(arguments(self.ufunc))
        raise TypeError(
            f"{name}.{self.method} has no meaning, since a value of {name} is not an argument of "
            f"it: give arrays to {name}({given})"
        )


def describe() -> None:
    """Refuses reductions of the ufuncs of two arguments."""
    for ufunc in vars(_native).values():
        if isinstance(ufunc, np.ufunc) and hasattr(ufunc, "__dict__"):
            for method in ("reduce", "accumulate", "reduceat") if ufunc.nin == 2 else ():
                setattr(ufunc, method, Refused(ufunc, method))

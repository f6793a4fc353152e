"""The compiled ufuncs with the names of their arguments, and without reductions.

Where ufuncs take no attributes, as in NumPy 1.26, they stay as NumPy makes them.
"""

import re
from inspect import Parameter, Signature
from typing import Any, NoReturn

import numpy as np

from . import _native

OPTIONS = {
    "where": True,
    "casting": "same_kind",
    "order": "K",
    "dtype": None,
    "subok": True,
    "signature": None,
}


def arguments(ufunc: Any) -> list[str]:
    """The names of the arguments, as the docstring has them."""
    return re.findall(r"^(\w+) : array_like$", ufunc.__doc__, re.MULTILINE)


def signature(ufunc: Any) -> Signature:
    """The signature of a call."""
    names = [Parameter(name, Parameter.POSITIONAL_ONLY) for name in arguments(ufunc)]
    nothing = None if ufunc.nout == 1 else (None,) * ufunc.nout
    out = Parameter("out", Parameter.POSITIONAL_OR_KEYWORD, default=nothing)
    options = [Parameter(name, Parameter.KEYWORD_ONLY, default=it) for name, it in OPTIONS.items()]
    return Signature([*names, out, *options])


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
    """Gives the ufuncs their signatures, and refuses reductions of those of two arguments."""
    for ufunc in vars(_native).values():
        if isinstance(ufunc, np.ufunc) and hasattr(ufunc, "__dict__"):
            setattr(ufunc, "__signature__", signature(ufunc))
            for method in ("reduce", "accumulate", "reduceat") if ufunc.nin == 2 else ():
                setattr(ufunc, method, Refused(ufunc, method))

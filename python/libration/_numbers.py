"""Numbers as Python has them: of many types, with uncertainties or units, alone or in arrays.

A number may be an int, a float, a NumPy scalar, a Decimal, a Fraction or a number of SymPy. Its
uncertainty is left out with a warning, and a quantity with a unit is refused. Values that are
missing, masked ones of NumPy and ``NA`` of pandas, are NaN.
"""

import operator
import sys
import warnings
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, NoReturn, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Number: TypeAlias = float | Decimal | Fraction | np.floating[Any] | np.integer[Any]
NumberOrText: TypeAlias = Number | str
Numbers: TypeAlias = ArrayLike | Number | Sequence[Number]


def number(name: str, value: Any) -> float | str:
    """A number, or a text."""
    return str(value) if isinstance(value, str) else real(name, value, "a number or a text")


def real(name: str, value: Any, wanted: str = "a number") -> float:
    """A number; infinite if it is beyond the range of floats."""
    value = plain(name, value)
    kind = getattr(value, "dtype", np.dtype(object)).kind
    is_number = hasattr(value, "__float__") and kind in "iufO" and np.ndim(value) == 0
    if is_number and not isinstance(value, bool):
        try:
            return float(value)
        except OverflowError:
            return np.inf if value > 0 else -np.inf
        except (TypeError, ValueError):
            pass
    refuse(name, value, wanted)


def whole(name: str, value: Any, example: int) -> int:
    """An integer of any type."""
    refuse_units(value, f"{name}: ")
    wanted = f"a whole number, such as {example}"
    if isinstance(value, bool) or is_missing(value):
        refuse(name, value, wanted)
    try:
        return operator.index(value)
    except TypeError:
        refuse(name, value, wanted)


def text(name: str, value: Any, example: str) -> str:
    """A text, which NumPy's are too."""
    if not isinstance(value, str):
        refuse(name, value, f'a text, such as "{example}"')
    return str(value)


def floats(name: str, values: Any) -> NDArray[np.float64]:
    """A number or an array of any shape, in double precision."""
    wanted = "a number or an array of numbers"
    refuse_units(values, f"{name}: ")
    if is_uncertain(values):
        values = plain(name, values)
    values = without_masks(values)
    if isinstance(values, (list, tuple)):
        values = [it if type(it) in (int, float) else plain(name, it) for it in values]
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: got lists of different lengths: give {wanted}") from None
    if array.dtype.kind == "O":
        each = [real(name, it, wanted) for it in array.flat]
        return np.array(each, dtype=np.float64).reshape(array.shape)
    if array.dtype.kind not in "biuf":
        refuse(name, array.flat[0].item() if array.size else values, wanted)
    return array.astype(np.float64)


def operand(name: str, value: Any) -> Any:
    """A number or an array for arithmetic; those of the package uncertainties stay as they are."""
    refuse_units(value, f"{name}: ")
    if hasattr(value, "derivatives"):
        return value
    array = floats(name, value)
    return array if array.ndim else float(array)


def plain(name: str, value: Any) -> Any:
    """A value without its uncertainty, with a warning about it; NaN for a missing value."""
    refuse_units(value, f"{name}: ")
    if is_missing(value):
        return np.nan
    if not is_uncertain(value):
        return value
    reason = "its uncertainty is not used here, only its value"
    warnings.warn(f"{name}: got {value}: {reason}", stacklevel=outside())
    return float(value.nominal_value)


def is_missing(value: Any) -> bool:
    """True for a number that NumPy has masked, and for ``NA`` of pandas."""
    if isinstance(value, np.ma.MaskedArray):
        return value.ndim == 0 and bool(np.ma.getmaskarray(value))
    # An import of pandas takes longer than most calls.
    return type(value).__name__ == "NAType" and type(value).__module__.startswith("pandas")


def without_masks(values: Any) -> Any:
    """The values with NaN for masked ones, in lists of arrays too.

    `numpy.asarray` drops a mask, and takes the masked values for good ones.
    """
    if isinstance(values, np.ma.MaskedArray):
        kept: Any = values if values.dtype.kind == "f" else values.astype(object)
        return kept.filled(np.nan)
    if isinstance(values, (list, tuple)):
        return [without_masks(it) if _may_have_masks(it) else it for it in values]
    return values


def _may_have_masks(value: Any) -> bool:
    return type(value) in (list, tuple) or isinstance(value, np.ma.MaskedArray)


def is_uncertain(value: Any) -> bool:
    """True for a number of the package uncertainties, and for `libration.lab.Measured`."""
    return hasattr(value, "nominal_value") and hasattr(value, "std_dev")


def refuse_units(value: Any, where: str) -> None:
    """Refuses quantities such as those of pint, whose numbers mean nothing without their units."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        raise TypeError(
            f"{where}got a quantity with a unit: give a number in SI units, such as "
            'quantity.to_base_units().magnitude, or a text with its unit, such as "57cm"'
        )


def refuse(name: str, value: Any, wanted: str) -> NoReturn:
    """Refuses a value of another type."""
    is_short = isinstance(value, (str, bytes, bool, np.bool_, float))
    got = repr(value) if is_short else type(value).__name__
    raise TypeError(f"{name}: got {got}: give {wanted}")


def outside() -> int:
    """The level in the stack of the first caller outside the package, for warnings."""
    level, frame = 0, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith("libration."):
        level, frame = level + 1, frame.f_back
    return level

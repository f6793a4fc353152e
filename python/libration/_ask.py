"""How questions of the command are put in Python's words, and what comes back.

What is given goes down as text, in the notation of the command; what it means, and what is wrong
with it, the command says.
"""

import os
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, Protocol, SupportsFloat, TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._equations import text_of_sympy
from ._progress import spoken
from .errors import Interrupted

ARRAYS = 'arrays by names with units, such as {"t (s)": t, "angle (deg)": angle}'


class Table:
    """Columns in place of a file: a mapping of names with units to arrays, or a DataFrame."""

    def __init__(self, columns: Any) -> None:
        if isinstance(columns, (bytes, bytearray)) or hasattr(columns, "read"):
            raise TypeError(
                f"got {type(columns).__name__}: give the name of a file as text or as a path, "
                "or arrays by names with units"
            )
        if isinstance(columns, np.ndarray) and columns.dtype.names is None:
            raise TypeError(f"an array has no names of columns: give a file, or {ARRAYS}")
        if isinstance(columns, np.ndarray):
            columns = {name: columns[name] for name in columns.dtype.names}
        names = [str(name) for name in columns]
        for name in columns:
            refuse_units(columns[name], f"column `{name}`: ")
        arrays = [np.atleast_1d(np.asarray(columns[name])) for name in columns]
        if not names:
            raise ValueError(f"there are no columns: give {ARRAYS}")
        lengths = {len(array) for array in arrays}
        if len(lengths) != 1 or any(array.ndim != 1 for array in arrays):
            shapes = ", ".join(f"{name}: {it.shape}" for name, it in zip(names, arrays))
            raise ValueError(
                f"the columns differ in shape ({shapes}): give arrays of one dimension and equal "
                "lengths"
            )
        lines = [names, *([_cell(cell) for cell in row] for row in zip(*arrays))]
        self.text = "".join(",".join(map(_quoted, line)) + "\n" for line in lines).encode()


Value: TypeAlias = str | SupportsFloat | Fraction
"""A number, in SI units where it has a unit, or a text such as ``"60deg"`` or ``"1/2"``."""
Given: TypeAlias = Value | Sequence[Value] | NDArray[Any]
"""One or several, or a text as the command takes it, such as ``"0:10:0.1"``."""
Angle: TypeAlias = Value
"""In radians, or a text with its unit, such as ``"60deg"``."""
Quantity: TypeAlias = Value
"""In SI units, or a text with its unit and uncertainty, such as ``"0.57m±0.004m"``."""
Coordinate: TypeAlias = str
"""The name of a coordinate or velocity."""
Values: TypeAlias = Mapping[str, Given] | str
"""By name."""
Path: TypeAlias = str | os.PathLike[str]


class Symbolic(Protocol):
    """An expression or equation of SymPy."""

    @property
    def free_symbols(self) -> Any: ...


Equation: TypeAlias = str | Symbolic
"""A key of the catalogue, or equations as text or of SymPy."""
Columns: TypeAlias = Mapping[str, Any] | Table
"""Columns in place of a file: a DataFrame of pandas, or arrays by names with units, such as
``{"t (s)": t, "angle (deg)": angle}``.
"""
Say: TypeAlias = bool | Callable[[str], object]
"""True for a line of progress, where tqdm is installed; or a function of a text, such as
``"12 of 40 amplitudes"``.
"""


def _cell(value: Any) -> str:
    return "" if isinstance(value, (float, np.floating)) and np.isnan(value) else text_of(value)


def _quoted(cell: str) -> str:
    if not any(letter in cell for letter in ',"\n\r'):
        return cell
    return '"' + cell.replace('"', '""') + '"'


class Parameter(NamedTuple):
    """Something that a question is given."""

    name: str
    kind: str
    """"argument", "option" or "flag"."""
    value: str
    """What stands for its value in the help, such as ``NAME=VALUE``."""
    is_required: bool
    is_repeated: bool
    choices: list[str]
    meaning: str
    value_type: str
    """Such as "integer"; `libration_queries::ParameterType` lists them."""
    is_measured: bool = False
    """True for a measured quantity, whose uncertainty goes into the results."""

    @property
    def keyword(self) -> str:
        """Its name in Python."""
        name = self.name.replace("-", "_")
        return f"{name}_" if name in ("from", "lambda") else name

    def text(self, value: Any) -> str:
        """One value as the command reads it; an uncertainty that would not be used is left out."""
        refuse_units(value, f"{self.keyword}: ")
        if _is_uncertain(value) and not self.is_measured:
            reason = "its uncertainty is not used here, only its value"
            warnings.warn(f"{self.keyword}: got {value}: {reason}", stacklevel=_outside())
            value = float(value.nominal_value)
        try:
            return text_of(value)
        except TypeError as error:
            raise TypeError(f"{self.keyword}: {error}") from None


class Question(NamedTuple):
    """A question of the command, such as ``fit trace``."""

    words: str
    about: str
    remarks: str
    parameters: list[Parameter]


@cache
def catalogue() -> dict[str, Question]:
    """All questions by their words."""
    return {
        words: Question(words, about, remarks, [_parameter(words, it) for it in given])
        for words, about, remarks, given in _native.questions()
    }


def _parameter(words: str, given: Sequence[Any]) -> Parameter:
    parameter = Parameter(*given)
    if words == "period":
        is_measured = parameter.name in ("period", "ratio", "excess")
    else:
        is_of_measurements = words.split()[0] in ("fit", "plan")
        has_dimension = parameter.value in ("LENGTH", "MASS", "DENSITY", "RATE")
        is_width = parameter.name in ("width", "height")
        is_measured = is_of_measurements and has_dimension and not is_width
    return parameter._replace(is_measured=is_measured)


class Asked(NamedTuple):
    """A question as it went down."""

    words: tuple[str, ...]
    """Those of the command line, without the form of the answer."""
    input: bytes | None

    @property
    def command(self) -> str:
        """The words of the question itself."""
        two = " ".join(self.words[:2])
        return two if two in catalogue() else self.words[0]


def asked(words: str, given: Mapping[str, Any]) -> Asked:
    """The words of a question; what is None is left to the command."""
    options: list[str] = []
    inherited: list[str] = []
    arguments: list[str] = []
    read: list[bytes] = []
    for parameter in catalogue()[words].parameters:
        value = given.get(parameter.keyword)
        if value is None or value is False:
            continue
        earlier = getattr(value, "_asked", None)
        if isinstance(earlier, Asked):
            # A recording that was read already, with how it was read.
            arguments.append(earlier.words[-1])
            read += [earlier.input] if earlier.input is not None else []
            inherited += [word for word in earlier.words[1:-2] if word != "--values"]
            continue
        texts = _texts(parameter, value, read)
        if parameter.kind == "argument":
            arguments += texts
        elif parameter.kind == "flag":
            options.append(f"--{parameter.name}")
        else:
            options += [f"--{parameter.name}={text}" for text in texts]
    if read and any(parameter.name == "header" for parameter in catalogue()[words].parameters):
        # The names of columns are no row of numbers, even where they are numbers.
        inherited = [word for word in inherited if not word.startswith("--header=")]
        inherited = ["--header=present", *inherited]
    if len(read) > 1:
        raise ValueError("two tables are given in place of files: save one of them as a file")
    own = {option.split("=")[0] for option in options}
    options = [option for option in inherited if option.split("=")[0] not in own] + options
    arguments = ["--", *arguments] if arguments else []
    return Asked((*words.split(), *options, *arguments), read[0] if read else None)


def _texts(parameter: Parameter, value: Any, read: list[bytes]) -> list[str]:
    if parameter.kind == "flag":
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{parameter.keyword}: got {value!r}: give True or False")
        return []
    is_file = parameter.value.startswith("FILE")
    if is_file and not isinstance(value, (str, os.PathLike, list, tuple)):
        value = value if isinstance(value, Table) else Table(value)
        read.append(value.text)
        return ["-"]
    if parameter.value.startswith("NAME=") and isinstance(value, Mapping):
        values = {name: map(parameter.text, _several(it)) for name, it in value.items()}
        pairs = [f"{name}={','.join(texts)}" for name, texts in values.items()]
        return [",".join(pairs)] if parameter.value.endswith("…") else pairs
    if not parameter.is_repeated:
        return [",".join(map(parameter.text, _several(value)))]
    texts: list[str] = []
    for it in _several(value):
        is_whole = isinstance(it, (Mapping, Table))
        texts += _texts(parameter, it, read) if is_whole else [parameter.text(it)]
    return texts


def _several(value: Any) -> list[Any]:
    """What is given, one by one."""
    if _is_uncertain(value):
        return [value]
    if isinstance(value, np.ndarray) or hasattr(value, "to_numpy"):
        return list(np.ravel(value))
    return list(value) if isinstance(value, (list, tuple, set, frozenset, range)) else [value]


def _is_uncertain(value: Any) -> bool:
    """True for a number of the package uncertainties, and for `libration.lab.Measured`."""
    return hasattr(value, "nominal_value") and hasattr(value, "std_dev")


def refuse_units(value: Any, where: str) -> None:
    """Refuses quantities such as those of pint, whose numbers mean nothing without their units."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        raise TypeError(
            f"{where}got a quantity with a unit: give a number in SI units, such as "
            'quantity.to_base_units().magnitude, or a text with its unit, such as "57cm"'
        )


def _outside() -> int:
    """The level in the stack of the first caller outside the package, for warnings."""
    level, frame = 0, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith("libration."):
        level, frame = level + 1, frame.f_back
    return level


def text_of(value: Any) -> str:
    """As the command reads it: all digits of numbers, ``0.57±0.004`` for a value with its
    uncertainty, the text of an equation of SymPy.
    """
    if isinstance(value, str):
        return str(value)
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"got {value!r}: give a number or a text")
    if isinstance(value, (int, np.integer, Fraction)):
        return str(value)
    if _is_uncertain(value):
        return f"{float(value.nominal_value)!r}±{float(value.std_dev)!r}"
    if hasattr(value, "free_symbols"):
        return text_of_sympy(value)
    if isinstance(value, (float, np.floating, np.ndarray)) and np.ndim(value) == 0:
        return repr(float(value))
    raise TypeError(f"got {type(value).__name__}: give a number or a text")


def answered(
    question: Asked, form: Iterable[str], progress: Say = False
) -> tuple[str, BaseException | None]:
    """The answer in a form, and Ctrl-C if that has ended it early.

    Raises
    ------
    UsageError, NoAnswer
        What the command has to say against the question.
    """
    count = len(question.command.split())
    words = [*question.words[:count], *form, *question.words[count:]]
    with spoken(progress, question.command) as tell:
        answer, notes, error = _native.ask(words, question.input, tell)
    for note in notes:
        warnings.warn(note, stacklevel=_outside())
    if error is not None and not isinstance(error, KeyboardInterrupt):
        raise error
    return answer, error


def text(words: str, given: Mapping[str, Any], progress: Say = False) -> str:
    """The answer of a question that writes text."""
    answer, error = answered(asked(words, given), [], progress)
    if error is not None:
        raise Interrupted(answer or None) from error
    return answer

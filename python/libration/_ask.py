"""Commands of the program with Python's names and values, and their output.

What is given goes down as text, in the notation of the command; the command gives its
meaning and its errors.
"""

import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple, Protocol, SupportsFloat, TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import _native, _signs
from ._equations import formula_of_sympy, is_of_sympy, motion_of_sympy, text_of_sympy
from ._numbers import is_missing, is_uncertain, outside, plain, refuse, refuse_units, without_masks
from ._progress import spoken
from .errors import Interrupted

TABLE = "the table"
"""The name in messages of columns in place of a file; the compiled part knows it."""
ARRAYS = 'arrays by names with units, such as {"t (s)": t, "angle (deg)": angle}'


class Table:
    """Columns in place of a file: a mapping of names with units to arrays, or a DataFrame."""

    def __init__(self, columns: Any) -> None:
        is_other = isinstance(columns, (bytes, bytearray)) or hasattr(columns, "read")
        if is_other or not np.iterable(columns):
            raise TypeError(
                f"got {type(columns).__name__}: give the name of a file as text or as a path, "
                "or arrays by names with units"
            )
        if isinstance(columns, np.ndarray) and columns.dtype.names is None:
            raise TypeError(f"an array has no names of columns: give a file, or {ARRAYS}")
        if isinstance(columns, np.ndarray):
            columns = {name: columns[name] for name in columns.dtype.names}
        columns = _with_index(columns)
        names = [str(name) for name in columns]
        for name in columns:
            refuse_units(columns[name], f"column `{name}`: ")
        arrays = [
            _after_the_first(np.atleast_1d(np.asarray(without_masks(columns[name]))))
            for name in columns
        ]
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


def _with_index(columns: Any) -> Any:
    """The columns of a DataFrame, after its index if that has a name or consists of times."""
    index: Any = getattr(columns, "index", None)
    if not hasattr(columns, "columns") or getattr(index, "nlevels", 0) != 1:
        return columns
    name = index.name
    if name is None and np.asarray(index).dtype.kind in "mM":
        name = "time"
    if name is None or name in columns:
        return columns
    return {name: index} | {other: columns[other] for other in columns}


def _after_the_first(array: NDArray[Any]) -> NDArray[Any]:
    """Dates with times of day as times after the first of them; other arrays as they are."""
    if array.dtype.kind == "O" and array.size and all(map(_is_date, array)):
        seconds = [(it - array[0]).total_seconds() for it in array]
        return np.array([np.timedelta64(round(1e9 * it), "ns") for it in seconds])
    if array.dtype.kind != "M":
        return array
    dates = array[~np.isnat(array)]
    return array - dates[0] if dates.size else array


def _is_date(cell: Any) -> bool:
    """True for dates with times of day, not for ``NaT`` of pandas, which is unequal to itself."""
    return hasattr(cell, "timestamp") and bool(cell == cell)


Value: TypeAlias = str | SupportsFloat | Fraction
"""A number, in SI units where it has a unit, or a text such as ``"60deg"`` or ``"1/2"``."""
Given: TypeAlias = Value | Sequence[Value] | NDArray[Any]
"""One value or several, or a text as the command takes it, such as ``"0:10:0.1"``."""
Angle: TypeAlias = Value
"""An angle in radians, or a text with its unit, such as ``"60deg"``."""
Quantity: TypeAlias = Value
"""A quantity in SI units, or a text with unit and uncertainty, such as ``"0.57m±0.004m"``."""
Coordinate: TypeAlias = str
"""The name of a coordinate or velocity."""
Values: TypeAlias = Mapping[str, Given] | str
"""Values by name."""
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
    is_nan = isinstance(value, (float, np.floating)) and np.isnan(value)
    is_nat = isinstance(value, np.timedelta64) and np.isnat(value)
    return "" if is_nan or is_nat or is_missing(value) else text_of(value)


def _quoted(cell: str) -> str:
    if not any(letter in cell for letter in ',"\n\r'):
        return cell
    return '"' + cell.replace('"', '""') + '"'


class Parameter(NamedTuple):
    """A parameter of a command."""

    name: str
    kind: str
    """"argument", "option" or "flag"."""
    value: str
    """Placeholder of its value in the help, such as ``NAME=VALUE``."""
    is_required: bool
    is_repeated: bool
    choices: list[str]
    meaning: str
    value_type: str
    """Type, such as "integer"; `libration_queries::ParameterType` lists them."""
    is_measured: bool = False
    """True for a measured quantity, whose uncertainty goes into the results."""

    @property
    def keyword(self) -> str:
        """The name in Python."""
        name = self.name.replace("-", "_")
        return f"{name}_" if name in ("from", "lambda") else name

    @property
    def example(self) -> str | None:
        """Values by name, where the parameter takes them."""
        examples = {
            "NAME=VALUE": '{"c": 0.1}',
            "NAME=VALUE,…": '{"theta": "60deg"}',
            "NAME=VALUES": '{"c": [0.1, 0.2]}',
            "NAME=FORMULA,…": '{"energy": "theta\'^2/2 - cos(theta)"}',
            "NAME=FROM:TO": '{"omega": (0.3, 1.4)}',
            "NAME=A:B:STEP": '{"A": (1, 1.5, 0.1)}',
            "X=A:B,Y=C:D": '{"omega": (5, 20), "a": (0.01, 0.6)}',
        }
        return examples.get(self.value)

    @property
    def is_formula(self) -> bool:
        """True where the command reads formulas, and fractions and decimals as they are."""
        return self.value.startswith("NAME=VALUE") or self.value == "X"

    def text(self, value: Any) -> str:
        """One value as the command reads it; an uncertainty that would not be used is left out."""
        if self.is_measured and is_uncertain(value):
            refuse_units(value, f"{self.keyword}: ")
            return text_of(value)
        if self.value_type == "equation" and is_of_sympy(value):
            return motion_of_sympy(value).text
        return (formula if self.is_formula else option)(self.keyword, value)


class Question(NamedTuple):
    """A command of the program, such as ``fit trace``."""

    words: str
    about: str
    remarks: str
    parameters: list[Parameter]


@cache
def catalogue() -> dict[str, Question]:
    """All commands by their words."""
    return {
        words: Question(words, about, remarks, [_parameter(words, it) for it in given])
        for words, about, remarks, given in _native.questions()
    }


# What stands for measured quantities in the help of fits and plans.
_MEASURED = ("LENGTH", "MASS", "DENSITY", "RATE", "PERIOD", "EXPANSION", "KELVINS", "STIFFNESS")


def _parameter(words: str, given: Sequence[Any]) -> Parameter:
    parameter = Parameter(*given)
    if words == "period":
        is_measured = parameter.name in ("period", "ratio", "excess")
    else:
        is_of_measurements = words.split()[0] in ("fit", "plan")
        has_dimension = parameter.value in _MEASURED
        # Sizes of pictures, and the elevation, which is known better than the local anomaly.
        is_exact = parameter.name in ("width", "height", "elevation")
        # The length that turns displacements into angles scales them; its uncertainty is not used.
        is_scale = words == "fit amplitudes" and parameter.name == "length"
        is_measured = is_of_measurements and has_dimension and not is_exact and not is_scale
    return parameter._replace(is_measured=is_measured)


class Asked(NamedTuple):
    """A query as it is recorded."""

    words: tuple[str, ...]
    """The parameters of the command line, without the form of the result."""
    input: bytes | None

    @property
    def command(self) -> str:
        """The words of the query itself."""
        two = " ".join(self.words[:2])
        return two if two in catalogue() else self.words[0]


def asked(words: str, given: Mapping[str, Any]) -> Asked:
    """The words of a command line; parameters that are None are left to the command."""
    options: list[str] = []
    inherited: list[str] = []
    arguments: list[str] = []
    read: list[bytes] = []
    _refuse_signs(words, given)
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


def _refuse_signs(words: str, given: Mapping[str, Any]) -> None:
    """Refuses symbols that are declared not to be positive if the result may have symbols."""
    if words not in ("expand", "derive", "resonance"):
        return
    texts = given.get("set")
    pairs = texts.split(",") if isinstance(texts, str) else _several(texts or [])
    system = given.get("oscillator", given.get("system"))
    for equations in filter(is_of_sympy, [system] if is_of_sympy(system) else _several(system)):
        symbols = motion_of_sympy(equations).symbols
        named = [name_of(name).partition("=")[0].strip() for it in pairs for name in _names_in(it)]
        _signs.refuse(_signs.not_positive(symbols, named), symbols)


def _names_in(pair: Any) -> Iterable[Any]:
    """The names of a mapping, or that of a text such as ``k=1``."""
    return pair if isinstance(pair, Mapping) else [pair]


def _texts(parameter: Parameter, value: Any, read: list[bytes]) -> list[str]:
    if parameter.kind == "flag":
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{parameter.keyword}: got {value!r}: give True or False")
        return []
    is_file = parameter.value.startswith("FILE")
    if is_file and not isinstance(value, (str, os.PathLike, list, tuple)):
        value = value if isinstance(value, Table) else Table(value)
        read.append(value.text)
        return [TABLE]
    if parameter.example and isinstance(value, Mapping):
        between = ":" if ":" in parameter.value else ","
        values = {name_of(it): map(parameter.text, _several(value[it])) for it in value}
        pairs = [f"{name}={between.join(texts)}" for name, texts in values.items()]
        return [",".join(pairs)] if "," in parameter.value or "…" in parameter.value else pairs
    is_system = parameter.value_type == "equation" and is_of_sympy(value)
    several = [value] if is_system else _several(value)
    for it in several:
        refuse_units(it, f"{parameter.keyword}: ")
    if parameter.example and not all(isinstance(it, (str, Mapping)) for it in several):
        refuse(parameter.keyword, value, f"values by name, such as {parameter.example}")
    if not parameter.is_repeated and not several:
        raise ValueError(f"{parameter.keyword}: got no value: give at least one")
    if not parameter.is_repeated:
        return [",".join(map(parameter.text, several))]
    texts: list[str] = []
    for it in several:
        is_whole = isinstance(it, (Mapping, Table))
        texts += _texts(parameter, it, read) if is_whole else [parameter.text(it)]
    return texts


def _several(value: Any) -> list[Any]:
    """The given items, one by one."""
    if is_uncertain(value):
        return [value]
    if isinstance(value, np.ndarray) or hasattr(value, "to_numpy"):
        return list(np.ravel(without_masks(value)))
    return list(value) if isinstance(value, (list, tuple, set, frozenset, range)) else [value]


def text_of(value: Any) -> str:
    """A value as the command reads it: all digits of numbers, ``0.57±0.004`` for a value with its
    uncertainty, the text of an equation of SymPy.
    """
    if isinstance(value, str):
        return str(value)
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"got {value!r}: give a number or a text")
    if isinstance(value, (int, np.integer, Decimal, Fraction)):
        return str(value)
    if is_uncertain(value):
        return f"{float(value.nominal_value)!r}±{float(value.std_dev)!r}"
    if is_of_sympy(value):
        return text_of_sympy(value)
    is_array = isinstance(value, np.ndarray) and np.ndim(value) == 0
    if isinstance(value, (float, np.floating)) or is_array or hasattr(value, "free_symbols"):
        return repr(float(value))
    raise TypeError(f"got {type(value).__name__}: give a number or a text")


def option(name: str, value: Any) -> str:
    """The value of an option; fractions and decimals as floats, which all options take."""
    value = plain(name, value)
    try:
        return text_of(float(value) if isinstance(value, (Decimal, Fraction)) else value)
    except TypeError as error:
        raise TypeError(f"{name}: {error}") from None


def formula(name: str, value: Any) -> str:
    """The value of a name in equations: fractions, decimals and numbers of SymPy as they are."""
    value = plain(name, value)
    if hasattr(value, "free_symbols"):
        return formula_of_sympy(value)
    return str(value) if isinstance(value, (Decimal, Fraction)) else option(name, value)


def by_name(what: str, values: Any) -> list[tuple[str, str]]:
    """The values of names in equations."""
    if values is not None and not isinstance(values, Mapping):
        example = '{"theta": "60deg"}' if what == "initial" else '{"k": 0.1}'
        raise TypeError(f"{what}: got {values!r}: give values by name, such as {example}")
    given = (values or {}).items()
    return [(name_of(name), formula(f"{what}: {name}", it)) for name, it in given]


def name_of(name: Any) -> str:
    """A name in equations, which may be a symbol of SymPy, or a function or derivative."""
    return formula_of_sympy(name) if hasattr(name, "free_symbols") else str(name)


def answered(
    question: Asked, form: Iterable[str], progress: Say = False
) -> tuple[str, BaseException | None]:
    """The output in a form, and Ctrl-C if that has ended it early.

    Raises
    ------
    UsageError, NoAnswer
        The error messages of the command.
    """
    answer, error, _ = charted(question, form, progress, chart=False)
    return answer, error


def charted(
    question: Asked, form: Iterable[str], progress: Say = False, *, chart: bool = True
) -> "tuple[str, BaseException | None, _native.Chart | None]":
    """The same with the chart of the result, if it has one: it is made in the same run."""
    count = len(question.command.split())
    words = [*question.words[:count], *form, *question.words[count:]]
    with spoken(progress, question.command) as tell:
        answer, notes, error, drawing = _native.ask(words, question.input, tell, chart)
    for note in notes:
        warnings.warn(note, stacklevel=outside())
    if error is not None and not isinstance(error, KeyboardInterrupt):
        raise error
    return answer, error, drawing


def text(words: str, given: Mapping[str, Any], progress: Say = False) -> str:
    """The output of a command that writes text."""
    answer, error = answered(asked(words, given), [], progress)
    if error is not None:
        raise Interrupted(answer or None) from error
    return answer

"""Results of the command as objects: the fields of its JSON, columns as arrays.

>>> import libration as lb
>>> answer = lb.decay("60deg", linear=0.1, cycles=3)
>>> answer["length_m"], answer.damping[0].coefficient
(1.0, 0.1)
>>> answer.turning_points.amplitude_rad.round(6).tolist()
[1.047198, 0.989369, 0.935463, 0.885088, 0.837916, 0.793661, 0.752079]
"""

import html
import json
import re
import shlex
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from . import _native
from . import _chart
from ._equations import constant_of_sympy
from ._ask import TABLE, Asked, answered, asked, charted
from .errors import Interrupted
from .picture import Picture

if TYPE_CHECKING:
    import pandas
    import sympy
    import xarray
    from matplotlib.axes import Axes

__all__ = ["Answer", "Fields", "Rows"]

Column: TypeAlias = "NDArray[Any]"


class Fields(Mapping[str, Any]):
    """An object of a result: ``fields["name"]`` is what the JSON has, ``fields.name`` the same
    with lists as arrays and `Rows`.
    """

    __slots__ = ("_fields",)
    _fields: dict[str, Any]

    def __init__(self, fields: Mapping[str, Any]) -> None:
        object.__setattr__(self, "_fields", dict(fields))

    def __getitem__(self, name: str) -> Any:
        try:
            return self._fields[name]
        except KeyError:
            raise KeyError(f"no field `{name}`: there are {', '.join(self)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._fields:
            message = f"no field `{name}`: there are {', '.join(self)}"
            raise AttributeError(message, name=name, obj=self)
        return _seen(self._fields[name])

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("results cannot be changed")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("results cannot be changed")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]

    def __eq__(self, other: object) -> bool:
        return self._fields == other._fields if isinstance(other, type(self)) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._fields,)

    def __repr__(self) -> str:
        fields = [f"{name}={_short(value)}" for name, value in self._fields.items()]
        return f"{type(self).__name__}({', '.join(fields)})"

    def to_sympy(self, name: str, symbols: "Iterable[sympy.Symbol]" = ()) -> Any:
        """A formula of the result in SymPy, such as the rate of an amplitude; of a list of
        formulas a list; None where there is none.

        Parameters
        ----------
        name : str
            The field.
        symbols : sequence of sympy.Symbol
            Symbols with assumptions, in place of plain ones with the same names.

        Raises
        ------
        TypeError
            A field that is not a formula.

        Examples
        --------
        >>> import libration as lb
        >>> damped = "x'' + c*x'*abs(x') + x = 0"
        >>> flow = lb.questions.expand(damped, order=2, damping_order=1)
        >>> flow.slow_flow["amplitude"], flow.slow_flow.to_sympy("amplitude")
        ('-4/(3*pi)*c*A^2', -4*A**2*c/(3*pi))
        """
        known = {str(symbol): symbol for symbol in symbols}
        value = self[name]
        if value is None:
            return None
        if isinstance(value, list):
            return [_formula(name, it, known) for it in value]
        return _formula(name, value, known)

    def to_dict(self) -> dict[str, Any]:
        """A copy as Python's own lists and dicts: what the JSON of the command has."""
        copy: dict[str, Any] = json.loads(json.dumps(self._fields))
        return copy


class Rows(Sequence[Fields]):
    """A list of things with the same fields: ``rows[0]`` is one of them, ``rows.name`` or
    ``rows["name"]`` a column as an array.
    """

    __slots__ = ("_rows",)
    _rows: list[dict[str, Any]]

    def __init__(self, rows: Iterable[Mapping[str, Any]]) -> None:
        object.__setattr__(self, "_rows", list(rows))

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, place: int) -> Fields: ...
    @overload
    def __getitem__(self, place: "slice[Any, Any, Any]") -> "Rows": ...
    @overload
    def __getitem__(self, place: str) -> Column: ...
    def __getitem__(self, place: Any) -> Any:
        if isinstance(place, str):
            if place not in self.names:
                raise KeyError(f"no column `{place}`: there are {', '.join(self.names)}")
            return _array([row.get(place) for row in self._rows])
        return Rows(self._rows[place]) if isinstance(place, slice) else Fields(self._rows[place])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self.names:
            message = f"no column `{name}`: there are {', '.join(self.names)}"
            raise AttributeError(message, name=name, obj=self)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("results cannot be changed")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.names]

    def __eq__(self, other: object) -> bool:
        return self._rows == other._rows if isinstance(other, Rows) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return Rows, (self._rows,)

    def __repr__(self) -> str:
        return f"<{len(self)} rows of {', '.join(self.names)}>"

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the columns."""
        return tuple(dict.fromkeys(name for row in self._rows for name in row))

    def to_pandas(self) -> "pandas.DataFrame":
        """A column for each field."""
        import pandas

        columns = {name: self[name] for name in self.names}
        return pandas.DataFrame(_cells(columns))

    def _repr_html_(self) -> str:
        rows = ([row.get(name) for name in self.names] for row in self._rows)
        return _table(self.names, rows, len(self))


class Answer(Fields):
    """The result of a command: ``answer["field"]`` is what the JSON of the command has, where
    sentences name arguments in place of options, ``answer.field`` the same with arrays and `Rows`.
    """

    __slots__ = ("_asked", "_drawing")
    _asked: Asked
    _drawing: "_native.Chart | None"

    def __init__(
        self, fields: Mapping[str, Any], asked: Asked, drawing: "_native.Chart | None" = None
    ) -> None:
        super().__init__(fields)
        object.__setattr__(self, "_asked", asked)
        object.__setattr__(self, "_drawing", drawing)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._fields, self._asked)

    @property
    def question(self) -> str:
        """The command line, as words."""
        words = ["-" if word == TABLE else word for word in self._asked.words]
        return shlex.join(["libration", *words])

    @property
    def rows(self) -> Rows:
        """The longest list of things with fields."""
        lists: list[list[Any]] = [it for it in self._fields.values() if isinstance(it, list)]
        of_things = [it for it in lists if it and isinstance(it[0], dict)]
        longest: list[Any] = max(of_things, key=len, default=[])
        return Rows(longest)

    def to_pandas(self) -> "pandas.DataFrame":
        """The rows, with a column for each number of a state and for its error."""
        import pandas

        return pandas.DataFrame(_cells(self._columns()))

    def to_xarray(self) -> "xarray.Dataset":
        """The rows as a dataset over their number; single texts and numbers are attributes."""
        import xarray

        plain = {
            name: value
            for name, value in self._fields.items()
            if isinstance(value, (str, int, float)) and not isinstance(value, bool)
        }
        columns = {
            name: (("row", *(f"{name}_{axis}" for axis in range(1, it.ndim))), it)
            for name, it in self._columns().items()
        }
        return xarray.Dataset(columns, attrs={**plain, "question": self.question})

    def _columns(self) -> dict[str, Column]:
        rows = self.rows
        columns: dict[str, Column] = {}
        for name in rows.names:
            column = rows[name]
            if name in ("state", "error") and column.ndim == 2:
                end = "" if name == "state" else "_error"
                columns |= {f"{of}{end}": it for of, it in zip(self._fields["state"], column.T)}
            else:
                columns[name] = column
        return columns

    def picture(
        self,
        size: str | None = None,
        *,
        no_title: bool = False,
        curve_labels: bool = False,
        angles: str | None = None,
    ) -> Picture:
        """The picture that the command draws, as SVG; `Picture.save` writes PDF and PNG, too.

        Parameters
        ----------
        size : str
            Its purpose: "page", "column" or "slide".
        no_title : bool
            Leave out the title and the parameters under it, for a figure with a caption.
        curve_labels : bool
            Write the names of curves next to them where there is room.
        angles : str
            Unit of the angles along the axes: "degrees" or "radians".
        """
        layout = {
            "size": size,
            "no_title": no_title,
            "curve_labels": curve_labels,
            "angles": angles,
        }
        return Picture(self._asked, "figure", layout)

    def to_format(self, format: str) -> str:
        """The formulas as text, where the command has ``--format``: `expand` and `resonance`.

        Parameters
        ----------
        format : str
            "latex", "mathml", or functions in "c", "python", "rust" or "fortran".

        Raises
        ------
        UsageError
            For commands without formulas.
        Interrupted

        Examples
        --------
        >>> import libration as lb
        >>> flow = lb.questions.resonance("x''+x+eps*x*y=0; y''+4*y+eps*x^2=0", ratios="1:2")
        >>> print(flow.to_format("python").splitlines()[4])
        def amplitude_x(A_x, A_y, eps, phi_x, phi_y):
        """
        text, error = answered(self._asked, ["--format", format])
        if error is not None:
            raise Interrupted(text or None) from error
        return text

    def chart(self) -> dict[str, Any]:
        """The content of the picture as data, for other programs: that of ``--figure FILE.json``.

        It was found with the result; a result that was pickled is computed again for it.

        Raises
        ------
        TypeError
            The result has no picture.

        Examples
        --------
        >>> import libration as lb
        >>> chart = lb.questions.motion("60deg").chart()
        >>> chart["panels"][0]["y"]["label"], chart["panels"][0]["y"]["ticks"]
        ('angle θ / degrees', 'degrees')
        """
        return _chart.content(self)

    def plot(self, ax: "Axes | Iterable[Axes] | None" = None) -> Any:
        """Draws the picture of the result with matplotlib.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, or a sequence of as many as the picture has panels
            The axes to draw into; a new figure with a title, if they are not given.

        Returns
        -------
        matplotlib.axes.Axes, or an array of them if there are several panels

        Raises
        ------
        TypeError
            The result has no picture, or another number of panels than there are axes.
        """
        return _chart.draw(_chart.content(self), ax)

    def _repr_html_(self) -> str:
        described = {name: rest for name, *rest in descriptions().get(self._asked.command, [])}
        head = [
            (name, value, *described.get(name, ("", "")))
            for name, value in self._fields.items()
            if not isinstance(value, (list, dict))
        ]
        table = _table(("field", "value", "unit", "meaning"), head, len(head))
        return table + (self.rows._repr_html_() if self.rows else "")


A = TypeVar("A", bound=Answer)


def answer(kind: type[A], words: str, given: Mapping[str, Any]) -> A:
    """The result of a command with the arguments of a function, ``progress`` among it; empty where
    it was written to a file.

    Raises
    ------
    UsageError, NoAnswer, Interrupted
    """
    question = asked(words, given)
    text, error, drawing = charted(question, ["--json"], given.get("progress") or False)
    fields = json.loads(text) if text.startswith("{") else {}
    if error is not None:
        partial = kind(fields, question, drawing) if fields else None
        raise Interrupted(partial) from error
    return kind(fields, question, drawing)


def _formula(name: str, text: Any, symbols: dict[str, Any]) -> Any:
    try:
        if isinstance(text, str):
            return constant_of_sympy(text, symbols)
    except (SyntaxError, ValueError):
        pass
    raise TypeError(f"`{name}` is not a formula: {_short(text)}")


def _seen(value: Any) -> Any:
    """A value of JSON as Python's users want it."""
    if isinstance(value, dict):
        return Fields(value)
    if isinstance(value, list):
        return Rows(value) if value and all(isinstance(it, dict) for it in value) else _array(value)
    return value


def _array(values: list[Any]) -> Any:
    """Numbers as an array, missing ones as NaN; lists of different lengths as they are."""
    if not values:
        return np.array([])
    flat = [it for value in values for it in (value if isinstance(value, list) else [value])]
    numbers = [it for it in flat if isinstance(it, (int, float)) and not isinstance(it, bool)]
    is_number = len(numbers) + flat.count(None) == len(flat)
    lengths = {len(value) if isinstance(value, list) else -1 for value in values}
    if len(lengths) == 1 and is_number:
        whole = all(isinstance(it, int) for it in flat)
        return np.array(values, dtype=np.int64 if whole else np.float64)
    if lengths == {-1} and all(isinstance(it, bool) for it in flat):
        return np.array(values)
    array = np.empty(len(values), dtype=object)
    array[:] = [_seen(value) if isinstance(value, (dict, list)) else value for value in values]
    return array


@cache
def descriptions() -> dict[str, list[tuple[str, str, str]]]:
    """Name, unit and meaning of the fields of each command, as in `libration fields`."""
    text, *_ = _native.ask(["fields", "--json"])
    found: dict[str, list[tuple[str, str, str]]] = {}
    for command in json.loads(text)["commands"]:
        fields = [(it["name"], it["unit"], it["meaning"]) for it in command["json"]]
        found.setdefault(command["command"], []).extend(fields)
    return found


def _cells(columns: Mapping[str, Column]) -> dict[str, Any]:
    """Columns for pandas: a cell is a number, a text or an array."""
    return {name: list(it) if it.ndim > 1 else it for name, it in columns.items()}


def _short(value: Any) -> str:
    if isinstance(value, list):
        return f"[…{len(value)}]"
    if isinstance(value, dict):
        return f"{{…{len(value)}}}"
    return repr(value)


def _table(names: Iterable[str], rows: Iterable[Iterable[Any]], count: int) -> str:
    """A table of at most as many rows as can be seen at once."""
    shown = 12
    body = [_line("td", map(_cell, row)) for row, _ in zip(rows, range(shown))]
    more = f"<p>{count} rows, of which the first {shown} are shown</p>" if count > shown else ""
    return f"<table><thead>{_line('th', names)}</thead><tbody>{''.join(body)}</tbody></table>{more}"


def _line(tag: str, cells: Iterable[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(it)}</{tag}>" for it in cells) + "</tr>"


def _cell(value: Any) -> str:
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{value:.10g}"
    text = _short(value) if isinstance(value, (dict, list)) else str(value)
    return re.sub(r"\s+", " ", text)

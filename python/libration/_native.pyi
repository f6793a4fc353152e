"""The compiled part of the package."""

from collections.abc import Callable, Sequence
from typing import Any, Literal, Protocol, TypeAlias, TypedDict, final, overload

from numpy import bool_, float64, floating, int64, uint8
from numpy.typing import ArrayLike, DTypeLike, NDArray
from typing_extensions import Unpack

__version__: str
STANDARD_GRAVITY: float

_Tell: TypeAlias = Callable[[int, int | None], object]

def pendulum(length: float | str, gravity: float | str) -> tuple[float, float, float, float]:
    """Length and gravity in SI units, angular frequency and period of small swings."""

_Harmonics: TypeAlias = tuple[NDArray[int64], NDArray[float64], NDArray[float64]]

@final
class Motion:
    def __new__(
        cls, length: float, gravity: float, start: tuple[float | str, float | str]
    ) -> Motion: ...
    @property
    def regime(self) -> str: ...
    @property
    def period(self) -> float: ...
    @property
    def amplitude(self) -> tuple[float, float] | None: ...
    @property
    def energy_ratio(self) -> tuple[float, float]: ...
    @property
    def action(self) -> float: ...
    def states_at(self, times: NDArray[float64]) -> tuple[NDArray[float64], NDArray[float64]]: ...
    def harmonics(
        self, tolerance: float, limit: int
    ) -> tuple[tuple[float, float, float], _Harmonics]: ...

@final
class PeriodFormula:
    def __new__(cls, key: str) -> PeriodFormula: ...
    def words(self) -> tuple[str, str, str, int | None, str, str, str, int, float]: ...
    def ratio(self, amplitude: float | str) -> float: ...
    def error(self, amplitude: float | str) -> float: ...
    def ratios(self, amplitudes: list[float]) -> list[float]: ...
    def errors(self, amplitudes: list[float]) -> list[float]: ...
    def worst_error(self, up_to: float | str) -> tuple[float, float]: ...
    def holds_to(self, tolerance: float) -> float: ...

@final
class Expansion:
    def fields(self) -> dict[str, Any]: ...
    def evaluate(
        self, at: float, quantity: str
    ) -> tuple[float, float, bool, list[tuple[int, float, float]]]: ...

_Question: TypeAlias = tuple[str, list[tuple[str, str]], list[str], str | None]

def expand(
    question: _Question, order: int, gauge: str, progress: _Tell | None
) -> tuple[Expansion | None, BaseException | None]: ...
@final
class Simulation:
    def words(self) -> tuple[str, str, list[str], list[str], int, float]: ...
    def samples(self) -> tuple[NDArray[float64], NDArray[float64]]: ...
    def errors(
        self,
    ) -> tuple[NDArray[float64], NDArray[float64], NDArray[float64], float | None] | None: ...
    def events(self) -> list[tuple[int, float, NDArray[float64], str]]: ...
    def states_at(self, times: NDArray[float64]) -> NDArray[float64]: ...

_Pairs: TypeAlias = list[tuple[str, str]]
_Motion: TypeAlias = tuple[str, _Pairs, _Pairs, _Pairs, tuple[str, str] | None, float]

def simulate(
    question: _Motion, times: NDArray[float64], errors: bool, progress: _Tell | None
) -> tuple[Simulation, BaseException | None]: ...
@final
class Chart:
    def json(self) -> str: ...

def ask(
    arguments: Sequence[str],
    input: bytes | None = None,
    progress: Callable[[str], object] | None = None,
    chart: bool = False,
) -> tuple[str, list[str], BaseException | None, Chart | None]: ...
def questions(
    
) -> list[tuple[str, str, str, list[tuple[str, str, str, bool, bool, list[str], str, str]]]]: ...
def sweep_plan(
    question: Sequence[str],
    axes: Sequence[tuple[str, str | Sequence[str]]],
    keep: Sequence[str],
    chunk: int | None = None,
) -> str: ...
def sweep_chunk(
    plan: str, chunk: int, go_on: _Tell | None = None
) -> tuple[NDArray[float64], NDArray[uint8], list[str]]: ...
def program(arguments: Sequence[str]) -> int: ...
def latex(formula: str) -> str: ...
def formula_keys() -> list[str]: ...
def simplest_formulas(amplitude: float | str, tolerance: float) -> list[str]: ...

_Array: TypeAlias = NDArray[floating[Any]]
_TwoNumbers: TypeAlias = tuple[float64, float64]
_TwoArrays: TypeAlias = tuple[_Array, _Array]
_FourNumbers: TypeAlias = tuple[float64, float64, float64, float64]
_FourArrays: TypeAlias = tuple[_Array, _Array, _Array, _Array]

class _Options(TypedDict, total=False):
    """The keywords of all ufuncs but ``out``."""

    where: bool | NDArray[bool_]
    casting: Literal["no", "equiv", "safe", "same_kind", "unsafe"]
    order: Literal["K", "A", "C", "F"]
    dtype: DTypeLike
    subok: bool

class _Ufunc(Protocol):
    """What all of them have; NumPy's own types say of a call only that it is `Any`."""

    @property
    def __name__(self) -> str: ...
    @property
    def nin(self) -> int: ...
    @property
    def nout(self) -> int: ...
    @property
    def nargs(self) -> int: ...
    @property
    def ntypes(self) -> int: ...
    @property
    def types(self) -> list[str]: ...
    @property
    def identity(self) -> None: ...
    @property
    def signature(self) -> None: ...

class _OneToOne(_Ufunc, Protocol):
    """One number to one."""

    @overload
    def __call__(self, x: float, /, out: None = None, **options: Unpack[_Options]) -> float64: ...
    @overload
    def __call__(
        self, x: ArrayLike, /, out: _Array | tuple[_Array], **options: Unpack[_Options]
    ) -> _Array: ...
    @overload
    def __call__(
        self, x: ArrayLike, /, out: None = None, **options: Unpack[_Options]
    ) -> _Array: ...

class _TwoToOne(_Ufunc, Protocol):
    """Two numbers to one."""

    @overload
    def __call__(
        self, x1: float, x2: float, /, out: None = None, **options: Unpack[_Options]
    ) -> float64: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        /,
        out: _Array | tuple[_Array],
        **options: Unpack[_Options],
    ) -> _Array: ...
    @overload
    def __call__(
        self, x1: ArrayLike, x2: ArrayLike, /, out: None = None, **options: Unpack[_Options]
    ) -> _Array: ...

class _ThreeToOne(_Ufunc, Protocol):
    """Three numbers to one."""

    @overload
    def __call__(
        self, x1: float, x2: float, x3: float, /, out: None = None, **options: Unpack[_Options]
    ) -> float64: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        /,
        out: _Array | tuple[_Array],
        **options: Unpack[_Options],
    ) -> _Array: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        /,
        out: None = None,
        **options: Unpack[_Options],
    ) -> _Array: ...

class _TwoToFour(_Ufunc, Protocol):
    """Two numbers to four."""

    @overload
    def __call__(
        self, x1: float, x2: float, /, out: None = None, **options: Unpack[_Options]
    ) -> _FourNumbers: ...
    @overload
    def __call__(
        self, x1: ArrayLike, x2: ArrayLike, /, out: _FourArrays, **options: Unpack[_Options]
    ) -> _FourArrays: ...
    @overload
    def __call__(
        self, x1: ArrayLike, x2: ArrayLike, /, out: None = None, **options: Unpack[_Options]
    ) -> _FourArrays: ...

class _ThreeToTwo(_Ufunc, Protocol):
    """Three numbers to two."""

    @overload
    def __call__(
        self, x1: float, x2: float, x3: float, /, out: None = None, **options: Unpack[_Options]
    ) -> _TwoNumbers: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        /,
        out: _TwoArrays,
        **options: Unpack[_Options],
    ) -> _TwoArrays: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        /,
        out: None = None,
        **options: Unpack[_Options],
    ) -> _TwoArrays: ...

class _FourToTwo(_Ufunc, Protocol):
    """Four numbers to two."""

    @overload
    def __call__(
        self,
        x1: float,
        x2: float,
        x3: float,
        x4: float,
        /,
        out: None = None,
        **options: Unpack[_Options],
    ) -> _TwoNumbers: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        x4: ArrayLike,
        /,
        out: _TwoArrays,
        **options: Unpack[_Options],
    ) -> _TwoArrays: ...
    @overload
    def __call__(
        self,
        x1: ArrayLike,
        x2: ArrayLike,
        x3: ArrayLike,
        x4: ArrayLike,
        /,
        out: None = None,
        **options: Unpack[_Options],
    ) -> _TwoArrays: ...

period_ratio: _OneToOne
period_excess: _OneToOne
period_ratio_near_top: _OneToOne
period: _ThreeToOne
nome: _OneToOne
state: _ThreeToTwo
motion: _FourToTwo
ellipk: _OneToOne
ellipkm1: _OneToOne
ellipk_kp: _OneToOne
ellipe: _OneToOne
ellipe_kp: _OneToOne
ellipkinc: _TwoToOne
ellipkinc_kp: _TwoToOne
ellipeinc: _TwoToOne
ellipeinc_kp: _TwoToOne
ellipj: _TwoToFour
ellipj_kp: _TwoToFour
ellipnome: _OneToOne
ellipnome_kp: _OneToOne
inverse_nome: _OneToOne
inverse_nome_kp: _OneToOne

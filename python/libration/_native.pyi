"""The compiled part of the package."""

from collections.abc import Callable, Sequence
from typing import Any, Literal, Protocol, TypeAlias, TypedDict, overload

from numpy import bool_, float64, floating, int64
from numpy.typing import ArrayLike, DTypeLike, NDArray
from typing_extensions import Unpack

__version__: str
STANDARD_GRAVITY: float

def pendulum(length: float | str, gravity: float | str) -> tuple[float, float, float, float]:
    """Length and gravity in SI units, angular frequency and period of small swings."""

class Motion:
    def __new__(cls, length: float, gravity: float, angle: float | str, velocity: float | str) -> Motion: ...
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
    ) -> tuple[tuple[float, float, float], tuple[NDArray[int64], NDArray[float64], NDArray[float64]]]: ...

class PeriodFormula:
    def __new__(cls, key: str) -> PeriodFormula: ...
    def words(self) -> tuple[str, str, str, int | None, str, str, str, int, float]: ...
    def ratio(self, amplitude: float | str) -> float: ...
    def error(self, amplitude: float | str) -> float: ...
    def ratios(self, amplitudes: list[float]) -> list[float]: ...
    def errors(self, amplitudes: list[float]) -> list[float]: ...
    def worst_error(self, up_to: float | str) -> tuple[float, float]: ...
    def holds_to(self, tolerance: float) -> float: ...

class Expansion:
    def fields(self) -> dict[str, Any]: ...
    def evaluate(self, at: float, quantity: str) -> tuple[float, float, bool, list[tuple[int, float, float]]]: ...

_Question: TypeAlias = tuple[str, list[tuple[str, str]], list[str], str | None]

def expand(
    question: _Question, order: int, gauge: str, progress: Callable[[int, int | None], object] | None
) -> tuple[Expansion | None, BaseException | None]: ...
class Simulation:
    def words(self) -> tuple[str, str, list[str], list[str], int, float]: ...
    def samples(self) -> tuple[NDArray[float64], NDArray[float64]]: ...
    def events(self) -> list[tuple[int, float, NDArray[float64], str]]: ...
    def states_at(self, times: NDArray[float64]) -> NDArray[float64]: ...

_Pairs: TypeAlias = list[tuple[str, str]]
_Motion: TypeAlias = tuple[str, _Pairs, _Pairs, _Pairs, tuple[str, str] | None, float]

def simulate(
    question: _Motion, times: NDArray[float64], progress: Callable[[int, int | None], object] | None
) -> tuple[Simulation, BaseException | None]: ...
def ask(
    arguments: Sequence[str], input: bytes | None = None, progress: Callable[[str], object] | None = None
) -> tuple[str, list[str], BaseException | None]: ...
def program(arguments: Sequence[str]) -> int: ...
def latex(formula: str) -> str: ...
def formula_keys() -> list[str]: ...
def simplest_formulas(amplitude: float | str, tolerance: float) -> list[str]: ...

_Array: TypeAlias = NDArray[floating[Any]]

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
    def __call__(self, x: ArrayLike, /, out: _Array | tuple[_Array], **options: Unpack[_Options]) -> _Array: ...
    @overload
    def __call__(self, x: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> _Array: ...

class _TwoToOne(_Ufunc, Protocol):
    """Two numbers to one."""

    @overload
    def __call__(self, x1: float, x2: float, /, out: None = None, **options: Unpack[_Options]) -> float64: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, /, out: _Array | tuple[_Array], **options: Unpack[_Options]) -> _Array: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> _Array: ...

class _ThreeToOne(_Ufunc, Protocol):
    """Three numbers to one."""

    @overload
    def __call__(self, x1: float, x2: float, x3: float, /, out: None = None, **options: Unpack[_Options]) -> float64: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, /, out: _Array | tuple[_Array], **options: Unpack[_Options]) -> _Array: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> _Array: ...

class _TwoToFour(_Ufunc, Protocol):
    """Two numbers to four."""

    @overload
    def __call__(self, x1: float, x2: float, /, out: None = None, **options: Unpack[_Options]) -> tuple[float64, float64, float64, float64]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, /, out: tuple[_Array, _Array, _Array, _Array], **options: Unpack[_Options]) -> tuple[_Array, _Array, _Array, _Array]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> tuple[_Array, _Array, _Array, _Array]: ...

class _ThreeToTwo(_Ufunc, Protocol):
    """Three numbers to two."""

    @overload
    def __call__(self, x1: float, x2: float, x3: float, /, out: None = None, **options: Unpack[_Options]) -> tuple[float64, float64]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, /, out: tuple[_Array, _Array], **options: Unpack[_Options]) -> tuple[_Array, _Array]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> tuple[_Array, _Array]: ...

class _FourToTwo(_Ufunc, Protocol):
    """Four numbers to two."""

    @overload
    def __call__(self, x1: float, x2: float, x3: float, x4: float, /, out: None = None, **options: Unpack[_Options]) -> tuple[float64, float64]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, /, out: tuple[_Array, _Array], **options: Unpack[_Options]) -> tuple[_Array, _Array]: ...
    @overload
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, /, out: None = None, **options: Unpack[_Options]) -> tuple[_Array, _Array]: ...

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

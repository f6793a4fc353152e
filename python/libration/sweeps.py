"""A command over a parameter grid, in a store that survives interruptions.

>>> import tempfile
>>> import numpy as np
>>> import libration as lb
>>> with tempfile.TemporaryDirectory() as place:
...     over = {"amplitude": np.radians([30, 60, 90])}
...     periods = lb.sweep("period", over, f"{place}/periods.zarr").load()
>>> periods.ratio.values.round(6).tolist()
[1.017409, 1.073182, 1.180341]
"""

import os
import shlex
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native, _workers, _zarr
from ._ask import asked, catalogue, option
from ._numbers import refuse_units, without_masks
from ._plan import Plan, begin
from ._progress import Tell, told
from .errors import Interrupted, NoAnswer, UsageError

if TYPE_CHECKING:
    import distributed
    import xarray

__all__ = ["sweep"]


def sweep(
    question: str | Sequence[str],
    over: Mapping[str, ArrayLike | Sequence[str] | str],
    store: "str | os.PathLike[str]",
    *,
    keep: str | Iterable[str] | Mapping[str, str] = (),
    chunk: int | None = None,
    client: "distributed.Client | None" = None,
    progress: bool | Tell = False,
    **given: Any,
) -> "xarray.Dataset":
    """Runs a command over a parameter grid, and keeps numbers of the results in a Zarr store.

    It runs on all cores or on a cluster. The store is written chunk by chunk, each whole or not
    at all. Called again with the same arguments it continues, whatever has stopped it; a
    finished store is read. Its bytes are the same for any number of workers and of interruptions.

    Parameters
    ----------
    question : str or list of str
        A command of ``libration``: with its options,
        ``"lyapunov driven_pendulum --set c=1/2 --intervals 30"``, or alone, ``"lyapunov"``, with
        its parameters as keywords.
    over : dict
        The axes: arrays, lists of numbers or texts, or a text as the command takes it, such as
        ``"1:1.5:0.01"`` or ``"1deg:179deg:1deg"``. The values replace ``{name}`` in the command, or
        go to its option or argument of this name, or they are initial values or parameters of its
        system.
    store : path
        The directory, such as ``"sweep.zarr"``; one that holds another sweep is refused.
    keep : list of str or dict, optional
        The numbers to keep, by their paths in the JSON of the result, such as ``"exponent_per_s"``
        or ``"samples[-1].state[0]"``; a list has a range, such as ``"points[0:100].state[1]"``, and
        is a further dimension. In a dict by their names. All numbers that stand alone, if nothing
        is given; where all stand in lists, some have to be.
    chunk : int, optional
        The largest number of points in a chunk; about 256 chunks, if it is not given. When killed,
        a sweep loses the unfinished chunks.
    client : distributed.Client, optional
        A cluster, whose workers must see the store under the same path: one task for each chunk.
        The cores of this machine, if none is given.
    progress : bool or callable
        True for a bar, where tqdm is installed; or a function of how many points are done and of
        how many.
    **given
        The parameters of the command, as its function in `libration.questions` takes them:
        ``system="driven_pendulum", set={"c": "1/2"}, intervals=30``.

    Returns
    -------
    xarray.Dataset
        The numbers with their units and meanings, backed by the store; ``status``, 0 with a result
        and otherwise 1 (no result) or 2 (usage error); and ``message``, the reason why
        there is none. Numbers without a result are NaN.

    Raises
    ------
    UsageError, NoAnswer
        A command without a result at any point; a store that contains something else; a full disk,
        where all complete chunks are kept.
    Interrupted
        Ctrl-C; its ``partial`` is the dataset until then, whose ``status`` is -1 where nothing is
        done, or None before the first result.

    Examples
    --------
    >>> import tempfile
    >>> import libration as lb
    >>> keep = {"omega": "points[0:3].state[1]"}
    >>> given = {"set": {"c": "1/2"}, "initial": {"theta": 0.2}, "points": 3}
    >>> with tempfile.TemporaryDirectory() as place:
    ...     store = f"{place}/diagram.zarr"
    ...     over = {"A": [1.0, 1.05]}
    ...     found = lb.sweep("section", over, store, keep=keep, system="driven_pendulum", **given)
    ...     diagram = found.load()
    >>> diagram.omega.dims, diagram.omega.shape
    (('A', 'omega_number'), (2, 3))
    """
    if not isinstance(over, Mapping):
        raise TypeError(f'over: got {over!r}: give values by name, such as {{"length": [0.5, 1]}}')
    if not over:
        example = '{"amplitude": ["10deg", "20deg"]}'
        raise UsageError.about("over", f"there is no axis: give one by its name, such as {example}")
    if chunk is not None and chunk < 1:
        reason = f"got {chunk}: give the largest number of points in a chunk, 1 or more"
        raise UsageError.about("chunk", reason)
    words = _words(question, given)
    axes = [(str(name), _values(f"over: {name}", values)) for name, values in over.items()]
    kept = _kept(keep)
    place = Path(os.path.abspath(os.fspath(store)))
    with told(progress, "sweep") as tell:
        try:
            plan = Plan(_native.sweep_plan(words, axes, kept, chunk))
            begin(plan, place)
            _run(plan, place, client, tell)
        except KeyboardInterrupt as stopped:
            is_begun = (place / "zarr.json").exists()
            raise Interrupted(_opened(place) if is_begun else None) from stopped
        except OSError as error:
            raise NoAnswer(f"cannot write {place}: {error}; {_workers.KEPT}") from error
    _zarr.clear(place)
    return _opened(place)


def _kept(keep: str | Iterable[str] | Mapping[str, str]) -> list[str]:
    if not isinstance(keep, Mapping):
        return [keep] if isinstance(keep, str) else list(keep)
    for name in keep:
        if "/" in name:
            raise UsageError.about("keep", f"got the name `{name}`: a name in a store has no `/`")
    return [f"{name}={way}" for name, way in keep.items()]


def _words(question: str | Sequence[str], given: Mapping[str, Any]) -> list[str]:
    words = shlex.split(question) if isinstance(question, str) else [str(word) for word in question]
    if not given:
        return words
    name = " ".join(words)
    if name not in catalogue():
        raise UsageError(
            f"`{name}` is not a query that takes keywords: "
            "give one such as lyapunov, or its options as text"
        )
    known = [parameter.keyword for parameter in catalogue()[name].parameters]
    for keyword in given:
        if keyword not in known:
            raise TypeError(f"{name} takes no `{keyword}`: it takes {', '.join(known)}")
    question_asked = asked(name, given)
    if question_asked.input is not None:
        raise TypeError("a sweep reads files: save the table as one")
    return list(question_asked.words)


def _values(name: str, values: Any) -> str | list[str]:
    if isinstance(values, str):
        return values
    refuse_units(values, f"{name}: ")
    values = without_masks(values)
    if np.ndim(values) != 1:
        dimensions = f"the values of an axis have {np.ndim(values)} dimensions"
        raise ValueError(f"{name}: {dimensions}: give a list of them")
    several = values if isinstance(values, (list, tuple)) else np.asarray(values)
    return [option(name, value) for value in several]


def _run(plan: Plan, store: Path, client: Any, tell: Tell | None) -> None:
    missing = [number for number in range(plan.chunks) if not plan.is_done(store, number)]
    all_points = int(np.prod(plan["shape"]))
    done = all_points - sum(int(np.prod(plan.block(number))) for number in missing)
    if client is None:
        finished = _workers.on_this_machine(plan, store, missing)
    else:
        finished = _workers.on_cluster(client, plan, store, missing)
    for points in finished:
        done += points
        if tell is not None:
            tell(done, all_points)


def _opened(store: Path) -> "xarray.Dataset":
    import xarray

    found: xarray.Dataset = xarray.open_zarr(store, consolidated=True, mask_and_scale=False)
    return found

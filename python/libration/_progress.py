"""Progress and cancellation of long calls."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeAlias

from .errors import Interrupted

Tell: TypeAlias = Callable[[int, int | None], object]
"""A function of the work done, and of the total where it is known."""


@contextmanager
def told(progress: "bool | Tell", what: str) -> Iterator["Tell | None"]:
    """The progress function of a long call: the one given, or a bar of tqdm where installed."""
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield None
            return
        with tqdm(desc=what) as bar:
            yield lambda done, of: _show(bar, done, of)
        return
    yield progress or None


@contextmanager
def spoken(
    progress: "bool | Callable[[str], object]", what: str
) -> Iterator["Callable[[str], object] | None"]:
    """The function that receives the progress of a command in words."""
    if progress is True:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            yield None
            return
        with tqdm(desc=what, bar_format="{desc} ({elapsed})") as line:
            yield lambda how_far: line.set_description_str(f"{what}: {how_far}")
        return
    yield progress or None


def _show(bar: Any, done: int, of: int | None) -> None:
    bar.total = of
    bar.n = done
    bar.refresh()


def go_on(stopped_by: BaseException | None, partial: Any) -> None:
    """Raises what has stopped a call; where it was Ctrl-C, with what is done."""
    if isinstance(stopped_by, KeyboardInterrupt):
        raise Interrupted(partial) from stopped_by
    if stopped_by is not None:
        raise stopped_by

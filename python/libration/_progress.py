"""How far long calls are, and how they end early."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeAlias

from .errors import Interrupted

Tell: TypeAlias = Callable[[int, int | None], object]
"""Is told how much is done, and of how much where that is known."""


@contextmanager
def told(progress: "bool | Tell", what: str) -> Iterator["Tell | None"]:
    """The function that a long call tells: the one given, or a bar of tqdm where installed."""
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
    """Whom a question of the command tells in words how far it is."""
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

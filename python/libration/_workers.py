"""Workers on the chunks of a sweep: threads of this process, or a cluster of dask."""

import os
import threading
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from pathlib import Path
from typing import Any

from ._plan import Plan, answer_chunk
from .errors import NoAnswer

KEPT = "complete chunks are kept, and the same call continues from there"
PAUSE = 0.1
"""Seconds between two checks for Ctrl-C."""


def cores() -> int:
    """The number of processors available to this process."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class _Stopped(Exception):
    """The result of the chunk is no longer needed."""


def on_this_machine(plan: Plan, store: Path, missing: list[int]) -> Iterator[int]:
    """The number of points of each chunk when it is done, on all cores."""
    stop = threading.Event()

    def go_on(*_: Any) -> None:
        if stop.is_set():
            raise _Stopped

    with ThreadPoolExecutor(cores()) as threads:
        waiting = {threads.submit(answer_chunk, plan, store, number, go_on) for number in missing}
        try:
            while waiting:
                done, waiting = wait(waiting, PAUSE, FIRST_COMPLETED)
                for chunk in done:
                    yield chunk.result()
        finally:
            stop.set()
            threads.shutdown(cancel_futures=True)


def on_cluster(client: Any, plan: Plan, store: Path, missing: list[int]) -> Iterator[int]:
    """The number of points of each finished chunk, on a cluster; lost chunks are done again."""
    from distributed import CancelledError, KilledWorker
    from distributed import as_completed as completed
    from distributed.comm.core import CommClosedError

    as_completed: Any = completed
    waiting = {
        client.submit(answer_chunk, plan, store, number, pure=False, retries=RETRIES): number
        for number in missing
    }
    chunks = as_completed(waiting)
    try:
        for chunk in chunks:
            number = waiting.pop(chunk)
            try:
                yield chunk.result()
            except KilledWorker as error:
                reason = f"chunk {number} has killed all workers that were given it: {error}"
                raise NoAnswer(f"{reason}; {KEPT}") from error
    except (CancelledError, CommClosedError, TimeoutError) as error:
        raise NoAnswer(f"the cluster has gone: {KEPT}") from error
    finally:
        if client.status == "running":
            client.cancel(list(waiting))


RETRIES = 10
"""The number of times that a chunk is given to another worker."""

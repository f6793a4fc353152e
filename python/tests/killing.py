"""Sweeps whose processes are killed: a scheduler, two workers and a client on this machine, each a
process of its own.

`python/tests/killing.py PLACE OVERALL` is the client itself; `scripts/kill_sweeps` does many
rounds.
"""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil

import libration as lb

QUESTION = "section driven_pendulum --set c=1/2 --points 1 --skip 500"
OVER = {"A": "1:1.2:0.005", "theta": [0.1, 0.2, 0.3]}
KEEP = {"omega": "points[0].state[1]"}
"""A chunk takes some milliseconds, all of them a few seconds."""

ENVIRONMENT = {**os.environ, "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s"}
"""Without a scheduler nobody waits for long."""

LONGEST = 120
"""Seconds after which a process that should end has not."""


def asked(place: Path, **how: object):
    return lb.sweep(QUESTION, OVER, place, keep=KEEP, chunk=3, **how)


def tree(place: Path) -> dict[str, bytes]:
    """All files of a store."""
    return {
        str(file.relative_to(place)): file.read_bytes()
        for file in sorted(place.rglob("*")) if file.is_file()
    }


class Cluster:
    """A scheduler and two workers, as they are started on a cluster."""

    def __init__(self, place: Path) -> None:
        self.file = place / "scheduler.json"
        self.file.unlink(missing_ok=True)
        self.log = open(place / "cluster.log", "ab")
        quiet = ["--no-dashboard", "--scheduler-file", str(self.file)]
        self.scheduler = self._start("scheduler", *quiet, "--port", "0", "--host", "127.0.0.1")
        until(self.file.exists)
        local = ["--nthreads", "1", "--local-directory", str(place), "--host", "127.0.0.1"]
        self.workers = [self._start("worker", *quiet, *local) for _ in range(2)]

    def _start(self, *words: str) -> "subprocess.Popen[bytes]":
        program = [sys.executable, "-m", "dask", *words]
        return subprocess.Popen(
            program, stdout=self.log, stderr=self.log, start_new_session=True, env=ENVIRONMENT
        )

    def kill_a_worker(self) -> None:
        """The process that answers, below its nanny, which starts another; the nanny itself where
        there is none yet.
        """
        nanny = random.choice(self.workers).pid
        below = psutil.Process(nanny).children()
        kill(below[-1].pid if below else nanny)

    def close(self) -> None:
        for process in [*self.workers, self.scheduler]:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()
        self.log.close()


def kill(process: int) -> None:
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass


def until(is_so, longest: float = LONGEST) -> None:
    end = time.monotonic() + longest
    while not is_so():
        if time.monotonic() > end:
            raise TimeoutError("what was waited for did not come")
        time.sleep(0.02)


def client(store: Path, cluster: Cluster | None) -> "subprocess.Popen[bytes]":
    scheduler = str(cluster.file) if cluster else "none"
    return subprocess.Popen(
        [sys.executable, __file__, str(store), scheduler], stderr=subprocess.PIPE, env=ENVIRONMENT
    )


def chunks_done(store: Path) -> int:
    return sum(1 for _ in store.glob("status/c/*/*"))


def round_of(victim: str, place: Path, seed: int) -> dict[str, bytes]:
    """Kills a "worker", the "scheduler" or the "client" somewhere on the way, goes on to the end,
    and gives the files of the store.
    """
    random.seed(seed)
    place.mkdir(parents=True, exist_ok=True)
    store, cluster = place / "sweep.zarr", Cluster(place)
    try:
        running = client(store, cluster)
        before = random.randrange(40)
        until(lambda: chunks_done(store) > before or running.poll() is not None)
        time.sleep(random.uniform(0, 0.2))
        if victim == "worker":
            cluster.kill_a_worker()
        else:
            kill(cluster.scheduler.pid if victim == "scheduler" else running.pid)
        _, message = running.communicate(timeout=LONGEST)
        if victim == "worker":
            assert running.returncode == 0, message.decode()
        elif running.returncode not in (0, -signal.SIGKILL):
            assert b"the same call continues from there" in message, message.decode()
        if victim != "client":
            cluster.close()
            cluster = Cluster(place)
        if running.returncode != 0:
            again = client(store, cluster)
            _, message = again.communicate(timeout=LONGEST)
            assert again.returncode == 0, message.decode()
    finally:
        cluster.close()
    return tree(store)


if __name__ == "__main__":
    # A shell that runs the tests in the background lets its jobs ignore it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    store, scheduler = sys.argv[1:]
    if scheduler == "none":
        asked(Path(store))
    else:
        from distributed import Client

        with Client(scheduler_file=scheduler) as cluster:
            asked(Path(store), client=cluster)

"""Measures how the time grows with size: amplitudes, orders of a series, trajectories, rows of a recording, for libration and a peer.

Each cost is the median of --rounds; tools take turns (SciPy's fits, which take seconds, are made once). The numbers go to a file as
JSON, with date and processor, and the picture is drawn from that file alone (--draw draws it again without measuring).
"""
import argparse
import datetime
import json
import os
import statistics
import sys
import tempfile
import time
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import scipy

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
# Imported before run, which searches reference first, where another module has this name.
import motion  # noqa: E402
import run  # noqa: E402
import series  # noqa: E402
from fits import lab  # noqa: E402
from machine import processor  # noqa: E402

OURS = "libration"


def medians(rounds, *tasks):
    """The times in seconds of alternating tasks that report their times."""
    return [statistics.median(times) for times in zip(*([task() for task in tasks] for _ in range(rounds)))]


def panel(title, of, peer, points):
    """`points` are (size, our seconds, the peer's seconds or None)."""
    tools = [{"name": OURS, "points": [[size, ours] for size, ours, _ in points]}]
    tools.append({"name": peer, "points": [[size, theirs] for size, _, theirs in points if theirs is not None]})
    return {"title": title, "of": of, "tools": tools}


def amplitudes(rounds):

    def point(count):
        ours, peer, data = run.Ours(), run.Scipy(count), run.Data(count)
        ours.send("amplitudes", data.amplitudes)
        ours.time("period")
        passes = max(1, 100_000 // count)
        def by_scipy():
            return min(run.stopwatch(peer.period_by_complement, data.amplitudes) for _ in range(passes)) * 1e-9
        return count, *medians(rounds, lambda: min(ours.time("period") for _ in range(passes)) * 1e-9, by_scipy)

    points = [point(10**power) for power in range(2, 7)]
    return panel("periods of amplitudes", "amplitudes", f"SciPy {scipy.__version__} ellipkm1", points)


def orders(rounds):
    import flint
    ours, peer = series.Libration(str(ROOT / "target/release/libration-series")), series.PythonTool("FLINT", "with_flint")
    case = "pendulum, full answer"
    points = [(order, *medians(min(rounds, 3), *(lambda tool=tool: tool.ask(case, order, 60).seconds for tool in (ours, peer))))
              for order in (7, 15, 31, 61, 101, 201)]
    return panel("exact series of the pendulum", "order", f"FLINT by python-flint {flint.__version__}", points)


def trajectories(rounds):
    tools = [tool for tool in motion.tools() if tool.name in (motion.OURS, "heyoka, batches of 8")]

    def point(number):
        case = motion.driven(number, {})
        times = [lambda tool=tool: motion.median_answer(tool, case, case.starts).seconds * number for tool in tools]
        return number, *medians(rounds, *times)

    # The first request compiles the equations and is not counted.
    point(8)
    return panel("driven pendulums over 100 periods, 1e-9", "trajectories", tools[1].version, [point(8**power) for power in range(5)])


def rows(rounds):
    damping, random, cores = lab.Damping(linear=0.02, quadratic=0.01), np.random.default_rng(2), {max(os.sched_getaffinity(0))}

    def point(count, folder):
        recording = lab.recorded(random, damping, [1.0, 0.0], np.linspace(0, 40, count))
        file = lab.write(Path(folder) / f"{count}.csv", [recording])
        def by_us():
            return lab.ours(ROOT / "target/release/libration", file, "linear+quadratic", cores)[2]
        theirs = processor_seconds(lab.by_scipy, *recording) if count <= 3000 else None
        return count, *medians(rounds, by_us), theirs

    with tempfile.TemporaryDirectory() as folder:
        points = [point(count, folder) for count in (300, 1000, 3000, 10_000, 100_000, 1_000_000)]
    return panel("fit of 25 damped swings", "rows", f"SciPy {scipy.__version__} least_squares", points)


def processor_seconds(task, *arguments):
    start = time.process_time()
    task(*arguments)
    return time.process_time() - start


PANELS = (amplitudes, orders, trajectories, rows)


def draw(measured, file):
    plt.rcParams.update({"svg.hashsalt": "cost", "svg.fonttype": "none", "font.size": 9, "font.family": "sans-serif"})
    figure, axes = plt.subplots(2, 2, figsize=(8, 6.4), layout="constrained")
    for axis, it in zip(axes.flat, measured["panels"]):
        for tool, colour, marker in zip(it["tools"], ("#0b6fa4", "#a4560b"), "os"):
            sizes, seconds = zip(*tool["points"])
            axis.loglog(sizes, seconds, marker=marker, markersize=4, color=colour, label=tool["name"])
        axis.set(title=it["title"], xlabel=it["of"], ylabel="seconds")
        axis.grid(which="major", color="#dddddd", linewidth=0.6)
        axis.legend(frameon=False, loc="best")
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
    figure.supxlabel(f"One core of {measured['processor']}, {measured['date']}; medians of {measured['rounds']} rounds in turns", fontsize=8, color="#555555")
    figure.savefig(file, metadata={"Date": None})


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5, help="alternations")
    parser.add_argument("--json", metavar="FILE", default=ROOT / "docs/cost.json", help="the numbers")
    parser.add_argument("--svg", metavar="FILE", default=ROOT / "docs/cost.svg", help="the picture")
    parser.add_argument("--draw", action="store_true", help="draw the numbers that are there")
    return parser.parse_args()


def main(options):
    if not options.draw:
        cores = os.sched_getaffinity(0)
        os.sched_setaffinity(0, {max(cores)})
        panels = [measured(options.rounds) for measured in PANELS]
        measured = {"schema": 1, "date": datetime.date.today().isoformat(), "processor": processor(), "rounds": options.rounds, "panels": panels}
        Path(options.json).write_text(json.dumps(measured, indent=1) + "\n", encoding="utf-8")
    draw(json.loads(Path(options.json).read_text(encoding="utf-8")), options.svg)


if __name__ == "__main__":
    main(arguments())

"""Times `libration fit trace` on simulated recordings, on all cores, against the goals.

The recordings are motions by SciPy's DOP853 with normal noise: 500 swings in 10 000 rows, fitted by all eight models; a
million rows, by one; and 14 runs in one file, by all eight. Each fit is made --rounds times; the table shows the median of the times with
their range, the processor seconds, and how far the fitted parameters are from the truth in units of their uncertainties. Then a
small recording is fitted by SciPy's least_squares over solve_ivp too, in turns, on one core each: one model, from a start whose
ω0 is a thousandth wrong, with derivatives by differences of motions at 1e-12, which end a fraction of an uncertainty beside the minimum
(at 1e-9 they end two beside it); ours begins from nothing and finds the intervals and cycles besides. Exit status: how many lines fall short.
"""
import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

ROOT = Path(__file__).resolve().parents[2]
OMEGA0 = 4.0
NOISE = 0.003


@dataclass
class Damping:
    """The parameters in rad/s², 1/s and 1/rad."""

    dry: float = 0.0
    linear: float = 0.0
    quadratic: float = 0.0

    def acceleration(self, omega0, angle, speed):
        friction = self.dry * np.sign(speed) + self.linear * speed + self.quadratic * speed * abs(speed)
        return -omega0 * omega0 * np.sin(angle) - friction


def angles(damping, start, times, omega0=OMEGA0, tolerance=1e-10):
    motion = solve_ivp(
        lambda _, state: [state[1], damping.acceleration(omega0, *state)],
        (times[0], times[-1]), start, method="DOP853", rtol=tolerance, atol=1e-2 * tolerance, t_eval=times)
    return motion.y[0]


def recorded(random, damping, start, times):
    return times, angles(damping, start, times) + NOISE * random.standard_normal(len(times))


def write(path, runs):
    with open(path, "w") as file:
        file.write("run,time (s),angle (rad)\n")
        for number, (times, values) in enumerate(runs, 1):
            file.writelines(f"{number},{t:.9g},{angle:.9g}\n" for t, angle in zip(times, values))
    return path


@dataclass
class Case:
    title: str
    file: Path
    model: str
    damping: Damping
    goal: float


TITLES = ("10 000 rows, 500 swings, eight models", "1 000 000 rows, 300 swings, one model", "14 runs of 1500 rows, eight models")


def cases(folder):
    random = np.random.default_rng(1)
    period = 2 * np.pi / OMEGA0
    air = Damping(linear=0.004, quadratic=0.002)
    long = recorded(random, air, [1.2, 0.0], np.linspace(0, 516 * period, 10_000))
    yield Case(TITLES[0], write(folder / "long.csv", [long]), "auto", air, 4)
    thick = Damping(linear=0.006)
    dense = recorded(random, thick, [1.0, 0.0], np.linspace(0, 300 * period, 1_000_000))
    yield Case(TITLES[1], write(folder / "dense.csv", [dense]), "linear", thick, 10)
    all_kinds = Damping(dry=0.01, linear=0.01, quadratic=0.01)
    starts = [[0.2 + 0.1 * run, 0.3 * (run % 3 - 1)] for run in range(14)]
    runs = [recorded(random, all_kinds, start, np.arange(1500) * 0.02) for start in starts]
    yield Case(TITLES[2], write(folder / "runs.csv", runs), "auto", all_kinds, 20)


def ours(command, file, model, cores=None):
    """The result, with wall-clock and processor time in seconds."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    on = (lambda: os.sched_setaffinity(0, cores)) if cores else None
    found = subprocess.run([command, "fit", "trace", file, "--model", model, "--json"], stdout=subprocess.PIPE, check=True, preexec_fn=on)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return json.loads(found.stdout), wall, after.ru_utime - before.ru_utime


def deviations(answer, damping):
    """The values of the shared parameters, by name."""
    truth = {"omega0": OMEGA0, **vars(damping)}
    shared = [it for it in answer["parameters"] if it.get("trace") is None and it["name"] in truth]
    return {it["name"]: (it["value"] - truth[it["name"]]) / it["uncertainty"] for it in shared}


def fits(command, rounds, only):
    short = 0
    lines = [["fit", "time (range)", "wanted", "processor", "furthest from the truth"]]
    with tempfile.TemporaryDirectory() as folder:
        for case in cases(Path(folder)):
            if only and only not in case.title:
                continue
            found = [ours(command, case.file, case.model) for _ in range(rounds)]
            seconds = [wall for _, wall, _ in found]
            median = statistics.median(seconds)
            short += median > case.goal
            name, furthest = max(deviations(found[0][0], case.damping).items(), key=lambda it: abs(it[1]))
            lines.append([
                case.title, f"{median:.1f} s ({min(seconds):.1f}–{max(seconds):.1f})",
                f"≤ {case.goal} s" + (" MISSED" if median > case.goal else ""),
                f"{statistics.median(user for _, _, user in found):.1f} s", f"{furthest:+.1f} u of {name}"])
    print(aligned(lines), flush=True)
    return short


def by_scipy(times, values):
    """ω0, linear and quadratic damping, offset, first angle and velocity with their formal uncertainties."""
    def residuals(parameters):
        omega0, linear, quadratic, offset, *start = parameters
        return angles(Damping(0.0, linear, quadratic), start, times, omega0, 1e-12) + offset - values
    wrong = [1.001 * OMEGA0, 0.01, 0.01, 0.0, values[0], 0.0]
    fit = least_squares(residuals, wrong, x_scale="jac", xtol=1e-11, ftol=1e-11, diff_step=1e-6)
    variance = 2 * fit.cost / (len(times) - len(fit.x))
    return fit.x, np.sqrt(variance * np.diag(np.linalg.inv(fit.jac.T @ fit.jac)))


def beside_scipy(command, rounds):
    damping = Damping(linear=0.02, quadratic=0.01)
    recording = recorded(np.random.default_rng(2), damping, [1.0, 0.0], np.arange(2000) * 0.02)
    cores = {max(os.sched_getaffinity(0))}
    lines = [["one model of 2000 rows on one core", "libration", "SciPy", "ratio (range)", "difference of ω0"]]
    with tempfile.TemporaryDirectory() as folder:
        file = write(Path(folder) / "small.csv", [recording])
        turns = []
        for _ in range(rounds):
            answer, _, own = ours(command, file, "linear+quadratic", cores)
            start = time.process_time()
            (omega0, *_), (uncertainty, *_) = by_scipy(*recording)
            turns.append((own, time.process_time() - start))
    found = next(it for it in answer["parameters"] if it["name"] == "omega0")
    ratios = [theirs / own for own, theirs in turns]
    lines.append([
        "processor time", f"{statistics.median(own for own, _ in turns):.2f} s", f"{statistics.median(theirs for _, theirs in turns):.2f} s",
        f"{statistics.median(ratios):.1f} ({min(ratios):.1f}–{max(ratios):.1f})",
        f"{(found['value'] - omega0) / uncertainty:+.1e} uncertainties"])
    print(f"\n{aligned(lines)}", flush=True)


def aligned(lines):
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    lines = [lines[0], ["-" * width for width in widths], *lines[1:]]
    return "\n".join("| " + " | ".join(text.ljust(width) for text, width in zip(line, widths)) + " |" for line in lines)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, help="times that each fit is made")
    parser.add_argument("--only", metavar="WORD", help="only fits whose titles contain this")
    parser.add_argument("--ours", metavar="COMMAND", default=ROOT / "target/release/libration", help="times of another command")
    parser.add_argument("--no-scipy", action="store_true", help="leaves SciPy out")
    return parser.parse_args()


def main(options):
    print(f"{os.cpu_count()} cores, NumPy {np.__version__}, SciPy {scipy.__version__}", flush=True)
    short = fits(options.ours, options.rounds, options.only)
    if not options.no_scipy and not options.only:
        beside_scipy(options.ours, options.rounds)
    return short


if __name__ == "__main__":
    sys.exit(main(arguments()))

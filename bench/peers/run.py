"""Times libration and SciPy: periods, motions at one amplitude and with all arguments varying, elliptic integrals and functions.

Both sides work on the same arrays, on one core, in turns; the medians, and the ratio of each turn, are printed
with the largest error of both on a sample, against mpmath. Then the command is timed on all cores: a million periods from text to CSV, and
the fits of bench/lab. The last table shows the goals; the exit status is the number of lines that fall short.
"""
import argparse
import os
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import scipy
from mpmath import asin, cos, ellipe as mp_ellipe, ellipf as mp_ellipf, ellipk as mp_ellipk, mp, mpf, pi, sin
from scipy.special import ellipe, ellipeinc, ellipj, ellipk, ellipkinc, ellipkm1

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "reference"), str(HERE)]
sys.dont_write_bytecode = True
from elliptic import first, jacobi  # noqa: E402
from fits import lab  # noqa: E402
from goals import Line, finish  # noqa: E402

mp.dps = 60
SAMPLE = 300
COMMAND = ROOT / "target/release/libration"


class Ours:
    """The program of src/main.rs, kept open."""

    def __init__(self):
        self.process = subprocess.Popen([ROOT / "target/release/libration-peers"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def send(self, name, array):
        self.process.stdin.write(f"{name} {len(array)}\n".encode() + array.tobytes())

    def time(self, request):
        """Nanoseconds of one pass."""
        self.process.stdin.write(f"{request}\n".encode())
        self.process.stdin.flush()
        return int(self.process.stdout.readline())

    def angles(self, count):
        self.process.stdin.write(b"angles\n")
        self.process.stdin.flush()
        return np.array(struct.unpack(f"<{count}d", self.process.stdout.read(8 * count)))


class Scipy:
    """The same tasks in SciPy, with preallocated arrays."""

    def __init__(self, count):
        self.buffers = [np.zeros(count) for _ in range(6)]

    def period_by_complement(self, theta):
        m1, ratio = self.buffers[:2]
        np.multiply(theta, 0.5, out=m1)
        np.cos(m1, out=m1)
        np.square(m1, out=m1)
        ellipkm1(m1, out=ratio)
        return np.multiply(ratio, 2 / np.pi, out=ratio)

    def period_by_parameter(self, theta):
        m, ratio = self.buffers[:2]
        np.multiply(theta, 0.5, out=m)
        np.sin(m, out=m)
        np.square(m, out=m)
        ellipk(m, out=ratio)
        return np.multiply(ratio, 2 / np.pi, out=ratio)

    def functions(self, theta0, times):
        """The ufunc alone; the parameter is precomputed."""
        ellipj(times, self.parameter(theta0), out=tuple(self.buffers[:4]))

    def states(self, theta0, times):
        """Released from rest: sin(theta/2) = k cd(t), theta' = -2 k k' sd(t)."""
        k, kc = np.sin(np.multiply(theta0, 0.5)), np.cos(np.multiply(theta0, 0.5))
        sn, cn, dn, _, angle, velocity = self.buffers
        ellipj(times, k * k, out=tuple(self.buffers[:4]))
        np.divide(cn, dn, out=angle)
        np.multiply(angle, k, out=angle)
        np.arcsin(angle, out=angle)
        np.multiply(angle, 2, out=angle)
        np.divide(sn, dn, out=velocity)
        np.multiply(velocity, -2 * k * kc, out=velocity)
        return angle

    def parameter(self, theta0):
        if getattr(self, "given", None) is not theta0:
            self.given, self.m = theta0, np.sin(np.multiply(theta0, 0.5)) ** 2
        return self.m


def stopwatch(task, *arguments):
    start = time.perf_counter_ns()
    task(*arguments)
    return time.perf_counter_ns() - start


def alternate(ours, request, peer, rounds):
    """Nanoseconds (ours, peer) of each round, after one unrecorded pass each."""
    ours.time(request), peer()
    return [(ours.time(request), stopwatch(peer)) for _ in range(rounds)]


def true_ratio(theta):
    theta = mpf(float(theta))
    return 2 / pi * first(sin(theta / 2), cos(theta / 2))


def true_angle(theta0, t):
    half, t = mpf(float(theta0)) / 2, mpf(float(t))
    sn, cn, dn, _ = jacobi(t, sin(half), cos(half))
    return 2 * asin(sin(half) * cn / dn)


def worst_ulp(found, truths):
    return max(float(abs(mpf(float(x)) - t)) / np.spacing(abs(float(t))) for x, t in zip(found, truths))


def worst_radians(found, truths):
    return max(float(abs(mpf(float(x)) - t)) for x, t in zip(found, truths))


def line(name, peer, goal, count, rounds, ours_error, peer_error):
    """Prints a row, and returns its line of the table of goals if there is one."""
    ratios = [theirs / ours for ours, theirs in rounds]
    ours, theirs = (statistics.median(side) / count for side in zip(*rounds))
    median, least, largest = statistics.median(ratios), min(ratios), max(ratios)
    print(f"| {name}; {peer} | {ours:.2f} | {theirs:.1f} | {median:.1f} | {least:.1f} | {largest:.1f} | {ours_error} | {peer_error} |", flush=True)
    return [Line(name, f"SciPy {peer}", goal, ratios)] if goal else []


def periods(ours, peer, data, rounds):
    amplitudes = data.amplitudes
    sample = np.random.default_rng(3).integers(0, len(amplitudes), SAMPLE)
    truths = [true_ratio(x) for x in amplitudes[sample]]
    for name, goal, route in (("ellipkm1(cos²(θ0/2))·2/π", 8, peer.period_by_complement), ("ellipk(sin²(θ0/2))·2/π", None, peer.period_by_parameter)):
        times = alternate(ours, "period", lambda: route(amplitudes), rounds)
        errors = [f"{worst_ulp(x[sample], truths):.2g} ulp" for x in (ours.angles(len(amplitudes)), route(amplitudes))]
        yield from line("period", name, goal, len(amplitudes), times, *errors)


def motions(what, request, goal, theta0):
    """Varying amplitudes are those of the data."""
    def lines(ours, peer, data, rounds):
        amplitude, times = data.amplitudes if theta0 is None else theta0, data.times
        sample = np.random.default_rng(4).integers(0, len(times), SAMPLE)
        truths = [true_angle(x, t) for x, t in zip(np.broadcast_to(amplitude, times.shape)[sample], times[sample])]
        for name, wanted, route in (("ellipj alone", goal, peer.functions), ("ellipj, then θ and θ′", None, peer.states)):
            rounds_ns = alternate(ours, request, lambda: route(amplitude, times), rounds)
            angles = ours.angles(len(times)), peer.states(amplitude, times).copy()
            errors = [f"{worst_radians(x[sample], truths):.1e} rad" for x in angles]
            yield from line(what, name, wanted, len(times), rounds_ns, *errors)
    return lines


def functions_of_modulus(what, request, goal, function, truth, argument=None):
    """SciPy's function of the parameter, or of an array of the data and the parameter; the first of several results."""
    def lines(ours, peer, data, rounds):
        given = ([getattr(data, argument)] if argument else []) + [data.parameters]
        sample = np.random.default_rng(5).integers(0, len(data.parameters), SAMPLE)
        truths = [truth(*(mpf(float(x)) for x in row)) for row in zip(*(array[sample] for array in given))]
        out = tuple(peer.buffers[:function.nout])
        times = alternate(ours, request, lambda: function(*given, out=out), rounds)
        errors = [f"{worst_ulp(x[sample], truths):.2g} ulp" for x in (ours.angles(len(data.parameters)), out[0])]
        yield from line(what, function.__name__, goal, len(data.parameters), times, *errors)
    return lines


def true_sn(u, m):
    return jacobi(u, mp.sqrt(m), mp.sqrt(1 - m))[0]


TASKS = [
    ("period", periods),
    *((name, motions(name, request, goal, theta0)) for name, request, goal, theta0 in (
        ("motion, θ0 = 2", "motion 2.0", None, 2.0),
        ("prepared motion, θ0 = 2", "prepared 2.0", 60, 2.0),
        ("motion, θ0 = 179°", f"motion {float(np.radians(179))!r}", None, float(np.radians(179))),
        ("prepared motion, θ0 = 179°", f"prepared {float(np.radians(179))!r}", 60, float(np.radians(179))),
        ("motion, all varies", "varying", 20, None))),
    *((task[0], functions_of_modulus(*task)) for task in (
        ("K(m)", "first", 1, ellipk, mp_ellipk),
        ("E(m)", "second", 1, ellipe, mp_ellipe),
        ("F(φ, m)", "incomplete_first", 1, ellipkinc, mp_ellipf, "amplitudes"),
        ("E(φ, m)", "incomplete_second", 1, ellipeinc, mp_ellipe, "amplitudes"),
        ("sn, cn, dn, am", "jacobi", 4, ellipj, true_sn, "times"))),
]


class Data:
    def __init__(self, count):
        random = np.random.default_rng(1)
        self.amplitudes, self.times = random.uniform(0, np.pi, count), random.uniform(0, 50, count)
        self.parameters = random.uniform(0, 1, count)


def beside_scipy(options, wanted):
    data, ours, peer = Data(options.count), Ours(), Scipy(options.count)
    for name in ("amplitudes", "times", "parameters"):
        ours.send(name, getattr(data, name))
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}, {options.count} elements, {options.rounds} rounds, one core\n")
    print("| task; peer | ours ns | peer ns | ratio | min | max | our error | peer's error |")
    print("|---|---|---|---|---|---|---|---|")
    return [it for task in wanted for it in task(ours, peer, data, options.rounds)]


def seconds_of_csv(file):
    """The time for a million periods, each with one formula, redirected to a file."""
    with open(os.devnull, "wb") as nowhere:
        start = time.monotonic()
        subprocess.run([COMMAND, "period", "--from-file", file, "--formulas", "bernoulli", "--csv"], stdout=nowhere, check=True)
        return time.monotonic() - start


def csv_of_periods(rounds):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "amplitudes.txt"
        amplitudes = np.random.default_rng(6).uniform(0, np.pi, 1_000_000)
        file.write_text("".join(f"{float(x)!r}\n" for x in amplitudes))
        return [0.8 / seconds_of_csv(file) for _ in range(rounds)]


def fits_of_swings(wanted, rounds):
    """The fits of bench/lab."""
    if not any(wanted in f"fit trace, {title}" for title in lab.TITLES):
        return
    with tempfile.TemporaryDirectory() as folder:
        for case in lab.cases(Path(folder)):
            name = f"fit trace, {case.title}"
            if wanted in name:
                found = [case.goal / lab.ours(COMMAND, case.file, case.model)[1] for _ in range(rounds)]
                yield Line(name, f"{case.goal:g} s", 1, found)


def of_the_command(options):
    """The quotient of the goal in seconds by the time in seconds, on all cores."""
    rounds = min(options.rounds, 5)
    name = "period of 1e6 amplitudes, text to CSV"
    if options.line in name:
        yield Line(name, "0.8 s", 1, csv_of_periods(rounds))
    yield from fits_of_swings(options.line, rounds)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1_000_000, help="elements an array")
    parser.add_argument("--rounds", type=int, default=9, help="alternations, at least 5")
    parser.add_argument("--line", metavar="WORDS", default="", help="only work whose name contains this")
    parser.add_argument("--no-command", action="store_true", help="leaves the command out")
    parser.add_argument("--json", metavar="FILE", help="write the goals there too")
    return parser.parse_args()


def main(options):
    wanted = [task for name, task in TASKS if options.line in name]
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    lines = beside_scipy(options, wanted) if wanted else []
    os.sched_setaffinity(0, cores)
    lines += [] if options.no_command else of_the_command(options)
    return finish(lines, options.json)


if __name__ == "__main__":
    sys.exit(main(arguments()))

"""Times libration beside SciPy: the period, the motion at one amplitude, the motion when all varies.

Both sides work on the same arrays, on one core, in turns; the medians, and the ratio of each turn, are printed
with the largest error of both on a sample, against mpmath. Exit status 1 if a promised ratio is missed.
"""
import argparse
import os
import statistics
import struct
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import scipy
from mpmath import mp, mpf
from mpmath import asin, cos, pi, sin
from scipy.special import ellipj, ellipk, ellipkm1

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "reference"))
sys.dont_write_bytecode = True
from elliptic import first, jacobi  # noqa: E402

mp.dps = 60
SAMPLE = 300


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
    """The same tasks in SciPy, into arrays made beforehand."""

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
        """The ufunc alone; the parameter is made beforehand."""
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


def line(name, promise, count, rounds, ours_error, peer_error):
    """Prints a row; True if the promise is kept."""
    ratios = [peer / ours for ours, peer in rounds]
    ratio = statistics.median(ratios)
    ours, peer = (statistics.median(side) / count for side in zip(*rounds))
    promised = f"{promise:g}" if promise else ""
    print(f"| {name} | {ours:.2f} | {peer:.1f} | {ratio:.1f} | {min(ratios):.1f} | {max(ratios):.1f} | {promised} | {ours_error} | {peer_error} |", flush=True)
    return not promise or ratio >= promise


def periods(ours, peer, amplitudes, rounds):
    ours.send("amplitudes", amplitudes)
    sample = np.random.default_rng(3).integers(0, len(amplitudes), SAMPLE)
    truths = [true_ratio(x) for x in amplitudes[sample]]
    for name, promise, route in (
        ("period; ellipkm1(cos²(θ0/2))·2/π", 6, peer.period_by_complement),
        ("period; ellipk(sin²(θ0/2))·2/π", None, peer.period_by_parameter),
    ):
        times = alternate(ours, "period", lambda: route(amplitudes), rounds)
        errors = [f"{worst_ulp(x[sample], truths):.2g} ulp" for x in (ours.angles(len(amplitudes)), route(amplitudes))]
        yield line(name, promise, len(amplitudes), times, *errors)


def motions(ours, peer, what, request, promise, theta0, times, rounds):
    sample = np.random.default_rng(4).integers(0, len(times), SAMPLE)
    truths = [true_angle(x, t) for x, t in zip(np.broadcast_to(theta0, times.shape)[sample], times[sample])]
    for name, wanted, route in (("ellipj alone", promise, peer.functions), ("ellipj, then θ and θ′", None, peer.states)):
        rounds_ns = alternate(ours, request, lambda: route(theta0, times), rounds)
        angles = ours.angles(len(times)), peer.states(theta0, times).copy()
        errors = [f"{worst_radians(x[sample], truths):.1e} rad" for x in angles]
        yield line(f"{what}; {name}", wanted, len(times), rounds_ns, *errors)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1_000_000, help="elements an array")
    parser.add_argument("--rounds", type=int, default=9, help="alternations, at least 5")
    return parser.parse_args()


if __name__ == "__main__":
    options = arguments()
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    ours, peer, random = Ours(), Scipy(options.count), np.random.default_rng(1)
    amplitudes, times = random.uniform(0, np.pi, options.count), random.uniform(0, 50, options.count)
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}, {options.count} elements, {options.rounds} rounds, one core\n")
    print("| task; peer | ours ns | peer ns | ratio | min | max | promised | our error | peer's error |")
    print("|---|---|---|---|---|---|---|---|---|")
    kept = list(periods(ours, peer, amplitudes, options.rounds))
    ours.send("times", times)
    for name, theta0 in (("θ0 = 2", 2.0), ("θ0 = 179°", float(np.radians(179)))):
        kept += motions(ours, peer, f"motion, {name}", f"motion {theta0!r}", None, theta0, times, options.rounds)
        kept += motions(ours, peer, f"prepared motion, {name}", f"prepared {theta0!r}", 50, theta0, times, options.rounds)
    kept += motions(ours, peer, "motion, all varies", "varying", 15, amplitudes, times, options.rounds)
    sys.exit(0 if all(kept) else 1)

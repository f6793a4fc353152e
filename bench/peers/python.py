"""Times the Python package and SciPy in one process: medians of alternating calls with preallocated arrays, and one scalar call.

Prints a Markdown table with the time per element of both, the quotient with its range, and the largest error of both on a sample, against mpmath;
then a table of errors next to the separatrix. `--docs` puts them into `docs/python.md`, with the date and the processor. Needs the package
(`pip install .`), SciPy and mpmath.
"""
import argparse
import datetime
import platform
import statistics
import sys
import time
from pathlib import Path

import mpmath as mp
import numpy as np
import scipy
import scipy.special

import libration as lb

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python" / "tests"))
sys.dont_write_bytecode = True
from machine import processor  # noqa: E402
from truth import jacobi, ratio, ulps  # noqa: E402

SAMPLE = 200
SCALAR_CALLS = 2000
PAGE = ROOT / "docs" / "python.md"
MARKS = "<!-- measured by bench/peers/python.py -->\n", "<!-- end of what is measured -->\n"
REPORT = []


def tell(line):
    print(line, flush=True)
    REPORT.append(line)


def write_page():
    """Writes the report between the markers of the page."""
    before, rest = PAGE.read_text().split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    PAGE.write_text("".join([before, MARKS[0], "\n", *(line + "\n" for line in REPORT), "\n", MARKS[1], after]))


def nanoseconds(call):
    start = time.perf_counter_ns()
    call()
    return time.perf_counter_ns() - start


def alternate(ours, theirs, rounds):
    """Nanoseconds (ours, theirs) of each round, after one unrecorded call each."""
    ours(), theirs()
    return [(nanoseconds(ours), nanoseconds(theirs)) for _ in range(rounds)]


def worst(found, truths):
    return f"{float(max(ulps(x, true) for x, true in zip(found, truths))):.2g} ulp"


def row(name, peer, rounds, count, errors=("", "")):
    quotients = [theirs / ours for ours, theirs in rounds]
    ours, theirs = (statistics.median(side) / count for side in zip(*rounds))
    spread = f"{min(quotients):.1f}–{max(quotients):.1f}"
    tell(f"| {name} | {peer} | {ours:.1f} | {theirs:.1f} | {statistics.median(quotients):.1f} | {spread} | {errors[0]} | {errors[1]} |")


class Arrays:
    def __init__(self, count):
        random = np.random.default_rng(1)
        self.amplitude, self.t = random.uniform(0, np.pi, count), random.uniform(0, 50, count)
        self.m, self.phi = random.uniform(0, 1, count), random.uniform(-5, 5, count)
        self.out = [[np.empty(count) for _ in range(4)] for _ in range(2)]


def period_by_scipy(a, out):
    np.multiply(a.amplitude, 0.5, out=out)
    np.cos(out, out=out)
    np.square(out, out=out)
    scipy.special.ellipkm1(out, out=out)
    return np.multiply(out, 2 / np.pi, out=out)


def functions(a):
    """Name, ours, SciPy's, arguments, truth of the first result."""
    return [
        ("ellipk(m)", "ellipk", (a.m,), lambda m: mp.ellipk(mp.mpf(m))),
        ("ellipe(m)", "ellipe", (a.m,), lambda m: mp.ellipe(mp.mpf(m))),
        ("ellipkm1(p)", "ellipkm1", (a.m,), lambda p: mp.pi / 2 / mp.agm(1, mp.sqrt(p))),
        ("ellipkinc(phi, m)", "ellipkinc", (a.phi, a.m), lambda phi, m: mp.ellipf(mp.mpf(phi), mp.mpf(m))),
        ("ellipeinc(phi, m)", "ellipeinc", (a.phi, a.m), lambda phi, m: mp.ellipe(mp.mpf(phi), mp.mpf(m))),
        ("ellipj(u, m)", "ellipj", (a.t, a.m), lambda u, m: jacobi(u, m)[0]),
        ("ellipj(u, 0.7)", "ellipj", (a.t, 0.7), lambda u, m: jacobi(u, m)[0]),
    ]


def beside_scipy(a, count, rounds):
    ours, theirs = a.out
    sample = np.random.default_rng(2).integers(0, count, min(count, SAMPLE))
    lb.period_ratio(a.amplitude, out=ours[0]), period_by_scipy(a, theirs[0])
    truths = [ratio(x) for x in a.amplitude[sample]]
    errors = worst(ours[0][sample], truths), worst(theirs[0][sample], truths)
    times = alternate(lambda: lb.period_ratio(a.amplitude, out=ours[0]), lambda: period_by_scipy(a, theirs[0]), rounds)
    row("period_ratio(amplitude)", "2/π·ellipkm1(cos²)", times, count, errors)
    for name, key, given, truth in functions(a):
        one, other = getattr(lb.special, key), getattr(scipy.special, key)
        out = [tuple(side[: one.nout]) for side in a.out]
        times = alternate(lambda: one(*given, out=out[0]), lambda: other(*given, out=out[1]), rounds)
        each = [np.broadcast_to(x, (count,))[sample] for x in given]
        truths = [truth(*values) for values in zip(*each)]
        row(name, key, times, count, [worst(side[0][sample], truths) for side in out])
    m = np.sin(a.amplitude / 2) ** 2
    jacobi_alone = lambda parameter: lambda: scipy.special.ellipj(a.t, parameter, out=tuple(theirs))
    out = tuple(ours[:2])
    row("state(t, amplitude, 1)", "ellipj alone", alternate(lambda: lb.state(a.t, a.amplitude, 1.0, out=out), jacobi_alone(m), rounds), count)
    row("motion(t, 2, 0.5, 1)", "ellipj alone", alternate(lambda: lb.motion(a.t, 2.0, 0.5, 1.0, out=out), jacobi_alone(0.7), rounds), count)


def one_call(rounds):
    repeat = lambda call, *given: lambda: [call(*given) for _ in range(SCALAR_CALLS)]
    for key, given in (("ellipk", (0.3,)), ("ellipkm1", (0.3,)), ("ellipkinc", (0.3, 0.4)), ("ellipj", (0.3, 0.4))):
        pair = [repeat(getattr(module, key), *given) for module in (lb.special, scipy.special)]
        row(f"{key}, one number", key, alternate(*pair, rounds), SCALAR_CALLS)
    pair = repeat(lb.period_ratio, 0.3), repeat(lambda x: 2 / np.pi * scipy.special.ellipkm1(np.cos(x / 2) ** 2), 0.3)
    row("period_ratio, one number", "2/π·ellipkm1(cos²)", alternate(*pair, rounds), SCALAR_CALLS)


def next_to_the_separatrix():
    tell("\nThe value of cn next to the separatrix:\n\n| u, 1 - m | true cn | our error | SciPy's error |")
    tell("|---|---|---|---|")
    for u, p in ((5.0, 1e-6), (15.0, 1e-9), (15.0, 0.9e-10), (25.0, 0.9e-10), (40.0, 0.9e-10), (40.0, 1e-14)):
        m = 1 - p
        true = jacobi(u, m)[1]
        ours, theirs = (float(module.ellipj(u, m)[1]) for module in (lb.special, scipy.special))
        tell(f"| {u:g}, {p:g} | {float(true):.6g} | {float(abs(ours - true)):.1e} | {float(abs(theirs - true)):.1e} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100_000, help="elements of an array")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--docs", action="store_true", help=f"write the tables into {PAGE.relative_to(ROOT)}")
    options = parser.parse_args()
    today = datetime.date.today()
    versions = f"libration {lb.__version__}, SciPy {scipy.__version__}, NumPy {np.__version__}, Python {platform.python_version()}"
    tell(f"{today:%-d %B %Y}, one core of {processor()}: {versions}, {options.count} elements, {options.rounds} rounds.\n")
    tell("| ours | SciPy's | ours ns | SciPy's ns | quotient | range | our error | SciPy's error |")
    tell("|---|---|---|---|---|---|---|---|")
    beside_scipy(Arrays(options.count), options.count, options.rounds)
    one_call(options.rounds)
    next_to_the_separatrix()
    if options.docs:
        write_page()


if __name__ == "__main__":
    main()

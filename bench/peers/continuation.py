"""Times the response curve of the driven pendulum in libration and in AUTO-07p, alternating, on one core.

theta'' + 0.1 theta' + sin(theta) = 0.15 cos(w t) for w from 0.3 to 1.4, with both folds and the Floquet multipliers of all points. AUTO-07p
runs as a native program that bifpy compiles; what a run of one point takes, most of which is compiling, is taken off. The errors
of the folds are printed beside the times. The exit status is the number of lines that fall short.
"""
import argparse
import importlib.metadata
import importlib.util
import math
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from goals import Line, finish  # noqa: E402

DAMPING, DRIVE, FROM, TO = 0.1, 0.15, 0.3, 1.4
# By shooting with Taylor series in 30 digits (mpmath); the first by Fourier collocation too.
FOLDS = (0.8721575691379171688795389, 0.7806326535189842983411319)
NAME = "response curve of the driven pendulum"
GOAL = 10
PASSES = 9


class Ours:
    """The program of src/bin/libration-continuation.rs, kept open."""

    def __init__(self, command):
        self.process = subprocess.Popen([command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def once(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        seconds, points, *folds = map(float, self.process.stdout.readline().split())
        return seconds, int(points), folds

    def median(self):
        """The time in seconds, over several runs."""
        return statistics.median(self.once()[0] for _ in range(PASSES))


class Auto:
    """AUTO-07p with 50 intervals of 4 collocation points, which the folds need to be correct in all printed digits."""

    def __init__(self):
        from bifpy import auto

        self.auto = auto

    def run(self, most_points):
        kind = self.auto.IPS_PERIODIC_ORBIT
        steps = {"ds": -0.01, "dsmin": 1e-5, "dsmax": 0.1, "rl0": FROM, "rl1": TO + 0.01, "nmx": most_points}
        sizes = {"ndim": 4, "npar": 1, "ntst": 50, "ncol": 4, "iad": 3, "ilp": 1, "isp": 2, "iads": 1, "itmx": 9, "itnw": 7, "nwtn": 3, "jac": 0}
        settings = {"ips": kind, "a0": -1e300, "a1": 1e300, "epsl": 1e-9, "epsu": 1e-9, "epss": 1e-9, **steps, **sizes}
        begun = time.perf_counter()
        result = self.auto.run(equations, self.start, settings, icu=[1, self.auto.PERIOD_INDEX], transpile=True)
        return time.perf_counter() - begun, result.branches[0].points

    def start(self, state, parameters, part):
        """The response of the linear pendulum, far above resonance."""
        import numpy as np

        cosine, sine = np.cos(2 * math.pi * part), np.sin(2 * math.pi * part)
        answer = DRIVE / complex(1 - TO * TO, DAMPING * TO)
        state[0] = answer.real * cosine - answer.imag * sine
        state[1] = -TO * (answer.real * sine + answer.imag * cosine)
        state[2], state[3] = cosine, -sine
        parameters[0], parameters[self.auto.PERIOD_INDEX - 1] = TO, 2 * math.pi / TO

    def seconds(self):
        """The time of the curve without compiling, with its points."""
        whole, points = self.run(400)
        return whole - self.run(1)[0], points


def equations(state, parameters):
    """The pendulum, and an oscillator that settles to (cos wt, -sin wt), since AUTO-07p continues autonomous systems."""
    import numpy as np

    angle, velocity, p, q = state
    w, square = parameters[0], p * p + q * q
    return [velocity, -DAMPING * velocity - np.sin(angle) + DRIVE * p, p + w * q - p * square, q - w * p - q * square]


def worst(found):
    """The largest error of the folds, which come in either order."""
    return max(abs(a - b) for a, b in zip(sorted(found), sorted(FOLDS))) if len(found) == len(FOLDS) else math.inf


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ours", default=str(HERE.parents[1] / "target/release/libration-continuation"), help="our program")
    parser.add_argument("--rounds", type=int, default=5, help="alternations")
    parser.add_argument("--line", metavar="WORDS", default="", help="only work whose name contains this")
    parser.add_argument("--json", metavar="FILE", help="write the goals there too")
    return parser.parse_args()


def main(options):
    if options.line not in NAME:
        return finish([], options.json)
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    ours = Ours(options.ours)
    _, points, folds = ours.once()
    print(f"libration: {1e3 * ours.median():.1f} ms, {points} points, folds to {worst(folds):.1e}", flush=True)
    if importlib.util.find_spec("bifpy") is None:
        return finish([Line(NAME, "AUTO-07p", GOAL, [])], options.json)
    auto, quotients = Auto(), []
    for _ in range(options.rounds):
        mine = ours.median()
        theirs, points = auto.seconds()
        quotients.append(theirs / mine)
        folds = [point.parameters[0] for point in points if str(point.point_type).endswith("FOLD")]
        print(f"AUTO-07p: {1e3 * theirs:.0f} ms, {len(points)} points, folds to {worst(folds):.1e}; libration: {1e3 * mine:.1f} ms", flush=True)
    return finish([Line(NAME, f"AUTO-07p, bifpy {importlib.metadata.version('bifpy')}", GOAL, quotients)], options.json)


if __name__ == "__main__":
    sys.exit(main(arguments()))

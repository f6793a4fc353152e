"""Integrates the same motions in libration, heyoka, SciPy and two Rust crates, one core, alternating.

Every tool is a process that stays open; it is asked for one case after the other, round by round, and reports the
processor seconds of the integrations and, apart, of what it does beforehand (heyoka compiles the equations). What takes a few
milliseconds is asked for up to nine times in a row, and the median counts. A tool that needs longer than --slow for an answer gives only one. The tables show medians, the quotient by our time in each
round, the energy gained at the end as a part of the energy above rest, and the error of the angles; the last one the goals. The exit
status is the number of lines that fall short.
"""
import argparse
import os
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

from mpmath import cos, mp, mpf, pi, sin

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path += [str(ROOT / "reference"), str(HERE), str(HERE / "integration")]
from elliptic import first  # noqa: E402
from goals import Line, aligned, finish  # noqa: E402
from truth import driven_angle, pendulum_angle  # noqa: E402

mp.dps = 40
OURS = "libration"
PEERS = ROOT / "target/peers/release/peer-integrators"


class Tool:
    """A program that serves requests; at the start the Rust programs print nothing, the Python programs their version."""

    def __init__(self, name, command, spoken=True):
        self.name, self.version = name, name
        try:
            self.process = subprocess.Popen([str(word) for word in command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        except OSError:
            self.version = ""
        else:
            self.version = self.process.stdout.readline().strip() if spoken else name

    def ask(self, case, tolerance, end, starts):
        lines = [f"{case} {tolerance!r} {end!r} {len(starts)}"] + [" ".join(map(repr, start)) for start in starts]
        self.process.stdin.write("\n".join(lines) + "\n")
        self.process.stdin.flush()
        head = self.process.stdout.readline().split()
        if len(head) != 3:
            raise RuntimeError(f"{self.name} fails at {case}")
        states = [[float(word) for word in self.process.stdout.readline().split()] for _ in starts]
        return Answer(float(head[0]) / len(starts), int(head[1]) / len(starts), float(head[2]), states)


@dataclass
class Answer:
    """Time in seconds and number of steps of one motion."""

    seconds: float
    steps: float
    set_up: float
    states: list


def python(name, module, argument):
    return Tool(name, [sys.executable, HERE / "integration" / module, argument])


def tools():
    return [
        Tool(OURS, [ROOT / "target/release/libration-motion"], spoken=False),
        python("heyoka", "with_heyoka.py", 1),
        python("heyoka, batches of 4", "with_heyoka.py", 4),
        python("heyoka, batches of 8", "with_heyoka.py", 8),
        Tool("ode_solvers 0.6.2 Dop853", [PEERS, "ode_solvers"], spoken=False),
        Tool("differential-equations 0.7.0 dop853", [PEERS, "differential-equations"], spoken=False),
        python("SciPy DOP853", "with_scipy.py", "DOP853"),
        python("SciPy LSODA", "with_scipy.py", "LSODA"),
    ]


@dataclass
class Case:
    """A problem with the measure of its error; `peers` are words of which one is in a tool's name."""

    title: str
    system: str
    tolerance: float
    end: float
    starts: list
    peers: tuple = ("",)
    few: dict = field(default_factory=dict)
    energy: object = None
    error: object = None

    def starts_for(self, tool):
        """All motions, or the first few for slow tools."""
        return self.starts[: next((few for word, few in self.few.items() if word in tool.name), None)]


def pendulum_energy(state):
    angle, velocity = map(mpf, state)
    return velocity**2 / 2 + 2 * sin(angle / 2) ** 2


def double_energy(state):
    a, b, u, w = map(mpf, state)
    return u**2 + w**2 / 2 + u * w * cos(a - b) + 4 * sin(a / 2) ** 2 + 2 * sin(b / 2) ** 2


def pendulum(tolerance, periods, peers):
    start = float(pi * 179 / 180)
    end = float(4 * first(sin(mpf(start) / 2), cos(mpf(start) / 2)) * periods)
    title = f"pendulum from 179° over {periods} periods, tolerance {tolerance:g}"
    truth = pendulum_angle(start, end)
    return Case(title, "pendulum", tolerance, end, [[start, 0.0]], peers, energy=pendulum_energy, error=lambda states: abs(states[0][0] - truth))


def double(tolerance, peers):
    start = [float(2 * pi / 3)] * 2 + [0.0, 0.0]
    title = f"double pendulum from 120°/120°, equal rods and bobs, g = l = 1, until t = 100, tolerance {tolerance:g}"
    return Case(title, "double", tolerance, 100.0, [start], peers, energy=double_energy)


DRIVE_PERIOD = 3 * pi


def scattered(number):
    """Angles from -3 to 3 and velocities from -2 to 2, by a low-discrepancy sequence."""
    plastic = 1.32471795724474602596
    return [[-3 + 6 * (i / plastic % 1), -2 + 4 * (i / plastic**2 % 1)] for i in range(number)]


def driven(number, few):
    title = f"{number} driven pendulums θ″ + θ′/2 + sin θ = 1.2 cos(2t/3) over 100 drive periods, tolerance 1e-09"
    return Case(title, "driven", 1e-9, float(100 * DRIVE_PERIOD), scattered(number), few=few)


def errors_when_driven(every, count=8, periods=5):
    """The largest error of the angle after a few drive periods: later, neighbouring motions may have diverged."""
    starts, end = scattered(count), float(periods * DRIVE_PERIOD)
    truths = [driven_angle(start, end) for start in starts]
    found = {tool.name: tool.ask("driven", 1e-9, end, starts).states for tool in every}
    return {name: max(abs(state[0] - truth) for state, truth in zip(states, truths)) for name, states in found.items()}


def median_answer(tool, case, starts):
    """The median result, of several runs if one takes milliseconds: the first after a pause runs with cold caches."""
    answers = [tool.ask(case.system, case.tolerance, case.end, starts)]
    while len(answers) < 9 and sum(it.seconds for it in answers) * len(starts) < 0.01:
        answers.append(tool.ask(case.system, case.tolerance, case.end, starts))
    median = sorted(answers, key=lambda it: it.seconds)[len(answers) // 2]
    median.set_up = answers[0].set_up
    return median


def measure(case, every, rounds, slow):
    """The results of each tool, round by round."""
    asked = [tool for tool in every if any(word in tool.name for word in (OURS, *case.peers))]
    if len(case.starts) == 1:
        asked = [tool for tool in asked if "batches" not in tool.name]
    answers = {tool.name: [] for tool in asked}
    for _ in range(rounds):
        for tool in asked:
            before = answers[tool.name]
            starts = case.starts_for(tool)
            if not before or before[0].seconds * len(starts) < slow:
                before.append(median_answer(tool, case, starts))
    return answers


def duration(seconds):
    for unit, size in (("s", 1), ("ms", 1e-3)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-6:.3g} µs"


def quotients(answers, ours):
    """The quotients of one result to all of ours if there is only one."""
    if len(answers) == 1:
        return [answers[0].seconds / statistics.median(it.seconds for it in ours)]
    return [theirs.seconds / mine.seconds for theirs, mine in zip(answers, ours)]


def row(case, name, answers, ours, error):
    seconds = statistics.median(it.seconds for it in answers)
    last, ratios = answers[-1], quotients(answers, ours)
    spread = f"{statistics.median(ratios):.3g} ({min(ratios):.3g}–{max(ratios):.3g})" if answers is not ours else "1"
    cells = [name, duration(seconds), spread, str(len(answers)), f"{last.steps:.0f}", duration(answers[0].set_up)]
    if case.energy:
        start = case.energy(case.starts[0])
        cells.append(f"{float(case.energy(last.states[0]) / start - 1):+.1e}")
    if error is not None:
        cells.append(f"{float(error):.1e}")
    if len(case.starts) > 1:
        from_few = "" if len(last.states) == len(case.starts) else f", from {len(last.states)}"
        cells.append(duration(seconds * len(case.starts)) + from_few)
    return cells


def headings(case, with_error):
    yield from ("tool", "one motion", "quotient by ours (range)", "rounds", "steps", "set-up")
    if case.energy:
        yield "energy gained"
    if with_error:
        yield "error of the angle"
    if len(case.starts) > 1:
        yield "all motions"


def shown(case, answers, errors=None):
    """Prints the table of a case."""
    ours = answers[OURS]
    if case.error:
        errors = {name: case.error(given[-1].states) for name, given in answers.items()}
    lines = [list(headings(case, bool(errors)))]
    lines += [row(case, name, given, ours, errors and errors[name]) for name, given in answers.items()]
    print(f"\n{case.title}\n{aligned(lines)}", flush=True)


def goal(case, answers, least):
    """The time of the fastest heyoka."""
    heyokas = [(name, quotients(given, answers[OURS])) for name, given in answers.items() if "heyoka" in name]
    name, found = min(heyokas, key=lambda it: statistics.median(it[1]), default=("heyoka", []))
    return Line(case.title, name, least, found)


def energy_kept(case, answers):
    """The quotient of 1e-13 by the error."""
    drift = abs(float(case.energy(answers[OURS][-1].states[0]) / case.energy(case.starts[0]) - 1))
    return Line(f"{case.title}: energy", "1e-13", 1, [1e-13 / max(drift, 1e-30)])


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5, help="alternations")
    parser.add_argument("--slow", type=float, default=20, help="seconds of an answer above which there is only one")
    parser.add_argument("--periods", type=int, default=1000, help="of the pendulum")
    parser.add_argument("--driven", type=int, default=10_000, help="how many driven pendulums; 0 leaves them out")
    parser.add_argument("--only", metavar="WORD", help="only tools whose names contain this, and ours")
    parser.add_argument("--line", metavar="WORDS", default="", help="only work whose title contains this")
    parser.add_argument("--json", metavar="FILE", help="write the goals there too")
    return parser.parse_args()


def cases(options):
    """The problems, each with the goal for its quotient."""
    everyone, heyoka = ("",), ("heyoka",)
    for tolerance, peers in ((1e-9, heyoka), (1e-12, everyone), (1e-16, heyoka)):
        yield pendulum(tolerance, options.periods, peers), 1
    for tolerance, peers in ((1e-12, everyone), (1e-16, heyoka)):
        yield double(tolerance, peers), 1
    if options.driven:
        yield driven(options.driven, {"SciPy": 4, "ode_solvers": 1000, "differential": 1000}), 1.2


def main(options):
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    every = [tool for tool in tools() if not options.only or options.only in tool.name or tool.name == OURS]
    print("\n".join(tool.version or f"{tool.name}: missing" for tool in every), flush=True)
    every = [tool for tool in every if tool.version]
    lines = []
    for case, least in cases(options):
        if options.line not in case.title:
            continue
        errors = errors_when_driven(every) if case.system == "driven" else None
        if errors:
            print("\nThe error of driven pendulums is the largest of 8 after 5 drive periods.")
        answers = measure(case, every, options.rounds, options.slow)
        shown(case, answers, errors)
        lines.append(goal(case, answers, least))
        if case.system == "pendulum" and case.tolerance <= 1e-12:
            lines.append(energy_kept(case, answers))
    return finish(lines, options.json)


if __name__ == "__main__":
    sys.exit(main(arguments()))

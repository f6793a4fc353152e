"""Times exact perturbation series in libration, FLINT, PARI/GP, SymPy and the package asymptotics, one after the other.

Every tool gets each case and order in a process of its own, on one core, with a time limit; starting the tool is not
timed. The tools' last coefficients, with letters all of them, are compared with each other exactly.

Times are seconds of the processor, so that other work on the machine matters less. A cell shows the
median, the growth N^p since the order above, and the quotient by our time (theirs/ours). The last table shows the goals:
FLINT's time over ours, both asked in turns, round by round. The exit status is the number of lines that fall short and
of answers of ours that disagree.
"""
import argparse
import json
import math
import os
import shlex
import shutil
import statistics
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE / "perturbation")]
sys.dont_write_bytecode = True
from goals import Line, finish  # noqa: E402

IN_A1 = "Omega to eps^(N-1) and all harmonics to eps^N, in the gauge eps = a1"
IN_AMPLITUDE = "the same, then the reversion: eps, Omega, T and all harmonics as series in the amplitude"
EULER = "T/T0 to theta0^N from Euler numbers: an inverse of cos, an exponential; ours by the library's own way"
CASES = {
    "pendulum": ("x'' + sin x = 0, sin taken directly: " + IN_A1, (7, 9, 15, 31, 61, 101, 201)),
    "pendulum, full answer": (IN_AMPLITUDE, (7, 9, 13, 15, 31, 61, 101, 201)),
    "duffing": ("x'' + x + x^3 = 0: " + IN_A1, (7, 9, 16, 31, 101)),
    "duffing, full answer": (IN_AMPLITUDE, (7, 9, 13, 16, 31, 101)),
    "mixed, letters": ("x'' + w^2 x + a x^2 + b x^3 = 0 with a, b, w as letters: " + IN_A1 + ", all of them compared", (3, 5, 9, 15)),
    "van_der_pol": ("x'' + x = mu (1 - x^2) x': Omega to mu^N with the cycle it needs, to mu^(N-1)", (4, 20, 60)),
    "period": (EULER, (100, 200, 400)),
    "period, composition": ("T/T0 to theta0^N by putting sin^2(theta0/2) into the series of (2/pi) K", (100, 200, 400)),
    "period, AGM": ("T/T0 to theta0^N as 1/agm(1, cos(theta0/2)) on series", (100, 200, 400)),
}
OURS = "libration"
PEER = "FLINT"
GOALS = (
    ("pendulum, full answer", 31, 1.2),
    ("pendulum, full answer", 101, 1.2),
    ("pendulum, full answer", 201, 1.2),
    ("duffing, full answer", 101, 1.2),
    ("van_der_pol", 60, 1),
)


class Timed:
    """The result of a tool: the seconds of its passes and its last coefficients, or the reason why there are none."""

    def __init__(self, passes=(), check=(), reason=""):
        self.seconds = statistics.median(passes) if passes else None
        self.check, self.reason = tuple(check), reason

    def contradicts(self, truth):
        return any(mine and theirs and mine != theirs for mine, theirs in zip(self.check, truth))


class PythonTool:
    """A module of perturbation/ with a dictionary of cases, run by this file as a worker."""

    def __init__(self, name, module, cases="CASES"):
        self.name, self.module, self.cases = name, module, cases

    def command(self, *what):
        return [sys.executable, __file__, "--worker", self.module, self.cases, *what]

    def version(self):
        probe = subprocess.run(self.command(), capture_output=True, text=True, check=False)
        return probe.stdout.strip() or f"missing: {probe.stderr.strip().splitlines()[-1]}"

    def ask(self, case, order, limit):
        return answered(self.command(case, str(order)), "", limit)


class Pari:
    """PARI/GP, its script fed through standard input."""

    name = "PARI/GP"
    command = ["gp", "-q", "--default", "parisizemax=4G", str(HERE / "perturbation/with_pari.gp")]

    def version(self):
        if not shutil.which("gp"):
            return "missing: install pari-gp"
        return "PARI/GP " + subprocess.run(self.command, input="print(version())", capture_output=True, text=True, check=False).stdout.strip()

    def ask(self, case, order, limit):
        return answered(self.command, f'bench("{case}", {order})', limit)


class Libration:
    """A command with the arguments case and order that prints lines {"case", "order", "seconds", "check"}.

    `seconds` is a number or a list of passes, `check` the last coefficients in the form of the other tools."""

    name = OURS

    def __init__(self, command):
        self.command = shlex.split(command) if command else []

    def version(self):
        return " ".join(self.command) if self.command and shutil.which(self.command[0]) else "missing: see --ours"

    def ask(self, case, order, limit):
        return answered([*self.command, case, str(order)], "", limit, lambda it: (it["case"], it["order"]) == (case, order))


def answered(command, standard_input, limit, wanted=lambda _: True):
    """The last relevant line of JSON, as a Timed; the time limit includes a few seconds for the start."""
    try:
        run = subprocess.run(command, input=standard_input, capture_output=True, text=True, timeout=limit + 5, check=False)
    except subprocess.TimeoutExpired:
        return Timed(reason=f"> {limit:g} s")
    lines = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
    lines = [line for line in lines if wanted(line)]
    if not lines:
        return Timed(reason="failed: " + (run.stderr.strip().splitlines() or ["no answer"])[-1][:80])
    passes, check = lines[-1]["seconds"], lines[-1]["check"]
    if passes is None:
        return Timed(reason="–")
    answer = Timed(passes if isinstance(passes, list) else [passes], [check] if isinstance(check, str) else check)
    return answer if answer.seconds <= limit else Timed(reason=f"> {limit:g} s")


def work(module, cases, case=None, order=None):
    """The worker: prints the tool's version, or the times of a case as JSON."""
    tool = __import__(module)
    if case is None:
        print(tool.VERSION)
    elif case not in getattr(tool, cases):
        print(json.dumps({"seconds": None, "check": []}))
    else:
        passes, check = passes_of(getattr(tool, cases)[case], int(order))
        print(json.dumps({"seconds": passes, "check": [None if it is None else str(it) for it in check]}))


def passes_of(task, order):
    """Processor seconds of up to 7 passes, each a mean over as many runs as make 20 ms, after one pass for warming up; of slow
    tasks that first pass itself."""
    start = time.process_time()
    check = task(order)[-1]
    once = time.process_time() - start
    if once > 2:
        return [once], check
    runs, passes = max(1, math.ceil(0.02 / once)), []
    while len(passes) < 7:
        start = time.process_time()
        for _ in range(runs):
            task(order)
        passes.append((time.process_time() - start) / runs)
    return passes, check


def measure(tools, case, orders, limit):
    """{order: {tool: Timed}}; a tool that failed or timed out at one order is not run at higher ones."""
    rows, given_up = {}, {}
    for order in orders:
        rows[order] = {}
        for tool in tools:
            answer = given_up.get(tool.name) or tool.ask(case, order, limit)
            if not answer.seconds:
                given_up[tool.name] = answer
            rows[order][tool.name] = answer
    return rows


def truth_of(answers):
    """The last coefficients on which most tools agree."""
    counts = Counter(it.check for it in answers.values() if it.check and all(it.check))
    return counts.most_common(1)[0][0] if counts else ()


def duration(seconds):
    for unit, size in (("s", 1), ("ms", 1e-3)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-6:.3g} µs"


def growth(before, now):
    """The exponent p of cost ~ N^p between two (order, Timed); None if either has no time."""
    (n0, old), (n1, new) = before, now
    return math.log(new.seconds / old.seconds) / math.log(n1 / n0) if old.seconds and new.seconds else None


def cell(answer, before, order, ours, truth):
    if not answer.seconds:
        return answer.reason
    power = growth(before, (order, answer)) if before else None
    parts = [duration(answer.seconds), f"N^{power:.1f}" if power is not None else ""]
    parts += [f"{answer.seconds / ours.seconds:.3g}×" if ours and ours.seconds and ours is not answer else ""]
    parts += ["WRONG" if answer.contradicts(truth) else ""]
    return ", ".join(part for part in parts if part)


def table(rows, tools):
    """Lines of an aligned table, tools without any time left out."""
    shown = [tool.name for tool in tools if any(answers[tool.name].seconds for answers in rows.values())]
    lines, before = [["N", *shown]], {}
    for order, answers in rows.items():
        truth = truth_of(answers)
        ours = answers.get(OURS)
        lines.append([str(order)] + [cell(answers[name], before.get(name), order, ours, truth) for name in shown])
        before = {name: (order, answers[name]) for name in shown}
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    lines.insert(1, ["-" * width for width in widths])
    return ["| " + " | ".join(text.ljust(width) for text, width in zip(line, widths)) + " |" for line in lines]


def contradictions(rows):
    """The disagreements: (order, tool, its result, the result of most)."""
    for order, answers in rows.items():
        truth = truth_of(answers)
        yield from ((order, name, it.check, truth) for name, it in answers.items() if it.contradicts(truth))


def records(case, rows):
    for order, answers in rows.items():
        truth = truth_of(answers)
        for name, it in answers.items():
            if it.seconds or it.reason != "–":
                wrong = it.contradicts(truth)
                yield {"case": case, "order": order, "tool": name, "seconds": it.seconds, "note": it.reason, "wrong": wrong, "check": it.check}


def short(check):
    """The first few of symbolic coefficients."""
    check = check[:4]
    return ", ".join(it if not it or len(it) < 40 else f"{it[:20]}…{it[-16:]}" for it in check if it)


def goal(case, order, least, tools, rounds, limit):
    """The line of the table of goals, and the number of our results that disagree."""
    ours, peer = (next((tool for tool in tools if tool.name == name), None) for name in (OURS, PEER))
    pairs = [(ours.ask(case, order, limit), peer.ask(case, order, limit)) for _ in range(rounds) if ours and peer]
    quotients = [theirs.seconds / mine.seconds for mine, theirs in pairs if mine.seconds and theirs.seconds]
    disagree = sum(mine.contradicts(theirs.check) for mine, theirs in pairs)
    return Line(f"{case}, order {order}", PEER, least, quotients), disagree


def wanted_goals(options):
    """The cases selected by the options."""
    for case, order, least in GOALS:
        if case in (options.case or CASES) and order <= options.largest and options.line in f"{case}, order {order}":
            yield case, order, least


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    built = HERE.parents[1] / "target/release/libration-series"
    parser.add_argument("--ours", default=str(built) if built.exists() else "", help="our command, as one string")
    parser.add_argument("--limit", type=float, default=60, help="seconds a tool may take for one answer")
    parser.add_argument("--largest", type=int, default=10**6, help="leave out orders above this")
    parser.add_argument("--case", action="append", choices=CASES, help="only this case; may be repeated")
    parser.add_argument("--rounds", type=int, default=5, help="alternations for each goal")
    parser.add_argument("--line", metavar="WORDS", default="", help="only goals whose line contains this, and no other table")
    parser.add_argument("--json", metavar="FILE", help="write all times and the goals there too")
    return parser.parse_args()


def main(options):
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    every = [Libration(options.ours), PythonTool("FLINT", "with_flint"), Pari(), PythonTool("SymPy", "with_sympy")]
    every += [PythonTool("SymPy, in symbols", "with_sympy", "IN_SYMBOLS"), PythonTool("asymptotics", "with_asymptotics")]
    versions = {tool.name: tool.version() for tool in every}
    print("\n".join(f"{name}: {version}" for name, version in versions.items()))
    tools = [tool for tool in every if not versions[tool.name].startswith("missing")]
    kept, wrong = [], 0
    for case in [] if options.line else options.case or CASES:
        meaning, orders = CASES[case]
        rows = measure(tools, case, [order for order in orders if order <= options.largest], options.limit)
        print(f"\n{case}: {meaning}\n", *table(rows, tools), sep="\n", flush=True)
        for order, name, check, truth in contradictions(rows):
            print(f"{name} at N = {order} gives {short(check)}; the others {short(truth)}")
            wrong += name == OURS
        kept += records(case, rows)
    lines = []
    for case, order, least in wanted_goals(options):
        line, disagree = goal(case, order, least, tools, options.rounds, options.limit)
        lines.append(line)
        wrong += disagree
    return finish(lines, options.json, versions=versions, times=kept) + wrong


if __name__ == "__main__":
    if sys.argv[1:2] == ["--worker"]:
        work(*sys.argv[2:])
    else:
        sys.exit(main(arguments()))

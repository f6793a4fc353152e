"""Lines of the table of goals: the speed-up over the fastest peer, and its goal."""
import json
import statistics
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Line:
    """The quotients of their times by ours, one for each round; none if the peer is missing."""

    name: str
    peer: str
    goal: float
    quotients: list

    @property
    def median(self):
        return statistics.median(self.quotients) if self.quotients else None

    def falls_short(self):
        return self.median is not None and self.median < self.goal

    def cells(self):
        if self.median is None:
            return [self.name, self.peer, "not measured", "", f"{self.goal:g}", ""]
        spread = f"{min(self.quotients):.3g}–{max(self.quotients):.3g}"
        return [self.name, self.peer, f"{self.median:.3g}", spread, f"{self.goal:g}", "short" if self.falls_short() else "kept"]


def aligned(lines):
    """The first line is the heading."""
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    lines = [lines[0], ["-" * width for width in widths], *lines[1:]]
    return "\n".join("| " + " | ".join(text.ljust(width) for text, width in zip(line, widths)) + " |" for line in lines)


def finish(lines, path=None, **besides):
    """Prints the table, optionally writes it with further text, and returns the number of missed goals."""
    print("\n" + aligned([["work", "peer", "quotient", "range", "goal", ""], *(line.cells() for line in lines)]), flush=True)
    if path:
        records = [{"work": it.name, "peer": it.peer, "goal": it.goal, "quotients": it.quotients} for it in lines]
        Path(path).write_text(json.dumps({"schema": 1, **besides, "lines": records}, indent=1) + "\n", encoding="utf-8")
    return sum(line.falls_short() for line in lines)

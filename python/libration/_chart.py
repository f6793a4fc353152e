"""Charts, the content of pictures as the command gives it, drawn with matplotlib."""

import json
import textwrap
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import _native, _plot
from ._ask import catalogue, charted

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis

    from .answer import Answer

Data: TypeAlias = dict[str, Any]

POINTS = 0.75
"""Lengths of charts are in units of 1/96 inch, those of matplotlib in points."""
CAP = 2.2
"""Half the length of the caps of error bars, in points."""
MARKERS = {
    "circle": ("o", 2.0),
    "square": ("s", 1.8),
    "triangle": ("^", 2.2),
    "diamond": ("D", 1.84),
}
"""Markers of matplotlib, with their size for a radius of one."""
DEGREES = (1, 2, 5, 15, 30, 45, 90, 180, 360)
MOST_TICKS = 8


def content(answer: "Answer") -> Data:
    """The chart of a result; a result that was pickled is computed again for it."""
    drawing, question = answer._drawing, answer._asked
    draws = {parameter.name for parameter in catalogue()[question.command].parameters}
    if drawing is None and "figure" in draws:
        _, error, drawing = charted(question, ["--json"])
        if error is not None:
            raise error
    if drawing is None:
        why = f"there is no picture of this result of `{question.command}`"
        raise TypeError(why + _hint(answer))
    return read(drawing)


def _hint(answer: "Answer") -> str:
    hints = {
        "inspect": ": lab.spectrum(recording).plot() draws its harmonics",
        "resonance": ": it shows an exchange of energy; give initial",
        "simulate": ": it distinguishes few motions; give fewer",
    }
    return hints.get(answer._asked.command, "")


def read(drawing: "_native.Chart | None") -> Data:
    """The chart as Python's own lists and dicts."""
    chart: Data = json.loads(drawing.json()) if drawing else {}
    return chart


def draw(chart: Data, ax: "Axes | Iterable[Axes] | None") -> Any:
    """Draws a chart into axes, or into those of a new figure."""
    panels = chart["panels"]
    drawn = _new(chart) if ax is None else _given(panels, ax)
    for place, (panel, one) in enumerate(zip(panels, drawn)):
        # A panel without a label of its own has that of a panel below.
        below = (it["x"]["label"] for it in panels[place:] if it["x"]["label"])
        is_shared = ax is None and _is_shared(panels, place)
        explained = [series for above in panels[:place] for series in above["series"]]
        _panel(panel, one, "" if is_shared else next(below, ""), list(map(_name, explained)))
        one.tick_params(labelbottom=not is_shared)
    if len(drawn) == 1:
        return drawn[0]
    several = np.empty(len(drawn), dtype=object)
    several[:] = drawn
    return several


def _given(panels: Sequence[Data], ax: "Axes | Iterable[Axes]") -> "list[Axes]":
    is_one = hasattr(ax, "plot")
    given: list[Any] = [ax] if is_one else list(np.ravel(np.asarray(ax, dtype=object)))
    if len(given) != len(panels):
        wanted = "one Axes" if len(panels) == 1 else f"a sequence of {len(panels)} Axes"
        number = f"{len(panels)} panel" + ("s" if len(panels) > 1 else "")
        raise TypeError(f"ax: got {len(given)} Axes: the picture has {number}; give {wanted}")
    return given


def _is_shared(panels: Sequence[Data], place: int) -> bool:
    """True if the ticks of the panel below serve the panel."""
    ends = [[it["x"][name] for name in ("from", "to", "scale")] for it in panels[place : place + 2]]
    return len(ends) == 2 and ends[0] == ends[1] and not panels[place]["x"]["label"]


def _new(chart: Data) -> "list[Axes]":
    """The axes of a new figure with the title of the chart."""
    pyplot, panels = _plot.pyplot(), chart["panels"]
    width: float = pyplot.rcParams["figure.figsize"][0]
    height = 0.85 * width * chart["aspect"] + 1.3 + 0.4 * (len(panels) - 1)
    figure = pyplot.figure(figsize=(width, height), layout="constrained")
    ratios = [panel["share"] for panel in panels]
    drawn = list(figure.subplots(len(panels), squeeze=False, height_ratios=ratios)[:, 0])
    for place, (upper, lower) in enumerate(zip(drawn, drawn[1:])):
        if _is_shared(panels, place):
            upper.sharex(lower)
    texts = [chart["title"], ", ".join(chart["parameters"])]
    lines = [line for text in texts for line in textwrap.wrap(text, int(12 * width))]
    if lines:
        figure.suptitle("\n".join(lines), fontsize="medium")
    return drawn


def _name(series: Data) -> Data:
    """The name of a series with its look."""
    return {name: it for name, it in series.items() if name[0] not in "xy"}


def _panel(panel: Data, ax: "Axes", label: str, explained: Sequence[Data]) -> None:
    held = (*ax.get_xlim(), *ax.get_ylim()) if ax.has_data() else ()
    _plot.axes(ax, (label, panel["y"]["label"]))
    for place, name in enumerate("xy"):
        axis = panel[name]
        ends = [axis["from"], axis["to"], *held[2 * place : 2 * place + 2]]
        getattr(ax, f"set_{name}scale")("log" if axis["scale"] == "logarithmic" else "linear")
        getattr(ax, f"set_{name}lim")(min(ends), max(ends))
        _ticks(axis, getattr(ax, f"{name}axis"))
    # Names that a panel above explains are left out, as in the pictures of the command.
    names = ["" if _name(it) in explained else it["label"] for it in panel["series"]]
    for series, name in zip(panel["series"], names):
        _series(series, name, ax)
    if any(names):
        _plot.legend(ax)


def _ticks(axis: Data, drawn: "Axis") -> None:
    from matplotlib import ticker

    span, kind = axis["to"] - axis["from"], axis["ticks"]
    if axis["scale"] == "logarithmic":
        return
    # Each label is the whole value.
    drawn.set_major_formatter(ticker.ScalarFormatter(useOffset=False))
    if kind == "names":
        drawn.set_ticks(range(1, len(axis["names"]) + 1), axis["names"])
    elif kind == "whole":
        drawn.set_major_locator(ticker.MaxNLocator("auto", integer=True))
    elif kind == "degrees" and span > 20:
        turns = [360 * step for step in _decimal(span / 360)]
        steps = sorted([*DEGREES, *turns, *([10] if span < 46 else [])])
        drawn.set_major_locator(ticker.MultipleLocator(_step(span, steps)))
    elif kind == "half_turns" and span >= axis["half_turn"]:
        half = axis["half_turn"]
        step = _step(span / half, [0.25, 0.5, 1, *_decimal(span / half)])
        drawn.set_major_locator(ticker.MultipleLocator(step * half))
        drawn.set_major_formatter(ticker.FuncFormatter(lambda value, _: _of_pi(value / half)))


def _decimal(span: float) -> list[float]:
    """2, 5, 10 and so on up to the span."""
    powers = range(int(np.log10(max(span, 1))) + 1)
    return [factor * 10.0**power for power in powers for factor in (2, 5, 10)]


def _step(span: float, steps: Sequence[float]) -> float:
    """The smallest step that gives few enough ticks."""
    return next((step for step in steps if span / step <= MOST_TICKS), steps[-1])


def _of_pi(half_turns: float) -> str:
    """−3π/2 for −1.5."""
    quarters = round(4 * half_turns)
    denominator = 4 if quarters % 2 else 2 if quarters % 4 else 1
    numerator = quarters * denominator // 4
    times = "" if abs(numerator) == 1 else str(abs(numerator))
    sign, end = "−" if numerator < 0 else "", f"/{denominator}" if denominator > 1 else ""
    return f"{sign}{times}π{end}" if numerator else "0"


def _series(series: Data, label: str, ax: "Axes") -> None:
    x, y = _numbers(series["x"]), _numbers(series["y"])
    spreads: Data = {
        f"{name}err": _numbers(series[f"{name}_uncertainty"])
        for name in "xy"
        if f"{name}_uncertainty" in series
    }
    # matplotlib leaves such labels out of the legend.
    look: Data = {"color": series["colour"], "label": label or "_"}
    if series["mark"] == "band":
        half = spreads.get("yerr", np.zeros_like(y))
        ax.fill_between(x, y - half, y + half, alpha=series["opacity"], linewidth=0, **look)
        return
    look["alpha"] = series["opacity"] if series["opacity"] < 1 else None
    if series["mark"] == "line":
        width = series["line_width"]
        dashes = (0, [length / width for length in series["dashes"]])
        style = dashes if series["dashes"] else "-"
        ax.plot(x, y, linewidth=POINTS * width, linestyle=style, **look)
        return
    marker, size = MARKERS[series["mark"]]
    look |= {"linestyle": "", "marker": marker}
    look["markersize"] = POINTS * size * series["marker_radius"]
    if spreads:
        bars: Data = {"elinewidth": POINTS, "capthick": POINTS, "capsize": CAP}
        ax.errorbar(x, y, **spreads, **bars, **look).lines[0].set_markeredgewidth(0)
    else:
        ax.plot(x, y, markeredgewidth=0, **look)


def _numbers(column: list[Any]) -> NDArray[np.float64]:
    return np.array(column, dtype=np.float64)

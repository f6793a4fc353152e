"""Pictures with matplotlib, which is there with `pip install libration[plot]`."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Okabe and Ito's, which colour-blind readers can tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9"]


def pyplot() -> Any:
    """The module of matplotlib that makes figures."""
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise ImportError("pictures need matplotlib: pip install 'libration[plot]'") from error
    return pyplot


def axes(ax: "Axes | None", labels: tuple[str, str]) -> "Axes":
    """The axes to draw into, with labels: those given, or new ones."""
    if ax is None:
        new: Axes = pyplot().figure(layout="constrained").add_subplot()
        ax = new
    ax.set_prop_cycle(color=COLOURS)
    ax.set_xlabel(labels[0])
    ax.set_ylabel(labels[1])
    ax.grid(color="#DDDDDD", linewidth=0.6)
    ax.set_axisbelow(True)
    return ax


def legend(ax: "Axes") -> None:
    """A legend above the axes, where it hides no data; each label stands there once."""
    first: dict[str, Any] = {}
    for handle, label in zip(*ax.get_legend_handles_labels()):
        first.setdefault(label, handle)
    font: float = pyplot().rcParams["font.size"]
    room = ax.get_window_extent().width / ax.figure.dpi * 72 / font
    widths = [0.52 * len(label) + 2.8 for label in first]
    columns = next(n for n in range(len(first), 0, -1) if n == 1 or _width(widths, n) <= room)
    ax.legend(
        list(first.values()),
        list(first),
        loc="lower left",
        bbox_to_anchor=(0, 1),
        ncols=columns,
        frameon=False,
    )


def _width(widths: list[float], columns: int) -> float:
    """The approximate width of a legend, in letter heights; entries go down its columns."""
    long, longer = divmod(len(widths), columns)
    ends = np.cumsum([0] + [long + (place < longer) for place in range(columns)])
    return sum(max(widths[a:b]) for a, b in zip(ends, ends[1:])) + 2.0 * (columns - 1)

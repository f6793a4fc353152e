"""Pictures of results with matplotlib: the content of the axes."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _plot
from ._ask import catalogue

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .answer import Answer


def draw(answer: "Answer", ax: "Axes | None") -> "Axes":
    """The picture of a result."""
    command = answer._asked.command
    if command not in PICTURES:
        drawn = any(parameter.name == "figure" for parameter in catalogue()[command].parameters)
        instead = (
            "answer.picture() has that of the command"
            if drawn
            else f"there are some of {', '.join(PICTURES)}"
        )
        raise TypeError(f"there is no plot of the result of `{command}`: {instead}")
    return PICTURES[command](answer, ax)


def _decay(answer: "Answer", ax: "Axes | None") -> "Axes":
    turns = answer.turning_points
    ax = _plot.axes(ax, ("t / s", "amplitude / °"))
    for name, label in [
        ("amplitude_rad", "integrated"),
        ("averaged_rad", "averaged"),
        ("small_amplitude_rad", "law of small amplitudes"),
    ]:
        ax.plot(turns.time_s, np.degrees(turns[name]), label=label)
    _plot.legend(ax)
    return ax


def _motion(answer: "Answer", ax: "Axes | None") -> "Axes":
    ax = _plot.axes(ax, ("t / s", "θ / °"))
    ax.plot(answer.samples.time_s, np.degrees(answer.samples.angle_rad))
    return ax


def _period(answer: "Answer", ax: "Axes | None") -> "Axes":
    results = answer.results
    ax = _plot.axes(ax, ("θ₀ / °", "T / s"))
    marker = "." if len(results) < 50 else ""
    ax.plot(np.degrees(results.amplitude_rad), results.period_s, marker=marker)
    return ax


def _fourier(answer: "Answer", ax: "Axes | None") -> "Axes":
    terms = answer.harmonics
    ax = _plot.axes(ax, ("harmonic", "absolute value of the coefficient"))
    for name, label in [("angle_rad", "angle / rad"), ("velocity_rad_per_s", "velocity / (rad/s)")]:
        ax.plot(terms.n, np.abs(terms[name]), linestyle="", marker="o", markersize=4, label=label)
    ax.set_yscale("log")
    _plot.legend(ax)
    return ax


def _plan(answer: "Answer", ax: "Axes | None") -> "Axes":
    choices = answer.choices
    ax = _plot.axes(ax, ("amplitude / °", "relative uncertainty of g"))
    for name in ("total", "noise", "angle_scale", "length", "clock"):
        part = np.asarray(choices[name], dtype=float)
        if (part > 0).any():
            ax.plot(
                np.degrees(choices.amplitude_rad),
                np.where(part > 0, part, np.nan),
                marker=".",
                label=name.replace("_", " "),
            )
    ax.axhline(answer["wanted"], color="#888888", linewidth=0.8)
    ax.set_yscale("log")
    _plot.legend(ax)
    return ax


def _backbone(answer: "Answer", ax: "Axes | None") -> "Axes":
    points = answer.points
    ax = _plot.axes(ax, ("amplitude", "frequency"))
    for name, label in [
        ("angular_frequency_rad_per_s", "orbit"),
        ("series_angular_frequency_rad_per_s", f"series to order {answer['order']}"),
        ("exact", "exact"),
    ]:
        values = np.asarray(points[name], dtype=float)
        if np.isfinite(values).any():
            linestyle = "-" if label == "orbit" else "--"
            ax.plot(points.amplitude, values, label=label, linestyle=linestyle)
    _plot.legend(ax)
    return ax


def _orbit(answer: "Answer", ax: "Axes | None") -> "Axes":
    terms = answer.harmonics
    phase = 2 * np.pi * np.linspace(0, 1, 401)
    ax = _plot.axes(ax, ("t / s", ", ".join(dict.fromkeys(terms.coordinate))))
    for name in dict.fromkeys(terms.coordinate):
        own = terms.coordinate == name
        turns = np.outer(phase, np.asarray(terms.n)[own])
        cosine, sine = np.asarray(terms.cosine)[own], np.asarray(terms.sine)[own]
        values = np.cos(turns) @ cosine + np.sin(turns) @ sine
        ax.plot(phase * answer["period_s"] / (2 * np.pi), values, label=name)
    if len(set(terms.coordinate)) > 1:
        _plot.legend(ax)
    return ax


def _resonance(answer: "Answer", ax: "Axes | None") -> "Axes":
    if "exchange" not in answer:
        raise TypeError("there is a picture only for an exchange of energy: give initial")
    ends = np.asarray(answer["exchange"]["amplitudes"])
    ax = _plot.axes(ax, ("mode", "amplitude"))
    places = np.arange(1, len(ends) + 1)
    ax.vlines(places, ends[:, 0], ends[:, 1])
    ax.plot(places, ends, linestyle="", marker="_")
    ax.set_xticks(places)
    return ax


def _melnikov(answer: "Answer", ax: "Axes | None") -> "Axes":
    phase = 2 * np.pi * np.linspace(0, 1, 361)
    ax = _plot.axes(ax, ("phase of the drive at the bottom / °", "M / (rad²/s²)"))
    for separatrix in answer.separatrices:
        values = np.full_like(phase, separatrix["mean_rad2_per_s2"])
        for term in separatrix["harmonics"]:
            values += term["cosine_rad2_per_s2"] * np.cos(term["n"] * phase)
            values += term["sine_rad2_per_s2"] * np.sin(term["n"] * phase)
        label = "upper separatrix" if separatrix["direction"] > 0 else "lower separatrix"
        ax.plot(np.degrees(phase), values, label=label)
    ax.axhline(0, color="grey", linewidth=0.8, linestyle="--")
    _plot.legend(ax)
    return ax


def _response(answer: "Answer", ax: "Axes | None") -> "Axes":
    rotates = any(branch["turns"] for branch in answer.branches)
    name = answer["coordinate"]
    label = f"{name} from uniform rotation" if rotates else f"largest |{name}|"
    ax = _plot.axes(ax, (answer["parameter"], label))
    kinds = list(dict.fromkeys(branch["kind"] for branch in answer.branches))
    for branch in answer.branches:
        colour = _plot.COLOURS[kinds.index(branch["kind"]) % len(_plot.COLOURS)]
        value, amplitude, stability = (
            np.array([point[name] for point in branch["points"]])
            for name in ("parameter", "amplitude_max", "stability")
        )
        ax.plot(value, amplitude, linestyle="--", linewidth=0.8, color=colour)
        label = branch["kind"].replace("_", " ")
        stable = np.where(stability != "unstable", value, np.nan)
        ax.plot(stable, amplitude, color=colour, label=label)
        for special in branch["special"]:
            place = [special["parameter"]], [special["amplitude_max"]]
            ax.plot(*place, linestyle="", marker="o", markersize=4, color=colour)
    for direction, colour, size in (("up", "black", 5), ("down", "#E69F00", 3)):
        swept = [it for it in answer["sweeps"] if it["direction"] == direction]
        places = [
            (it["parameter"], it["amplitude_max"])
            for it in swept
            if it["amplitude_max"] is not None and bool(it["turns"]) == rotates
        ]
        if places:
            x, y = zip(*places)
            label = f"swept {direction}"
            ax.plot(x, y, linestyle="", marker=".", markersize=size, color=colour, label=label)
    _plot.legend(ax)
    return ax


def _stability(answer: "Answer", ax: "Axes | None") -> "Axes":
    ax = _plot.axes(ax, tuple(answer["parameters"]))
    kinds = list(dict.fromkeys(curve["kind"] for curve in answer.curves))
    for curve in answer.curves:
        colour = _plot.COLOURS[kinds.index(curve["kind"]) % len(_plot.COLOURS)]
        x, y = np.array([point["parameters"] for point in curve["points"]]).T
        ax.plot(x, y, color=colour, label=curve["kind"].replace("_", " "))
    _plot.legend(ax)
    return ax


def _section(answer: "Answer", ax: "Axes | None") -> "Axes":
    names, points = answer["state"], answer.points
    ax = _plot.axes(ax, (names[0], names[len(names) // 2]))
    for motion in np.unique(points.motion):
        states = points.state[points.motion == motion]
        ax.plot(states[:, 0], states[:, len(names) // 2], linestyle="", marker=".", markersize=3)
    return ax


def _bifurcation(answer: "Answer", ax: "Axes | None") -> "Axes":
    points = answer.points
    ax = _plot.axes(ax, (answer["parameter"], answer["state"][0]))
    for sweep in dict.fromkeys(points.sweep):
        chosen = points.sweep == sweep
        places = points.value[chosen], points.state[chosen, 0]
        ax.plot(*places, linestyle="", marker=".", markersize=2, label=sweep)
    if len(set(points.sweep)) > 1:
        _plot.legend(ax)
    return ax


def _lyapunov(answer: "Answer", ax: "Axes | None") -> "Axes":
    ax = _plot.axes(ax, ("t", "largest Lyapunov exponent"))
    ax.plot(answer.convergence.time_s, answer.convergence.exponent_per_s)
    ax.axhline(0, color="#888888", linewidth=0.8)
    return ax


def _modes(answer: "Answer", ax: "Axes | None") -> "Axes":
    if "points" in answer:
        return _followed_mode(answer, ax)
    ax = _plot.axes(ax, ("coordinate", "shape"))
    for mode in answer.modes:
        label = f"ω = {mode['angular_frequency_rad_per_s']:.6g}"
        ax.plot(answer["coordinates"], mode["shape"], marker="o", label=label)
    _plot.legend(ax)
    return ax


def _followed_mode(answer: "Answer", ax: "Axes | None") -> "Axes":
    points = answer.points
    omega = points.angular_frequency_rad_per_s
    series = np.asarray(points.series_angular_frequency_rad_per_s, dtype=float)
    ax = _plot.axes(ax, (f"amplitude of {answer['coordinate']}", "ω / (rad/s)"))
    for stable, marker, label in [(True, "o", "stable"), (False, "x", "unstable")]:
        here = (points.stability != "unstable") == stable
        if here.any():
            places = points.amplitude[here], omega[here]
            ax.plot(*places, linestyle="", marker=marker, markersize=4, label=label)
    ax.plot(points.amplitude, omega, linewidth=0.8, color="#888888", zorder=1)
    # The series leaves the frame where it is far off.
    limits = ax.get_ylim()
    ax.plot(points.amplitude, series, linestyle=":", color=_plot.COLOURS[2], label="ω + κa²")
    ax.set_ylim(limits)
    _plot.legend(ax)
    return ax


def _simulate(answer: "Answer", ax: "Axes | None") -> "Axes":
    names = [name for name in answer["state"] if not name.endswith("'")]
    ax = _plot.axes(ax, ("t", ", ".join(names)))
    for place, name in enumerate(names):
        ax.plot(answer.samples.time_s, answer.samples.state[:, place], label=name)
    if len(names) > 1:
        _plot.legend(ax)
    return ax


def _fit_trace(answer: Any, ax: "Axes | None") -> "Axes":
    rows = answer.residuals()
    ax = _plot.axes(ax, ("t / s", "θ / °"))
    traces = list(dict.fromkeys(rows.trace))
    law = _plot.COLOURS[1] if len(traces) == 1 else "black"
    for place, trace in enumerate(traces):
        chosen, colour = rows.trace == trace, _plot.COLOURS[place % len(_plot.COLOURS)]
        label = "measured" if len(traces) == 1 else trace
        t, value = rows.time_s[chosen], np.degrees(rows.value[chosen])
        ax.plot(t, np.degrees(rows.fitted[chosen]), color=law, linewidth=1.2, label="fitted")
        ax.plot(t, value, linestyle="", marker=".", markersize=3, color=colour, label=label)
    _plot.legend(ax)
    return ax


def _fit_gates(answer: "Answer", ax: "Axes | None") -> "Axes":
    ax = _plot.axes(ax, ("t / s", "T / s"))
    ax.plot(answer.cycles.time_s, answer.cycles.period_s, linestyle="", marker=".")
    return ax


def _fit_response(answer: Any, ax: "Axes | None") -> "Axes":
    is_angle = answer["amplitude_unit"] == "rad"
    scale = np.degrees(1.0) if is_angle else 1.0
    unit = "°" if is_angle else answer["amplitude_unit"]
    ax = _plot.axes(ax, ("Ω / (rad/s)", f"amplitude / {unit}"))
    places = answer.measurements.angular_frequency_rad_per_s, scale * answer.measurements.amplitude
    ax.plot(*places, linestyle="", marker="o", markersize=4, label="measured")
    curve = answer.curve
    for stable, dashes, label in [(True, "-", "stable"), (False, "--", "unstable")]:
        for branch in dict.fromkeys(curve.branch):
            own = curve.branch == branch
            here = (curve.stability[own] != "unstable") == stable
            amplitude = np.where(here, scale * curve.amplitude[own], np.nan)
            name = label if here.any() else "_"
            places = curve.angular_frequency_rad_per_s[own], amplitude
            ax.plot(*places, dashes, color=_plot.COLOURS[1], label=name)
    _plot.legend(ax)
    return ax


def _spectrum(answer: Any, ax: "Axes | None") -> "Axes":
    traces = answer.traces
    if not len(traces) or "spectrum_hz" not in traces[0]:
        raise TypeError(
            "there is no picture of the contents of a file, but one of its harmonics: "
            "lab.spectrum(recording).plot()"
        )
    is_angle = traces[0]["unit"] == "rad"
    scale = np.degrees(1.0) if is_angle else 1.0
    ax = _plot.axes(ax, ("frequency / Hz", "amplitude / °" if is_angle else "amplitude / (rad/s)"))
    for place, trace in enumerate(traces):
        colour = _plot.COLOURS[place % len(_plot.COLOURS)]
        name = f"spectrum, {trace['name']}" if trace["name"] else "spectrum"
        amplitudes = scale * np.asarray(trace["spectrum_amplitudes"], dtype=float)
        ax.plot(trace["spectrum_hz"], amplitudes, color=colour, linewidth=0.8, label=name)
        lines = trace.harmonics
        hz = lines.frequency_hz
        theory, amplitude, spread = (
            scale * np.abs(np.asarray(lines[key], dtype=float))
            for key in ("theory", "amplitude", "amplitude_uncertainty")
        )
        known, is_above = theory > 0, amplitude > 2 * spread
        seen, lost = (lines.n > 0) & is_above, (lines.n > 0) & (amplitude <= 2 * spread)
        squares: dict[str, Any] = {"marker": "s", "markersize": 7, "markerfacecolor": "none"}
        ax.plot(hz[known], theory[known], linestyle="", **squares, color="black", label="pendulum")
        dots: dict[str, Any] = {"linestyle": "", "marker": "o", "markersize": 4, "color": colour}
        ax.errorbar(hz[seen], amplitude[seen], spread[seen], **dots, label="measured")
        if lost.any():
            limits: dict[str, Any] = {**dots, "marker": "v", "label": "upper limit (2σ)"}
            ax.plot(hz[lost], (amplitude + 2 * spread)[lost], **limits)
    ax.set_yscale("log")
    _plot.legend(ax)
    return ax


PICTURES: "dict[str, Callable[[Any, Axes | None], Axes]]" = {
    "period": _period,
    "motion": _motion,
    "fourier": _fourier,
    "decay": _decay,
    "backbone": _backbone,
    "simulate": _simulate,
    "modes": _modes,
    "orbit": _orbit,
    "resonance": _resonance,
    "melnikov": _melnikov,
    "response": _response,
    "stability": _stability,
    "section": _section,
    "bifurcation": _bifurcation,
    "lyapunov": _lyapunov,
    "plan": _plan,
    "inspect": _spectrum,
    "fit gates": _fit_gates,
    "fit trace": _fit_trace,
    "fit response": _fit_response,
}

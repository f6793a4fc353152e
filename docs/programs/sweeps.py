"""The pictures of the page on sweeps: a bifurcation diagram, finite-time Lyapunov exponents, basins of attraction.

    python docs/programs/sweeps.py [DIRECTORY [SIDE]]

The stores go to the directory, target/sweeps if none is given, and are gone on with when it is called again; the pictures to docs/_static. SIDE × SIDE double pendulums
are followed, 100 × 100 if nothing is said.
"""

import sys
import time
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import libration as lb

ROOT = Path(__file__).parents[2]
STORES = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "target/sweeps"
SIDE = int(sys.argv[2]) if len(sys.argv) > 2 else 100
PICTURES = ROOT / "docs/_static"


def folded(angle):
    """The angle in the turn from −π to π."""
    return (angle + np.pi) % (2 * np.pi) - np.pi


def timed(name, *question, **how):
    begin = time.perf_counter()
    found = lb.sweep(*question, STORES / f"{name}.zarr", progress=sys.stderr.isatty(), **how).load()
    print(f"{name}: {found.status.size} points, {int((found.status != 0).sum())} without an answer, {time.perf_counter() - begin:.1f} s")
    return found


def picture(name, figure):
    figure.savefig(PICTURES / f"sweep_{name}.png", dpi=110, bbox_inches="tight", metadata={"Software": None})
    plt.close(figure)


def bifurcation():
    """A million points: the velocity once per period of the drive, for 2000 amplitudes of the drive."""
    found = timed(
        "bifurcation",
        "section driven_pendulum --set c=1/2 --initial theta=0.2 --skip 200 --points 500 --no-errors",
        {"A": np.linspace(1.0, 1.5, 2000)},
        keep={"omega": "points[0:500].state[1]"},
    )
    figure, ax = plt.subplots(figsize=(8, 4.5))
    amplitude = np.broadcast_to(found.A.values[:, None], found.omega.shape)
    ax.plot(amplitude.ravel(), found.omega.values.ravel(), ",", color="black", alpha=0.25)
    ax.set(xlabel="amplitude of the drive A", ylabel="velocity at the beginning of each period of the drive", xlim=(1, 1.5))
    picture("bifurcation", figure)


def exponents():
    """Divergence of neighbouring double pendulums within 50 s after release from rest."""
    angles = np.radians((np.arange(SIDE) + 0.5) * 360 / SIDE - 180)
    found = timed(
        "exponents",
        "lyapunov double_pendulum --transient 0 --time 50",
        {"theta1": angles, "theta2": angles},
        keep=["exponent_per_s"],
    )
    # A dot of the picture for each of 400 × 400.
    figure, ax = plt.subplots(figsize=(7.2, 6))
    image = ax.imshow(found.exponent_per_s.values.T, origin="lower", extent=(-180, 180, -180, 180), cmap="viridis", vmin=0)
    ax.set(xlabel="upper angle at the start / °", ylabel="lower angle at the start / °", xticks=range(-180, 181, 90), yticks=range(-180, 181, 90))
    figure.colorbar(image, label="finite-time Lyapunov exponent / (1/s)")
    picture("exponents", figure)


def basins():
    """Periodic motions that a driven pendulum reaches from 300 × 300 starts, 80 periods of the drive later."""
    found = timed(
        "basins",
        "section driven_pendulum --set c=0.2,A=1.66,omega=1 --skip 80 --points 2",
        {"theta": np.linspace(-np.pi, np.pi, 301)[:-1], "theta'": np.linspace(-3, 4, 300)},
        keep={"angle": "points[0:2].state[0]", "velocity": "points[0:2].state[1]"},
    )
    # Two ends of periods of the drive, one after the other; a motion of twice the period is at either of two places.
    places = np.stack([np.cos(found.angle), np.sin(found.angle), found.velocity], axis=-1).reshape(-1, 2, 3)
    attractors, reached = [], np.full(len(places), -1)
    for number, pair in enumerate(places):
        near = [k for k, known in enumerate(attractors) if (np.abs(known - pair[1]).max(axis=-1) < 0.02).any()]
        if not near and len(attractors) < 8:
            attractors.append(pair)
            near = [len(attractors) - 1]
        reached[number] = near[0] if near else -1
    common = np.argsort([-np.count_nonzero(reached == k) for k in range(len(attractors))])[:3]
    colours = np.full(len(places), 0)
    for colour, k in enumerate(common, 1):
        colours[reached == k] = colour
        print(f"  {np.mean(reached == k):.3f} of the starts reach {attractors[k].round(3).tolist()}")
    figure, ax = plt.subplots(figsize=(5.6, 4.6))
    chosen = matplotlib.colors.ListedColormap(["black", "#0072B2", "#E69F00", "#009E73"])
    ax.imshow(colours.reshape(found.angle.shape[:2]).T, origin="lower", extent=(-np.pi, np.pi, -3, 4), cmap=chosen, vmin=0, vmax=3, aspect="auto", interpolation="nearest")
    ax.set(xlabel="angle at the start / rad", ylabel="velocity at the start / (rad/s)")
    picture("basins", figure)


if __name__ == "__main__":
    bifurcation()
    exponents()
    basins()

"""Make examples/class/: small tables as students write them, each in another form.

    python reference/class_tables.py examples/class

Pendulums with g = 9.81 m/s^2: T = 2 pi sqrt(L/g) for small swings, T = T0 / AGM(1, cos(A/2)) against the amplitude. A time by hand has a normal
error of 0.08 s, whatever number of swings it lasts. Needs mpmath and NumPy; the seed is fixed.
"""

import sys
from pathlib import Path

import mpmath
import numpy as np

G = 9.81
BY_HAND = 0.08

rng = np.random.default_rng(1656)


def period(length):
    return 2 * np.pi * np.sqrt(length / G)


def time(swings, length):
    return swings * period(length) + BY_HAND * rng.standard_normal()


def comma(text):
    return text.replace(".", ",")


def readings(swings, length, number, digits=2):
    return [f"{time(swings, length):.{digits}f}" for _ in range(number)]


def tables():
    lengths = [0.20, 0.35, 0.50, 0.65, 0.80, 1.00]
    yield "cells_with_units.csv", [f"{100 * l:.0f}cm,{time(10, l) / 10:.3f}s" for l in lengths]
    yield "plus_minus.csv", ["L (m);T (s)"] + [
        comma(f"{l:.2f} ± 0.002;{time(10, l) / 10:.3f} ± 0.008") for l in lengths]
    yield "brackets.csv", ["L (m),T (s)"] + [f"{l:.3f}(2),{time(10, l) / 10:.3f}(8)" for l in lengths]
    rows = [f"{l:.2f},{time(10, l) / 10:.3f}" for l in lengths]
    yield "header_in_first_row.csv", ["L (m),T (s)" + rows[0]] + rows[1:]
    yield "squares.csv", ["L (cm)\tT^2 (s^2)"] + [f"{100 * l:.0f}\t{(time(10, l) / 10) ** 2:.3f}" for l in lengths]
    amplitudes = [0.2, 0.5, 0.8, 1.1, 1.4, 1.7]
    ratio = [float(1 / mpmath.agm(1, mpmath.cos(a / 2))) for a in amplitudes]
    yield "initials.csv", ["Theta (rad),Period (s),T uncertainty,P uncertainty"] + [
        f"{a:.2f},{period(1) * r + 0.008 * rng.standard_normal():.3f},0.02,0.008" for a, r in zip(amplitudes, ratio)]
    names = ["Ada", "Ben", "Cem", "Dora", "Eva", "Finn"]
    rows = [(n, l, time(10, l) / 10) for n, l in zip(names, lengths)]
    yield "names_and_mean.csv", ["name,L (m),T (s)"] + [f"{n},{l},{t:.3f}" for n, l, t in rows] + [
        f"mean,{np.mean(lengths):.3f},{np.mean([t for *_, t in rows]):.3f}"]
    yield "units_below.csv", ["L,T", "cm,s"] + [f"{100 * l:.0f},{time(10, l) / 10:.3f}" for l in lengths]
    yield "side_by_side.csv", ["L (m),T (s),,L (m),T (s)"] + [
        f"{l:.2f},{time(10, l) / 10:.3f},,{l + 0.05:.2f},{time(10, l + 0.05) / 10:.3f}" for l in lengths]
    yield "ten_swings.csv", ["L (cm),time for 10 swings 1 (s),time for 10 swings 2 (s),time for 10 swings 3 (s),mean (s),T (s)"] + [
        ",".join([f"{100 * l:.0f}", *t, f"{np.mean([float(x) for x in t]):.3f}", f"{np.mean([float(x) for x in t]) / 10:.4f}"])
        for l, t in ((l, readings(10, l, 3)) for l in lengths)]
    yield "groups.csv", ["group,L (cm),t1 (s),t2 (s),t3 (s),swings"] + [
        ",".join([group, f"{100 * l:.0f}", *readings(swings, l, 3), str(swings)])
        for group, swings in (("A", 10), ("B", 20), ("C", 10)) for l in lengths[1:]]
    yield "amplitudes.csv", ["A (deg),20 T 1 (s),20 T 2 (s),20 T 3 (s)"] + [
        ",".join([str(a)] + [
            f"{20 * period(0.5) / float(mpmath.agm(1, mpmath.cos(mpmath.radians(a) / 2))) + BY_HAND * rng.standard_normal():.2f}"
            for _ in range(3)]) for a in (10, 20, 30, 40, 50, 60)]
    at_ten_degrees = 1 / float(mpmath.agm(1, mpmath.cos(mpmath.radians(10) / 2)))
    yield "one_length.csv", ["L (cm),10 T (s)"] + [
        f"56,{10 * period(0.56) * at_ten_degrees + BY_HAND * rng.standard_normal():.2f}" for _ in range(6)]


def main():
    folder = Path(sys.argv[1])
    for name, rows in tables():
        (folder / name).write_text("\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

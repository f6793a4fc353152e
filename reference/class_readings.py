"""Make crates/libration-lab/tests/data/class_readings.csv: 800 tables of a class's readings, whose truth is known.

    python reference/class_readings.py > crates/libration-lab/tests/data/class_readings.csv

Half of the tables have periods against amplitudes of one pendulum, T = T0 / AGM(1, cos(A/2)), half small swings of strings of different lengths,
T = 2 pi sqrt((L + d)/g) with an unknown d. Each row is timed several times over a number of swings, by one of these designs:

* readings: three to six readings by hand, with a normal error, rounded to 0.01 s;
* outlier: the same, one reading in the table off by 1 to 3 s;
* coarse: readings with a small error, rounded to steps that are larger: the step is half of a rectangular distribution's width;
* single: one reading in each row, with the reaction time as its error;
* groups: three to five groups with readings like those of the first design, and one clock whose error all share.

A table is a line with its quantity (t0 or gravity), design, truth, step of the readings in s, relative uncertainty of the shared clock and number
of swings of each reading, and lines with the group, the amplitude in rad or length in m, and readings in s separated by blanks. Independent of
libration; needs NumPy; the seed is fixed.
"""

import numpy as np

rng = np.random.default_rng(400)
DESIGNS = {"readings": 120, "outlier": 60, "coarse": 80, "single": 80, "groups": 60}


def ratio(amplitude):
    a, b = 1.0, np.cos(amplitude / 2)
    for _ in range(6):
        a, b = (a + b) / 2, np.sqrt(a * b)
    return 1 / a


def rounded(value, step):
    return round(value / step) * step


def rows_of(quantity, number):
    """Amplitudes or lengths, T of each, and the truth."""
    if quantity == "t0":
        x = np.round(np.sort(rng.uniform(0.05, 1.2, number)), 3)
        truth = rng.uniform(1.0, 2.5)
        return x, truth * np.array([ratio(a) for a in x]), truth
    x = np.round(np.sort(rng.uniform(0.2, 1.5, number)), 3)
    offset, truth = rng.uniform(0.0, 0.03), 9.81
    return x, 2 * np.pi * np.sqrt((x + offset) / truth), truth


def table(quantity, design):
    number = int(rng.integers(5, 9))
    swings = int(rng.choice([5, 10, 20]))
    count = {"single": 1}.get(design, int(rng.integers(3, 7)))
    groups = int(rng.integers(3, 6)) if design == "groups" else 1
    by_hand = rng.uniform(0.05, 0.2)
    step = 0.01
    if design == "coarse":
        step = float(rng.choice([0.1, 0.2, 0.5]))
        by_hand = step * rng.uniform(0.0, 0.1)
    clock = 0.002 if design == "groups" else 0.0
    rate = 1 + clock * rng.standard_normal()
    x, period, truth = rows_of(quantity, number)
    blunder = (int(rng.integers(number)), rng.choice([-1, 1]) * rng.uniform(1, 3))
    print(f"{quantity},{design},{truth:.9g},{step},{clock},{swings}")
    for group in range(groups):
        for row in range(number):
            error = by_hand * rng.standard_normal(count)
            if design == "outlier" and row == blunder[0]:
                error[0] += blunder[1]
            readings = [f"{rounded(t, step):.2f}" for t in swings * period[row] * rate + error]
            label = "ABCDE"[group]
            print(f"{label},{x[row]:.3f},{' '.join(readings)}")


def main():
    print("# Readings of a class by reference/class_readings.py: tables with quantity, design, truth, step/s, clock, swings; rows with group, x, readings/s.")
    print("# Synthetic; MIT or Apache-2.0.")
    for quantity in ("t0", "gravity"):
        for design, number in DESIGNS.items():
            for _ in range(number):
                table(quantity, design)


if __name__ == "__main__":
    main()

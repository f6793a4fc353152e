"""Make examples/bar_synthetic.csv and examples/reversible_synthetic.csv: a bar turned about several points, and a reversible pendulum.

    python reference/synthetic_bars.py bar > examples/bar_synthetic.csv
    python reference/synthetic_bars.py reversible > examples/reversible_synthetic.csv

T = 2 pi sqrt((k^2 + h^2)/(g h)) at a distance h from the centre of mass. Needs NumPy; the seed is fixed.
"""

import sys

import numpy as np

G = 9.81


def period(h, k):
    return 2 * np.pi * np.sqrt((k**2 + h**2) / (G * h))


def bar(rng):
    centre, k = 0.5012, 1 / np.sqrt(12)
    print("# Synthetic, not measured: a bar of 1 m with its centre of mass at 50.12 cm, g = 9.81 m/s^2; errors of 0.5 mm and 2 ms.")
    print("# Made by reference/synthetic_bars.py.")
    print("position (cm),T (s),u(position) (cm),u(T) (s)")
    for x in [0.02, 0.08, 0.14, 0.20, 0.26, 0.32, 0.38, 0.44, 0.56, 0.62, 0.68, 0.74, 0.80, 0.86, 0.92, 0.98]:
        t = period(abs(x - centre), k) + 0.002 * rng.standard_normal()
        print(f"{100 * x + 0.05 * rng.standard_normal():.2f},{t:.4f},0.05,0.002")


def reversible(rng):
    edges, far, k2 = 0.9935, 0.6621, 0.6608 * (0.9935 - 0.6608)
    print("# Synthetic, not measured: a reversible pendulum with knife edges 0.9935 m apart, g = 9.81 m/s^2; five periods about each edge.")
    print("# Made by reference/synthetic_bars.py.")
    print("h (m),T (s),u(h) (m),u(T) (s)")
    for h, seen in [(far, 0.6624), (edges - far, 0.3311)]:
        for _ in range(5):
            t = period(h, np.sqrt(k2)) + 0.0002 * rng.standard_normal()
            print(f"{seen},{t:.5f},0.001,0.0002")


if __name__ == "__main__":
    {"bar": bar, "reversible": reversible}[sys.argv[1]](np.random.default_rng(1818))

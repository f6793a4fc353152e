"""tests/data/lyapunov.csv: largest Lyapunov exponents of well-known chaotic systems.

Means over many motions at once of the growth of a deviation, by the classical Runge-Kutta method with its linearised
equations written out by hand. Run: python reference/lyapunov.py > crates/libration-testing/data/lyapunov.csv
"""
from math import pi, sqrt

import numpy as np
from numpy import cos, sin

HEADER = """\
# Largest Lyapunov exponents. Source: computed by reference/lyapunov.py (NumPy, Runge-Kutta of the fourth order, means over many
# motions). Licence: MIT OR Apache-2.0. equation; start: coordinates, then velocities, at t = 0, of the motion whose neighbours
# make the ensemble; exponent in 1/time, error: its standard error.
equation,start,exponent,error"""
SETTLE = 100  # periods before anything is measured


def driven(damping, force, slope, drive, frequency):
    """x'' = -damping x' + force(x) + drive cos(frequency t), and its linearised equation."""

    def rates(t, y):
        x, v, dx, dv = y
        acceleration = force(x) - damping * v + drive * cos(frequency * t)
        return np.array([v, acceleration, dv, slope(x) * dx - damping * dv])

    return rates


def henon_heiles(_, state):
    x, y, u, v, dx, dy, du, dv = state
    forces = [-x - 2 * x * y, -y - x * x + y * y]
    return np.array([u, v, *forces, du, dv, -dx - 2 * (dx * y + x * dy), -dy - 2 * x * dx + 2 * y * dy])


def line(y, energy):
    """A start on the plane x = 0 of the Hénon-Heiles system with y' = 0."""
    return [0.0, y, sqrt(2 * energy - y * y + 2 / 3 * y**3), 0.0]


def sine(x):
    return -sin(x)


PENDULUM = (sine, lambda x: -cos(x))
MANY, LONG = (2000, 200), (300, 3000)  # motions and periods; long where some motions stay regular for long
CASES = [  # equation, rates, start, period, steps in it, motions and periods
    ("theta'' + theta'/2 + sin(theta) = 1.5 cos(2t/3)", driven(0.5, *PENDULUM, 1.5, 2 / 3), [0.2, 0.0], 3 * pi, 300, MANY),
    ("theta'' + theta'/20 + sin(theta) = 0.6 cos(0.7t)", driven(0.05, *PENDULUM, 0.6, 0.7), [0.2, 0.0], 2 * pi / 0.7, 300, MANY),
    ("x'' + 0.05 x' + x^3 = 7.5 cos(t)", driven(0.05, lambda x: -(x**3), lambda x: -3 * x * x, 7.5, 1), [3.0, 4.0], 2 * pi, 400, MANY),
    ("x'' + 0.25 x' - x + x^3 = 0.4 cos(t)", driven(0.25, lambda x: x - x**3, lambda x: 1 - 3 * x * x, 0.4, 1), [1.0, 0.0], 2 * pi, 300, MANY),
    ("x'' = -x - 2 x y; y'' = -y - x^2 + y^2", henon_heiles, line(-0.25, 1 / 8), 2 * pi, 200, LONG),
    ("x'' = -x - 2 x y; y'' = -y - x^2 + y^2", henon_heiles, line(-0.15, 1 / 6 - 1e-9), 2 * pi, 200, LONG),
]  # fmt: skip


def period_passed(rates, y, period, steps):
    h = period / steps
    for n in range(steps):
        t = n * h
        a = rates(t, y)
        b = rates(t + h / 2, y + h / 2 * a)
        c = rates(t + h / 2, y + h / 2 * b)
        d = rates(t + h, y + h * c)
        y = y + h / 6 * (a + 2 * b + 2 * c + d)
    return y


def exponent(rates, start, period, steps, motions, periods):
    """Mean and standard error over the motions."""
    generator = np.random.default_rng(1)
    half = len(start)
    y = np.zeros((2 * half, motions))
    # Displaced by less than the fourth-order errors matter, but enough to be elsewhere after the transient.
    y[:half] = np.array(start)[:, None] + 1e-8 * generator.standard_normal((half, motions))
    y[half:] = generator.standard_normal((half, motions))
    growth = np.zeros(motions)
    for n in range(SETTLE + periods):
        y = period_passed(rates, y, period, steps)
        size = np.sqrt((y[half:] ** 2).sum(axis=0))
        y[half:] /= size
        growth += np.log(size) * (n >= SETTLE)
    means = growth / (periods * period)
    return means.mean(), means.std() / sqrt(motions)


print(HEADER)
for equation, rates, start, period, steps, count in CASES:
    mean, error = exponent(rates, start, period, steps, *count)
    print(f"{equation},{' '.join(map(repr, start))},{mean:.5f},{max(error, 1e-5):.5f}", flush=True)

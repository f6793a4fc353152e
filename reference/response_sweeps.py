"""Slow sweeps of driven oscillators: python reference/response_sweeps.py pendulum > crates/libration-lab/tests/data/response_pendulum.csv

(and likewise duffing). x'' = -c x' - f(x) + A cos(w t) is integrated by scipy's DOP853 from the state in which the frequency before ended, until
two pieces of thirty times 1/c end alike to 1e-11. Peak: the largest |x| of a period; fundamental and lag: from 4096 values in it.
Needs: pip install scipy. Takes half a minute.
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

TOLERANCES = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
SYSTEMS = {
    "pendulum": (lambda x: 3.1**2 * np.sin(x), 0.27, 1.35, np.arange(2.0, 3.61, 0.1), 0.03,
                 "theta'' = -0.27*theta' - 3.1^2*sin(theta) + 1.35*cos(w*t)"),
    "duffing": (lambda x: 4 * x + 1.5 * x**3, 0.12, 1.0, np.arange(1.4, 3.61, 0.12), -0.05,
                "x'' = -0.12*x' - 2^2*x - 1.5*x^3 + cos(w*t)"),
}


def settled(motion, period, state, damping):
    periods = int(np.ceil(30 / damping / period))
    for _ in range(6):
        before = state
        state = solve_ivp(motion, (0, periods * period), state, **TOLERANCES).y[:, -1]
        if np.max(abs(state - before)) < 1e-11:
            break
    return state


def sweep(force, damping, drive, frequencies):
    state = np.zeros(2)
    for w in frequencies:
        period = 2 * np.pi / w

        def motion(t, y):
            return [y[1], -damping * y[1] - force(y[0]) + drive * np.cos(w * t)]

        state = settled(motion, period, state, damping)
        path = solve_ivp(motion, (0, period), state, dense_output=True, **TOLERANCES).sol
        times = np.linspace(0, period, 4097)[:-1]
        x = path(times)[0]
        top = times[np.argmax(abs(x))]
        near = (max(top - period / 4096, 0), min(top + period / 4096, period))
        peak = -minimize_scalar(lambda t: -abs(path(t)[0]), bounds=near, method="bounded", options={"xatol": 1e-12}).fun
        harmonic = 2 * np.mean(x * np.exp(1j * w * times))
        yield w, max(peak, np.max(abs(x))), abs(harmonic), np.angle(harmonic)


force, damping, drive, rising, shift, text = SYSTEMS[sys.argv[1]]
print(f"# Sweeps up and then down of {text}")
print("# from rest; made by reference/response_sweeps.py with scipy's DOP853. Licence: as the project.")
print("frequency,peak,fundamental,lag")
rising = np.round(rising, 4)
for frequencies in (rising, np.round(rising[::-1] + shift, 4)):
    for row in sweep(force, damping, drive, frequencies):
        print("{:.4f},{:.11f},{:.11f},{:.11f}".format(*row))

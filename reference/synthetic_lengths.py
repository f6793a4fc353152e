"""Make examples/lengths_synthetic.csv: periods of a ball on strings whose length was measured without the ball.

    python reference/synthetic_lengths.py > examples/lengths_synthetic.csv

T^2 = 4 pi^2 R^2 (L + r + 2r^2/5(L + r))/g with g = 9.81 m/s^2, r = 25 mm and R = T/T0 at 10 degrees; normal errors of 1 mm
and 3 ms. Needs mpmath and NumPy; the seed is fixed.
"""

import mpmath
import numpy as np

G, RADIUS, AMPLITUDE = 9.81, 0.025, np.radians(10)
SIGMA_LENGTH, SIGMA_PERIOD = 0.001, 0.003

rng = np.random.default_rng(1851)
ratio = 1 / float(mpmath.agm(1, mpmath.cos(AMPLITUDE / 2)))
print("# Synthetic, not measured: strings with a ball of radius 25 mm at their end, amplitude 10 degrees, g = 9.81 m/s^2.")
print("# Made by reference/synthetic_lengths.py.")
print("length,period,sigma_length,sigma_period")
for length in np.arange(0.15, 1.26, 0.1):
    whole = length + RADIUS
    period = 2 * np.pi * ratio * np.sqrt((whole + 0.4 * RADIUS**2 / whole) / G)
    measured = length + SIGMA_LENGTH * rng.standard_normal(), period + SIGMA_PERIOD * rng.standard_normal()
    print(f"{measured[0]:.4f},{measured[1]:.4f},{SIGMA_LENGTH},{SIGMA_PERIOD}")

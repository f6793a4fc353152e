"""Make examples/amplitudes_synthetic.csv: turning points of a pendulum on a scale whose zero is off.

    python reference/synthetic_amplitudes.py > examples/amplitudes_synthetic.csv

theta'' + 0.012 theta' + 0.015 theta'|theta'| + omega0^2 sin theta = 0 with omega0 = 4.43 rad/s from 40 degrees, integrated by SciPy; every
seventh turning point on a scale of degrees that reads 0.8 at rest, with normal errors of 0.2 degrees. Needs NumPy and SciPy; the seed
is fixed.
"""

import numpy as np

from damped_amplitudes import turning_points

OMEGA0, LINEAR, QUADRATIC, RELEASE = 4.43, 0.012, 0.015, np.radians(40)
EVERY, ROWS, ZERO, SIGMA = 7, 30, 0.8, 0.2

rng = np.random.default_rng(1638)
print("# Synthetic, not measured: turning points of both sides; omega0 = 4.43 rad/s, linear damping 0.012/s, quadratic 0.015, from 40")
print("# degrees, on a scale that reads 0.8 degrees at rest. Made by reference/synthetic_amplitudes.py.")
print("time (s),turning point (deg),sigma (deg),swing")
points = turning_points(OMEGA0, 0.0, LINEAR, QUADRATIC, RELEASE, EVERY * (ROWS - 1))
for number in range(0, len(points), EVERY):
    time, angle = points[number]
    reading = np.degrees(angle) + ZERO + SIGMA * rng.standard_normal()
    print(f"{time + 0.02 * rng.standard_normal():.2f},{reading:.1f},{SIGMA},{number / 2:g}")

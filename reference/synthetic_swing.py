"""Make examples/swing_synthetic.csv: what a camera sees of a damped pendulum, with noise.

    python reference/synthetic_swing.py > examples/swing_synthetic.csv

A pendulum of 0.56 m where g = 9.81 m/s^2 with linear drag, theta'' = -(g/l) sin(theta) - b theta' with b = 0.03 1/s,
released from rest at 60 degrees. The camera takes 60 pictures a second for 20 s and is tilted by 1.2 degrees; angles have
normal errors of 0.3 degrees and are written to 0.1 degrees, times to 1 ms; three pictures are lost. Needs NumPy and
SciPy; the seed is fixed.
"""

import numpy as np
from scipy.integrate import solve_ivp

LENGTH, GRAVITY, LINEAR = 0.56, 9.81, 0.03
RELEASED, TILT, SIGMA = np.radians(60), 1.2, 0.3
LOST = {341, 342, 800}

rng = np.random.default_rng(1602)
times = np.arange(1200) / 60


def motion(_, state):
    angle, velocity = state
    return [velocity, -GRAVITY / LENGTH * np.sin(angle) - LINEAR * velocity]


swing = solve_ivp(motion, (0, 20), [RELEASED, 0], "DOP853", t_eval=times, rtol=1e-12, atol=1e-12)
angles = np.degrees(swing.y[0]) + TILT + SIGMA * rng.standard_normal(len(times))

print("# Synthetic, not measured: l = 0.56 m, g = 9.81 m/s^2, linear drag 0.03 1/s, released at 60 degrees.")
print("# Made by reference/synthetic_swing.py.")
print("t (s),theta (deg)")
for row, (time, angle) in enumerate(zip(times, angles)):
    if row not in LOST:
        print(f"{time:.3f},{angle:.1f}")

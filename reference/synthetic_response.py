"""Make examples/response_synthetic.csv: a driven pendulum whose frequency is swept up and then down through its jumps.

    python reference/synthetic_response.py > examples/response_synthetic.csv

theta'' = -0.27 theta' - 3.1^2 sin(theta) + 1.35 cos(w t), settled at each frequency (reference/response_sweeps.py pendulum); normal errors of
0.6 degrees of the amplitude, and of as much over the amplitude of the phase. Needs SciPy; the seed is fixed.
"""
import subprocess
import sys
from pathlib import Path

import numpy as np

SWEEPS = Path(__file__).with_name("response_sweeps.py")
SIGMA = 0.6

rng = np.random.default_rng(7)
rows = subprocess.run([sys.executable, SWEEPS, "pendulum"], capture_output=True, text=True, check=True).stdout.splitlines()[3:]
print("# Synthetic, not measured: a driven pendulum, swept up and then down; omega0 = 3.1 rad/s, c = 0.27 1/s, A = 1.35 rad/s^2.")
print("# Made by reference/synthetic_response.py.")
print("frequency (rad/s),amplitude (deg),u(amplitude) (deg),phase (deg),u(phase) (deg)")
for row in rows:
    frequency, peak, _, lag = map(float, row.split(","))
    peak, lag = np.degrees(peak), np.degrees(lag)
    of_phase = np.degrees(SIGMA / peak)
    amplitude = peak + SIGMA * rng.standard_normal()
    print(f"{frequency:.2f},{amplitude:.2f},{SIGMA},{lag + of_phase * rng.standard_normal():.2f},{of_phase:.2f}")

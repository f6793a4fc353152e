"""Make examples/period_table_synthetic.csv: periods of a pendulum that follows the exact law, with noise.

    python reference/synthetic_period_table.py > examples/period_table_synthetic.csv

T = T0 / AGM(1, cos(A/2)) with T0 = 2 s, forty amplitudes from 5 to 150 degrees on both sides; normal errors
of 0.01 rad on the amplitudes and 3 ms on the periods. Needs mpmath and NumPy; the seed is fixed.
"""

import mpmath
import numpy as np

T0 = 2.0
SIGMA_AMPLITUDE = 0.01
SIGMA_PERIOD = 0.003

rng = np.random.default_rng(1673)
amplitudes = np.radians(np.linspace(5, 150, 40)) * np.where(np.arange(40) % 2 == 0, 1, -1)
periods = [T0 / float(mpmath.agm(1, mpmath.cos(a / 2))) for a in amplitudes]

print("# Synthetic, not measured: the exact law with T0 = 2 s, and normal errors (sigma 0.01 rad and 3 ms).")
print("# Made by reference/synthetic_period_table.py.")
print("amplitude,period,sigma_amplitude,sigma_period")
for amplitude, period in zip(amplitudes, periods):
    a = amplitude + SIGMA_AMPLITUDE * rng.standard_normal()
    t = period + SIGMA_PERIOD * rng.standard_normal()
    print(f"{a:.4f},{t:.4f},{SIGMA_AMPLITUDE},{SIGMA_PERIOD}")

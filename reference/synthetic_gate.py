"""Make examples/gate_synthetic.csv: a photogate beside the centre of a damped pendulum.

    python reference/synthetic_gate.py > examples/gate_synthetic.csv

theta'' = -w0^2 sin(theta) - b theta' with w0 = 3.2 rad/s and b = 0.02 1/s, released from 0.9 rad. A bob of 25 mm on a
pendulum of 0.958 m (g = 9.81 m/s^2) blocks and frees a gate at 0.12 rad. Times have a jitter of 20 us; one passage is
missing and one edge is written twice. Needs SciPy; the seed is fixed.
"""

import numpy as np
from scipy.integrate import solve_ivp

OMEGA0, DAMPING, RELEASE, GATE = 3.2, 0.02, 0.9, 0.12
LENGTH = 9.81 / OMEGA0**2
HALF_WIDTH = 0.5 * 0.025 / LENGTH
JITTER = 2e-5

rng = np.random.default_rng(1656)


def motion(t, state):
    return [state[1], -OMEGA0**2 * np.sin(state[0]) - DAMPING * state[1]]


edges = [lambda t, state, edge=edge: state[0] - edge for edge in (GATE - HALF_WIDTH, GATE + HALF_WIDTH)]
solution = solve_ivp(motion, (0, 60), [RELEASE, 0], rtol=1e-11, atol=1e-12, events=edges)
rows = []
for upper, (times, states) in enumerate(zip(solution.t_events, solution.y_events)):
    for time, state in zip(times, states):
        # On the way down the upper edge comes first.
        rows.append([time + JITTER * rng.standard_normal(), int((state[1] < 0) == bool(upper))])
rows.sort()
del rows[36:38]
rows.append([rows[20][0] + 0.0004, rows[20][1]])
rows.sort()
print("# Synthetic, not measured: a pendulum of 0.958 m with a bob of 25 mm, released from 0.9 rad; g = 9.81 m/s^2.")
print("# Made by reference/synthetic_gate.py.")
print("Time (s),GateState")
for time, blocked in rows:
    print(f"{time:.6f},{blocked}")

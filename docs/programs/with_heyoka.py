"""A driven pendulum with heyoka, for `docs/heyoka.md`: states at eleven times, and when it turns. The page compares with what this prints:

python docs/programs/with_heyoka.py > docs/programs/with_heyoka.json
"""

import json

import heyoka as hy
import numpy as np

# beginning of the program
x, v = hy.make_vars("x", "v")
turns = []
motion = hy.taylor_adaptive(
    [(x, v), (v, hy.cos(2 / 3 * hy.time) / 2 - v / 10 - hy.sin(x))],
    [np.radians(120.0), 0.0],
    tol=1e-15,
    nt_events=[hy.nt_event(v, lambda motion, t, direction: turns.append(t))],
)
states = motion.propagate_grid(np.linspace(0.0, 50.0, 11))[5]
# end of the program

print(json.dumps({"heyoka": hy.__version__, "states": states.tolist(), "turns": turns}, indent=1))

"""heyoka's Taylor integrator, with LANES motions in a batch: `with_heyoka.py LANES`.

A system is compiled once for each tolerance; the time for that is the set-up."""
import sys

import heyoka as hy
import numpy as np
from serve import rates, serve, timed

hy.llvm_state.set_diskcache_enabled(False)
LANES = int(sys.argv[1])
COMPILED = {}


def compiled(case, tolerance, numbers):
    """The integrator, and the seconds that compiling it took."""
    if (case, tolerance) not in COMPILED:
        variables = hy.make_vars(*"abcd"[:numbers])
        formulas = rates(case, hy.sin, hy.cos)(hy.time, variables)
        kind = hy.taylor_adaptive if LANES == 1 else hy.taylor_adaptive_batch
        start = np.zeros(numbers if LANES == 1 else (numbers, LANES))
        COMPILED[case, tolerance] = timed(lambda: kind(list(zip(variables, formulas)), start, tol=tolerance))
    return COMPILED[case, tolerance]


def one_at_a_time(motion, starts, end):
    states, steps = [], 0
    for start in starts:
        motion.time, motion.state[:] = 0.0, start
        steps += motion.propagate_until(end)[3]
        states.append(motion.state.copy())
    return states, steps


def in_batches(motion, starts, end):
    """The last batch is filled with copies of its last motion, whose steps count."""
    states, steps = [], 0
    for i in range(0, len(starts), LANES):
        batch = starts[i : i + LANES]
        motion.set_time(0.0)
        motion.state[:] = np.transpose(batch + batch[-1:] * (LANES - len(batch)))
        motion.propagate_until(end)
        steps += sum(result[3] for result in motion.propagate_res)
        states += list(motion.state.T[: len(batch)].copy())
    return states, steps


def integrate(case, tolerance, end, starts):
    set_up, motion = compiled(case, tolerance, len(starts[0]))
    seconds, (states, steps) = timed(one_at_a_time if LANES == 1 else in_batches, motion, starts, end)
    return states, steps, seconds, set_up


serve(f"heyoka {hy.__version__}" + (f" in batches of {LANES}" if LANES > 1 else ""), integrate)

"""solve_ivp of SciPy, by the given method: `with_scipy.py DOP853` or `LSODA`."""
import sys

import scipy
from scipy.integrate import solve_ivp
from serve import rates, serve, timed

METHOD = sys.argv[1]


def integrate(case, tolerance, end, starts):
    f = rates(case)

    def all_motions():
        return [solve_ivp(f, (0, end), start, method=METHOD, rtol=tolerance, atol=tolerance) for start in starts]

    seconds, solutions = timed(all_motions)
    return [it.y[:, -1] for it in solutions], sum(len(it.t) - 1 for it in solutions), seconds, 0.0


serve(f"SciPy {scipy.__version__} solve_ivp {METHOD}", integrate)

"""Long motions of Fermi, Pasta and Ulam's chain of 32 masses: python reference/chains.py > crates/libration-testing/data/chains.csv

By heyoka's Taylor integrator in long double (64 bits), to two tolerances, which tell what it errs by. Needs: pip install heyoka mpmath, on
x86-64. Takes some ten minutes. With beta = 8 the chain is chaotic: what begins as a rounding in one mass has become a large number at the
last of the times, where no integration is compared.
"""
import numpy as np
import heyoka as hy
from mpmath import mp, pi, sin

mp.dps = 50
REAL = np.longdouble
MASSES = 32
# The frequency of the lowest mode is 0.09516…: 66, 660, 6600 and 66 000 of its radians, as whole numbers of the unit of time.
TIMES = [694, 6935, 69354, 693541]
TOLERANCES = ["1e-21", "1e-19"]
CASES = [("0.25", "0", 4), ("0", "8", 3)]
# Of the first mass, so that the motion is no longer even about the middle.
SHIFT = REAL("1e-12")

HEADER = """\
# Long motions of Fermi, Pasta and Ulam's chain of 32 masses, from its lowest mode. Source: reference/chains.py (heyoka, a Taylor
# integrator, in long double). Licence: MIT OR Apache-2.0. set: parameters; start: coordinates, then velocities, at t = 0, as hexadecimal
# f64; state: likewise, 21 digits; size: the largest number there; sensitivity: by what factor a change of the first number of the start
# grows until then; uncertainty: the largest difference of two runs, to 1e-21 and 1e-19.
set,start_hex,time,state,size,sensitivity,uncertainty"""


def chain(alpha, beta):
    places = [hy.expression(f"x{i}") for i in range(MASSES)]
    velocities = [hy.expression(f"v{i}") for i in range(MASSES)]
    lengths = [b - a for a, b in zip([None, *places], [*places, None]) if a is not None and b is not None]
    lengths = [places[0], *lengths, -places[-1]]
    forces = [d + d * d * (REAL(alpha) if beta == "0" else REAL(beta) * d) for d in lengths]
    accelerations = [b - a for a, b in zip(forces, forces[1:])]
    return list(zip(places, velocities)) + list(zip(velocities, accelerations))


def states(alpha, beta, start, count, tolerance):
    state = np.array([REAL(x) for x in start])
    integrator = hy.taylor_adaptive(chain(alpha, beta), state, tol=REAL(tolerance), fp_type=REAL, compact_mode=True)
    found = []
    for time in TIMES[:count]:
        integrator.propagate_until(REAL(time))
        found.append(integrator.state.copy())
    return found


def main():
    print(HEADER)
    mode = [float(sin(pi * i / (MASSES + 1))) for i in range(1, MASSES + 1)] + [0.0] * MASSES
    begin = " ".join(x.hex() for x in mode)
    for alpha, beta, count in CASES:
        best, other = (states(alpha, beta, mode, count, tolerance) for tolerance in TOLERANCES)
        shifted = states(alpha, beta, [REAL(mode[0]) + SHIFT, *mode[1:]], count, TOLERANCES[1])
        for time, state, rough, beside in zip(TIMES, best, other, shifted):
            numbers = " ".join(np.format_float_scientific(x, precision=20, unique=False) for x in state)
            size = max(abs(x) for x in state)
            growth = max(abs(a - b) for a, b in zip(beside, rough)) / SHIFT
            uncertainty = max(abs(a - b) for a, b in zip(state, rough))
            known = ",".join(f"{float(x):.3g}" for x in (size, growth, uncertainty))
            print(f'"alpha={alpha},beta={beta}",{begin},{time},{numbers},{known}', flush=True)


if __name__ == "__main__":
    main()

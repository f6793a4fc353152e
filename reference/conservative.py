"""Motions of named systems that keep their energy: python reference/conservative.py > crates/libration-testing/data/conservative.csv

As reference/first_order.py, by the extrapolated midpoint rule in 50 digits. Takes some ten minutes.
"""
from mpmath import mpf, nstr, pi, sin, sqrt

from first_order import SHIFT, motion

HEADER = """\
# Motions of named systems that keep their energy. Source: reference/conservative.py (extrapolated midpoint rule, 50 digits). Licence:
# MIT OR Apache-2.0. system: its key; set: values of parameters, those not given as the catalogue has them; decimals mean the f64 next to
# them. start: coordinates, then velocities, at t = 0, as hexadecimal f64. state: likewise, 30 digits. size: the largest number of the
# state until then. sensitivity: by what factor a change of one number of the start grows until then, the worst one of those tried.
system,set,start_hex,time,state,size,sensitivity"""


def henon_heiles(t, s):
    x, y, u, v = s
    return [u, v, -x - 2 * x * y, -y - x * x + y * y]


def kepler(t, s):
    x, y, u, v = s
    r = sqrt(x * x + y * y)
    return [u, v, -x / r**3, -y / r**3]


def chain(alpha, beta):
    alpha, beta = mpf(alpha), mpf(beta)

    def f(t, s):
        n = len(s) // 2
        places = [mpf(0), *s[:n], mpf(0)]
        forces = []
        for a, b in zip(places, places[1:]):
            d = b - a
            forces.append(d + d * d * (alpha + beta * d))
        return list(s[n:]) + [b - a for a, b in zip(forces, forces[1:])]

    return f


def mode(masses, amplitude):
    """The lowest mode at rest, in f64."""
    return [float(amplitude * sin(pi * i / (masses + 1))) for i in range(1, masses + 1)] + [0.0] * masses


CASES = [
    ("henon_heiles", "", henon_heiles, [0.0, 0.1, 0.35, 0.0], [1, 20, 100], "0.5", [0, 1, 2, 3]),
    ("henon_heiles", "", henon_heiles, [0.0, -0.15, 0.5555, 0.0], [20, 100], "0.5", [0, 1, 2, 3]),
    ("kepler", "", kepler, [0.5, 0.0, 0.0, 1.75], [1, 10, 100], "0.125", [0, 1, 2, 3]),
    ("fermi_pasta_ulam", "n=32,alpha=0.25,beta=0", chain("0.25", "0"), mode(32, 1), [20, 200], "0.5", [0, 15, 31]),
    ("fermi_pasta_ulam", "n=32,alpha=0,beta=8", chain("0", "8"), mode(32, 1), [20, 200], "0.5", [0, 15, 31]),
]


def main():
    print(HEADER)
    for key, values, f, start, times, step, tried in CASES:
        begin = [mpf(x) for x in start]
        found = motion(f, begin, times, step)
        moved = []
        for number in tried:
            shifted = list(begin)
            shifted[number] += SHIFT * SHIFT
            moved.append(motion(f, shifted, times, step))
        for place, (time, (state, size)) in enumerate(zip(times, found)):
            growth = max(max(abs(a - b) for a, b in zip(it[place][0], state)) for it in moved) / SHIFT / SHIFT
            numbers = " ".join(nstr(x, 30) for x in state)
            hexadecimal = " ".join(x.hex() for x in start)
            print(f'{key},"{values}",{hexadecimal},{time},{numbers},{nstr(size, 4)},{nstr(growth, 3)}', flush=True)


if __name__ == "__main__":
    main()

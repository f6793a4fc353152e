"""Motions of equations of the first order, alone and beside ones of the second: python reference/first_order.py > crates/libration-testing/data/first_order.csv

By extrapolation of the midpoint rule (extrapolation.py) in mpmath floats of 50 digits, each step refined until two columns agree to
1e-40. Needs: pip install mpmath. Takes some minutes.
"""
from mpmath import mp, mpf, nstr, sin, cos

from extrapolation import Extrapolation

mp.dps = 50
STEPS = Extrapolation(tolerance=mpf("1e-40"), columns=30)
SHIFT = mpf("1e-15")

HEADER = """\
# Motions of equations of the first order, alone and beside ones of the second. Source: reference/first_order.py (extrapolated midpoint
# rule, 50 digits). Licence: MIT OR Apache-2.0. equation: its decimals and those of start mean the f64 next to them. start: coordinates,
# then velocities of those of second order, at t = 0. state: likewise, 30 digits. size: the largest number of the state until then.
# sensitivity: by what factor a change of one number of the start, the worst one, grows until then.
equation,start,time,state,size,sensitivity"""


def motion(f, y, times, step):
    """The states at the times, and the largest number until each."""
    t, size, found = mpf(0), mpf(0), []
    for time in times:
        while t < time:
            length = min(mpf(step), time - t)
            y = STEPS.advance(f, t, y, length)
            t += length
            size = max(size, max(abs(x) for x in y))
        found.append((y, size))
    return found


def lorenz(t, s):
    x, y, z = s
    return [10 * (y - x), x * (28 - z) - y, x * y - 8 * z / 3]


def roessler(t, s):
    x, y, z = s
    return [-y - z, x + mpf(0.2) * y, mpf(0.2) + z * (x - mpf(5.7))]


def lotka_volterra(t, s):
    x, y = s
    return [x - x * y, x * y - y]


def thermostat(t, s):
    x, z, v = s
    return [v, v * v - 1, -x - z * v]


def motor(t, s):
    x, q, v = s
    return [v, cos(t) - mpf(0.5) * q - v, q - sin(x)]


def adler(t, s):
    return [mpf(1.5) - sin(s[0]) + mpf(0.25) * cos(t)]


CASES = [
    ("x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z", lorenz, "1 1 1", [1, 5, 10, 20], "0.125"),
    ("x' = -y - z; y' = x + 0.2*y; z' = 0.2 + z*(x - 5.7)", roessler, "1 1 1", [1, 10, 50], "0.25"),
    ("x' = x - x*y; y' = x*y - y", lotka_volterra, "0.25 0.25", [1, 10, 100], "0.25"),
    ("x'' = -x - z*x'; z' = x'^2 - 1", thermostat, "0.5 0.25 1.5", [1, 10, 50], "0.25"),
    ("x'' = q - sin(x); q' = cos(t) - 0.5*q - x'", motor, "0.5 0.25 0.75", [1, 10, 50], "0.25"),
    ("theta' = 1.5 - sin(theta) + 0.25*cos(t)", adler, "0.5", [1, 10, 100], "0.5"),
]


def rows(equation, f, start, times, step):
    begin = [mpf(float(word)) for word in start.split()]
    found = motion(f, begin, times, step)
    moved = []
    for number in range(len(begin)):
        shifted = list(begin)
        shifted[number] += SHIFT * SHIFT
        moved.append(motion(f, shifted, times, step))
    for place, (time, (state, size)) in enumerate(zip(times, found)):
        growth = max(
            max(abs(a - b) for a, b in zip(other[place][0], state)) / SHIFT / SHIFT for other in moved
        )
        numbers = " ".join(nstr(x, 30) for x in state)
        yield f'"{equation}",{start},{time},{numbers},{nstr(size, 4)},{nstr(growth, 3)}'


def main():
    print(HEADER)
    for case in CASES:
        for row in rows(*case):
            print(row, flush=True)


if __name__ == "__main__":
    main()

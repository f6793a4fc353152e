"""Motions of equations of the first order, alone and beside ones of the second: python reference/first_order.py > crates/libration/tests/data/first_order.csv

By extrapolation of the modified midpoint rule (W. B. Gragg, R. Bulirsch and J. Stoer; E. Hairer, S. P. Norsett and G. Wanner, Solving
Ordinary Differential Equations I, section II.9) in mpmath floats of 50 digits, each step refined until two columns agree to 1e-40.
Nothing here knows Taylor series. Needs: pip install mpmath. Takes some minutes.
"""
from mpmath import mp, mpf, nstr, sin, cos

mp.dps = 50
TOLERANCE = mpf("1e-40")
SHIFT = mpf("1e-15")
MOST_COLUMNS = 30

HEADER = """\
# Motions of equations of the first order, alone and beside ones of the second. Source: reference/first_order.py (extrapolated midpoint
# rule, 50 digits). Licence: MIT OR Apache-2.0. equation: its decimals and those of start mean the f64 next to them. start: coordinates,
# then velocities of those of second order, at t = 0. state: likewise, 30 digits. size: the largest number of the state until then.
# sensitivity: by what factor a change of one number of the start, the worst one, grows until then.
equation,start,time,state,size,sensitivity"""


def midpoint(f, t, y, length, substeps):
    h = length / substeps
    before, now = y, [a + h * b for a, b in zip(y, f(t, y))]
    for n in range(1, substeps):
        slope = f(t + n * h, now)
        before, now = now, [a + 2 * h * b for a, b in zip(before, slope)]
    slope = f(t + length, now)
    return [(a + b + h * c) / 2 for a, b, c in zip(before, now, slope)]


def extrapolated(f, t, y, length):
    """The state a step later, or None when it is too long."""
    rows = []
    for k in range(MOST_COLUMNS):
        row = [midpoint(f, t, y, length, 2 * k + 2)]
        for j in range(1, k + 1):
            factor = mpf(k + 1) ** 2 / mpf(k + 1 - j) ** 2 - 1
            row.append([a + (a - b) / factor for a, b in zip(row[-1], rows[-1][j - 1])])
        if rows and max(abs(a - b) for a, b in zip(row[-1], row[-2])) < TOLERANCE:
            return row[-1]
        rows.append(row)
    return None


def advance(f, t, y, length):
    after = extrapolated(f, t, y, length)
    if after is not None:
        return after
    half = length / 2
    return advance(f, t + half, advance(f, t, y, half), half)


def motion(f, y, times, step):
    """The states at the times, and the largest number until each."""
    t, size, found = mpf(0), mpf(0), []
    for time in times:
        while t < time:
            length = min(mpf(step), time - t)
            y = advance(f, t, y, length)
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

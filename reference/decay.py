"""Turning points of damped pendulums and the energy a cycle loses to damping, to 30 digits: decay.py TABLE, with TABLE
`turning_points` or `cycles`. Needs mpmath.

Turning points: theta'' + sum c theta'|theta'|^(n-1) + sin theta = 0, where the powers n are multiples of 1/2. Each swing goes up
with the velocity u^2 and the variable s of dt = u ds, in which d theta/ds = u^3, du/ds = -(sin theta + sum c u^(2n))/2, dt/ds = u is
analytic at the turning points, u = 0, too. Taylor series of order 30 in steps of a part of their radius, twice at
different precision and order, which must agree. Cycles: the hypergeometric function.
"""
import sys

from mpmath import beta, cos, hyp2f1, mp, mpf, nstr, sin

CASES = {
    "dry": ([(0, 0.05)], 1.0, 9),
    "linear": ([(1, 0.1)], 1.0, 10),
    "quadratic": ([(2, 0.1)], 1.0, 10),
    "cubic": ([(3, 0.1)], 1.0, 10),
    "all together": ([(0, 0.01), (1, 0.02), (2, 0.03), (3, 0.04)], 2.5, 12),
    "power 3/2": ([(1.5, 0.1)], 1.0, 8),
    "power 1/2": ([(0.5, 0.05)], 2.0, 8),
    "almost upright": ([(1, 0.01), (2, 0.001)], 3.1415, 6),
}


def product(a, b, n):
    return sum(a[j] * b[n - j] for j in range(n + 1))


def series(state, terms, order):
    """The coefficients of theta, u and t in powers of s."""
    theta, u, t = ([value] for value in state)
    sine, cosine = [sin(theta[0])], [cos(theta[0])]
    most = max(3, max(power for power, _ in terms))
    powers = [None] * (most + 1)
    powers[0], powers[1] = [mpf(1)] + [mpf(0)] * order, u
    for k in range(2, most + 1):
        powers[k] = []
    for n in range(order):
        for k in range(2, most + 1):
            powers[k].append(product(powers[k - 1], u, n))
        loss = sum(c * powers[power][n] for power, c in terms)
        theta.append(powers[3][n] / (n + 1))
        t.append(u[n] / (n + 1))
        u.append(-(sine[n] + loss) / (2 * (n + 1)))
        weighted = [j * theta[j] for j in range(n + 2)]
        sine.append(sum(weighted[j] * cosine[n + 1 - j] for j in range(1, n + 2)) / (n + 1))
        cosine.append(-sum(weighted[j] * sine[n + 1 - j] for j in range(1, n + 2)) / (n + 1))
    return theta, u, t


def value(coefficients, h):
    total = mpf(0)
    for c in reversed(coefficients):
        total = total * h + c
    return total


def swing(amplitude, terms, order):
    """Time and amplitude of the next turning point."""
    state = [-amplitude, mpf(0), mpf(0)]
    while True:
        all_series = series(state, terms, order)
        last = max(abs(c[-1]) ** (mpf(1) / order) for c in all_series)
        h = mpf(10) ** (-mpf(mp.dps) / order) / last
        after = [value(c, h) for c in all_series]
        if after[1] < 0:
            u = all_series[1]
            slope = [k * c for k, c in enumerate(u)][1:]
            h *= state[1] / (state[1] - after[1])
            for _ in range(12):
                h -= value(u, h) / value(slope, h)
            return value(all_series[2], h), value(all_series[0], h)
        state = after


def turning_points(terms, start, count, order):
    terms = [(int(2 * power), mpf(c)) for power, c in terms]
    time, amplitude = mpf(0), mpf(start)
    for _ in range(count):
        duration, amplitude = swing(amplitude, terms, order)
        time += duration
        yield time, amplitude


def print_turning_points():
    print("# Turning points of damped pendulums theta'' + sum c theta'|theta'|^(n-1) + sin theta = 0 released from rest. Source: computed by")
    print("# reference/decay.py with mpmath, two runs of different order and precision that agree. Licence: MIT OR Apache-2.0. damping: n:c n:c …,")
    print("# its decimals being the nearest f64 of each; start (rad): the nearest f64; number of the turning point, time, amplitude (rad).")
    print("damping,start,number,time,amplitude")
    for name, (terms, start, count) in CASES.items():
        runs = []
        for digits, order in ((36, 30), (44, 40)):
            mp.dps = digits
            runs.append(list(turning_points(terms, start, count, order)))
        text = " ".join(f"{power}:{c}" for power, c in terms)
        for number, (one, other) in enumerate(zip(*runs), 1):
            assert all(abs(a - b) < mpf(10) ** -29 for a, b in zip(one, other)), (name, number)
            print(f"{text},{start},{number},{nstr(other[0], 30)},{nstr(other[1], 30)}")


def print_cycles():
    print("# The energy (ml^2 omega0^2) that a cycle of the undamped pendulum would lose to the damping theta'|theta'|^(n-1), omega0 = 1:")
    print("# 2(2k)^(n+1) B(1/2, n/2 + 1) 2F1(1/2, 1/2; (n + 3)/2; k^2). Source: computed by reference/decay.py with mpmath. Licence: MIT OR")
    print("# Apache-2.0. exponent n and amplitude (rad): the nearest f64.")
    print("exponent,amplitude,loss")
    mp.dps = 50
    for n in (0, 0.25, 0.5, 1, 1.5, 1.83, 2, 2.5, 3, 4, 7.3):
        for amplitude in (1e-30, 1e-8, 1e-5, 1e-4, 0.01, 0.3, 1.0, 1.7, 2.5, 3.0, 3.14, 3.14159265):
            k = sin(mpf(amplitude) / 2)
            loss = 2 * (2 * k) ** (mpf(n) + 1) * beta(mpf(1) / 2, mpf(n) / 2 + 1) * hyp2f1(0.5, 0.5, (mpf(n) + 3) / 2, k * k)
            print(f"{n},{amplitude!r},{nstr(loss, 30)}")


if __name__ == "__main__":
    {"turning_points": print_turning_points, "cycles": print_cycles}[sys.argv[1]]()

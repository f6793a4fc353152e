"""tests/data/motion.csv: angle and velocity of many motions at many times, to 40 digits.

Closed forms evaluated with the AGM. Run: python reference/motion.py > crates/libration-testing/data/motion.csv
"""
import math
import random

from mpmath import atan, atan2, cos, cosh, floor, mp, mpf, nstr, pi, sin, sinh, sqrt

from elliptic import first, incomplete_first, jacobi

mp.dps = 700  # complements of 1e-300 and times of 1e6 periods leave 90 digits and more
HEADER = """\
# Motions of the pendulum, omega0 = 1, theta'' = -sin theta. Source: computed by reference/motion.py (mpmath, 700 digits, closed
# forms). Licence: MIT OR Apache-2.0. start_hex: initial angle (rad), or with `given` = complement, pi - angle (rad);
# velocity_hex, time_hex: initial velocity (rad/s), time (s), exactly these f64; angle (unwrapped, rad), velocity (rad/s),
# complement = pi - |angle in the turn| (rad); period: of a libration, turn time of a rotation (s), inf on the separatrix."""
UP, DOWN = 2 + 2.0**-30, 2 - 2.0**-30
STARTS = [  # (given, angle or complement, velocity)
    ("angle", 0.01, 0.0), ("angle", 1e-8, 0.0), ("angle", 1e-150, 0.0), ("angle", 0.5, 0.0), ("angle", math.pi / 2, 0.0), ("angle", 2.0, 0.0),
    ("angle", -2.0, 0.0), ("angle", 3.0, 0.0), ("angle", math.radians(179), 0.0), ("angle", math.pi, 0.0),
    ("angle", math.nextafter(math.pi, 0), 0.0), ("angle", 0.3, 0.7), ("angle", -1.0, 0.5), ("angle", 1.2, -0.4),
    ("angle", 0.0, 1.0), ("angle", 0.0, 1e-9), ("angle", 0.0, 2.0), ("angle", 0.0, DOWN), ("angle", 0.0, UP), ("angle", 0.0, 2.1),
    ("angle", 0.0, math.nextafter(2, 0)), ("angle", 0.0, math.nextafter(2, 3)), ("angle", 1.0, 2 * math.cos(0.5)),
    ("angle", 0.0, -3.0), ("angle", 1.0, 10.0), ("angle", math.pi, 0.1), ("angle", 7.0, 0.3), ("angle", 100.0, 0.0),
    ("angle", -50.0, -2.5), ("angle", 3.5, 0.0), ("angle", 3.0, -0.2), ("angle", 0.5, 1e3),
    ("complement", 1e-6, 0.0), ("complement", 1e-12, 0.0), ("complement", 1e-30, 0.0), ("complement", 1e-300, 0.0),
    ("complement", 1e-9, -1e-10), ("complement", 1e-20, 1e-20), ("complement", 1e-20, -1e-20), ("complement", 0.25, 0.01),
]  # fmt: skip


class Motion:
    """A motion prepared from exact initial data; states by `at`."""

    def __init__(self, given, start, velocity):
        start, velocity = mpf(start), mpf(velocity)
        turns = floor(start / (2 * pi) + mpf(1) / 2) if given == "angle" else 0
        angle = start - 2 * pi * turns if given == "angle" else pi - start
        self.sign = -1 if velocity < 0 else 1  # mirrored so that the velocity is never negative
        self.base, angle, self.w = 2 * pi * turns, self.sign * angle, abs(velocity) / 2
        if given == "angle":
            s, c = sin(angle / 2), cos(angle / 2)
        else:
            s, c = self.sign * cos(start / 2), sin(start / 2)
        self.excess = (self.w - c) * (self.w + c)  # E/(2mgl) - 1
        self.energy = self.w**2 + s**2
        self.prepare(angle, s, c)

    def prepare(self, angle, s, c):
        if self.excess < 0:
            self.k, self.kc = sqrt(self.energy), sqrt(-self.excess)
            self.quarter = first(self.k, self.kc)
            self.rate, self.period = mpf(1), 4 * self.quarter
            self.start = incomplete_first(atan2(s, self.w), self.k, self.kc) if self.energy else mpf(0)
        elif self.excess == 0:
            self.rate, self.period, self.start = mpf(1), mpf("inf"), 2 * mp.atanh(mp.tan(angle / 4))
        else:
            self.rate = sqrt(self.energy)
            self.k, self.kc = 1 / self.rate, sqrt(self.excess) / self.rate
            self.quarter = first(self.k, self.kc)
            self.period = 2 * self.quarter / self.rate
            self.start = incomplete_first(angle / 2, self.k, self.kc)

    def at(self, time):
        """(angle, velocity, complement)."""
        u = self.rate * mpf(time) + self.start
        if self.excess < 0:
            sn, cn, dn, _ = jacobi(u, self.k, self.kc)
            half, velocity = atan2(self.k * sn, dn), 2 * self.k * cn
        elif self.excess == 0:
            half, velocity = atan(sinh(u)), 2 / cosh(u)
        else:
            _, _, dn, half = jacobi(u, self.k, self.kc)
            velocity = 2 * self.rate * dn
        turn = floor(half / pi + mpf(1) / 2)
        complement = pi - 2 * abs(half - pi * turn)
        return self.base + 2 * self.sign * half, self.sign * velocity, complement


def times(motion, seed):
    """Zero, plain times, times near turning points and passages, and up to 1e6 periods; some negative."""
    random.seed(seed)
    period = float(motion.period) if motion.excess else 20.0
    chosen = [0.0, 0.1, 1.0, 1e-9, -0.7, period / 4, period / 2, -3 * period, period * 0.1234]
    chosen += [period * 10 ** random.uniform(0, 6) for _ in range(5)] if motion.excess else [5.0, 50.0, 300.0, -40.0]
    if not motion.excess:  # where sech and complement become plain exponentials, and then underflow
        chosen += [math.nextafter(600, 0), 600.0, math.nextafter(600, 700), -650.0, 700.0, 708.5, -720.0, 740.0, 745.0, 760.0]
    return chosen


if __name__ == "__main__":
    print(HEADER)
    print("given,start_hex,velocity_hex,time_hex,angle,velocity,complement,period")
    for seed, (given, start, velocity) in enumerate(STARTS):
        motion = Motion(given, start, velocity)
        for time in times(motion, seed):
            cells = [given] + [float(x).hex() for x in (start, velocity, time)]
            print(",".join(cells + [nstr(x, 40).lstrip("+") for x in (*motion.at(time), motion.period)]))

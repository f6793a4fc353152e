"""Motions of the named systems in time: python reference/damped.py > crates/libration-testing/data/damped.csv

By extrapolation of the midpoint rule (extrapolation.py) in gmpy2 floats of 400 bits, each step refined until two columns agree
to 1e-60. Where damping is not analytic, at turning points, the step ends: the
zero of the velocity is found by Newton's method on the length of the step. Needs: pip install gmpy2. Takes some minutes.
"""
import sys
from fractions import Fraction

import gmpy2
from gmpy2 import cos, mpfr, sin

from extrapolation import Extrapolation

gmpy2.get_context().precision = 400
STEPS = Extrapolation(tolerance=mpfr("1e-60"), columns=40)


def number(text):
    """The f64 next to a decimal or a fraction, which is what the library takes."""
    return mpfr(float(Fraction(text)))


class Motion:
    """A motion step by step. A force may have branches by the sign of the first velocity."""

    def __init__(self, force, start, friction=None, longest="0.4"):
        self.force, self.t, self.y = force, mpfr(0), list(start)
        self.friction, self.longest = friction, mpfr(longest)
        self.n = len(start) // 2
        self.turning = []
        self.stuck = False
        self.sign = self.next_sign()

    def f(self, t, y):
        return y[self.n :] + self.force(t, y[: self.n], y[self.n :], self.sign)

    def next_sign(self):
        v = self.y[self.n]
        if v != 0:
            return 1 if v > 0 else -1
        self.sign = 0
        pull = self.force(self.t, self.y[: self.n], self.y[self.n :], 0)[0]
        if self.friction is not None and abs(pull) <= self.friction:
            self.stuck = True
        return 1 if pull > 0 else -1

    def go(self, to):
        while self.t < to and not self.stuck:
            length = min(self.longest, to - self.t)
            after = STEPS.advance(self.f, self.t, self.y, length)
            v = after[self.n]
            if v * self.sign < 0 or (v == 0 and length < self.longest):
                length, after = self.turn(length, after)
                self.t, self.y = self.t + length, after
                self.y[self.n] = mpfr(0)
                self.turning.append((self.t, list(self.y)))
                self.sign = self.next_sign()
            else:
                self.t, self.y = self.t + length, after
        return self.y

    def turn(self, length, after):
        """The step at whose end the first velocity vanishes."""
        low, high = mpfr(0), length
        for _ in range(200):
            slope = self.f(self.t + length, after)[self.n]
            change = after[self.n] / slope
            if after[self.n] * self.sign > 0:
                low = length
            else:
                high = length
            if abs(change) < mpfr("1e-58"):
                return length, after
            length = length - change if low < length - change < high else (low + high) / 2
            after = STEPS.advance(self.f, self.t, self.y, length)
        raise ArithmeticError("no turning point")


def damped(terms):
    """theta'' = -sin(theta) - sum c theta' |theta'|^(n-1) for (c, n) in terms, on the branch of the sign."""

    def force(t, q, v, sign):
        return [-sin(q[0]) - sum(c * v[0] ** n * (sign if n % 2 == 0 else 1) for c, n in terms)]

    return force


def literal(c, n):
    return lambda t, q, v, sign: [-sin(q[0]) - c * v[0] ** n]


def driven(c, a, omega):
    return lambda t, q, v, sign: [-sin(q[0]) - c * v[0] + a * cos(omega * t)]


def pivot_up(c, a, omega):
    return lambda t, q, v, sign: [-(1 - a * omega**2 * cos(omega * t)) * sin(q[0]) - c * v[0]]


def pivot_across(c, a, omega):
    return lambda t, q, v, sign: [-sin(q[0]) + a * omega**2 * cos(omega * t) * cos(q[0]) - c * v[0]]


def spring(kappa, l=mpfr(1), g=mpfr(1)):
    def force(t, q, v, sign):
        r, theta = q
        return [r * v[1] ** 2 + g * cos(theta) - kappa * (r - l), -(2 * v[0] * v[1] + g * sin(theta)) / r]

    return force


def double(m1, m2, l1, l2, g=mpfr(1)):
    """Accelerations by solving the two equations of Lagrange as a linear system."""

    def force(t, q, v, sign):
        c, s = cos(q[0] - q[1]), sin(q[0] - q[1])
        a11, a12, a22 = (m1 + m2) * l1**2, m2 * l1 * l2 * c, m2 * l2**2
        b1 = -m2 * l1 * l2 * v[1] ** 2 * s - (m1 + m2) * g * l1 * sin(q[0])
        b2 = m2 * l1 * l2 * v[0] ** 2 * s - m2 * g * l2 * sin(q[1])
        d = a11 * a22 - a12**2
        return [(a22 * b1 - a12 * b2) / d, (a11 * b2 - a12 * b1) / d]

    return force


def spherical(t, q, v, sign):
    theta, phi = q
    return [sin(theta) * (v[1] ** 2 * cos(theta) - 1), -2 * v[0] * v[1] * cos(theta) / sin(theta)]


def coupled(kappa):
    return lambda t, q, v, sign: [
        -sin(q[0]) - kappa * (q[0] - q[1]),
        -sin(q[1]) - kappa * (q[1] - q[0]),
    ]


N = number
D = ("0.5", "1", "3", "7.5", "15", "30")
HALF_PI = "1.5707963267948966"
# key, values, force, start (coordinates, velocities), times, what the motion needs
CASES = [
    ("damped_pendulum", "c=0.1", damped([(N("0.1"), 1)]), "1 0", D, {}),
    ("damped_pendulum", "c=0.05", damped([(N("0.05"), 1)]), "0 3", D, {}),
    ("damped_pendulum", "c=0.1,n=2", damped([(N("0.1"), 2)]), "1 0", D, {}),
    ("damped_pendulum", "c=0.1,n=3", damped([(N("0.1"), 3)]), "1 0", D, {}),
    ("damped_pendulum", "c=0.05,n=0", damped([(N("0.05"), 0)]), "1 0", D + ("40",), {"friction": N("0.05")}),
    (
        "damped_pendulum",
        "c0=0.02,c1=0.03,c2=0.1",
        damped([(N("0.02"), 0), (N("0.03"), 1), (N("0.1"), 2)]),
        "2 0.5",
        D,
        {"friction": N("0.02")},
    ),
    ("damped_pendulum_54", "c=0.25,n=2", literal(N("0.25"), 2), "1 0", D, {}),
    ("driven_pendulum", "c=1/2,A=0.5,omega=2/3", driven(N("1/2"), N("0.5"), N("2/3")), "0.2 0", ("1", "5", "10", "20", "40"), {}),
    ("vertically_driven_pendulum", "a=0.1,omega=20", pivot_up(mpfr(0), N("0.1"), N("20")), "3 0", ("1", "5", "10"), {"longest": "0.1"}),
    ("horizontally_driven_pendulum", "a=0.3,omega=1.5,c=0.1", pivot_across(N("0.1"), N("0.3"), N("1.5")), "0.5 0", ("1", "5", "10", "20"), {}),
    ("spring_pendulum", "kappa=10", spring(N("10")), "1.1 0.5 0 0", ("1", "5", "10", "20"), {}),
    ("spring_pendulum", "kappa=3", spring(N("3")), "1.5 0.1 0 0", ("1", "5", "10", "20"), {}),
    ("spring_pendulum", "kappa=20", spring(N("20")), "1 2 0 0", ("1", "5", "10"), {"longest": "0.2"}),
    ("double_pendulum", "", double(*[mpfr(1)] * 4), "0.01 0.02 0 0", ("1", "5", "10", "30"), {}),
    ("double_pendulum", "", double(*[mpfr(1)] * 4), f"{HALF_PI} {HALF_PI} 0 0", ("1", "2", "5", "10"), {"longest": "0.2"}),
    ("double_pendulum", "m1=3,m2=0.5,l2=0.7", double(mpfr(3), N("0.5"), mpfr(1), N("0.7")), "2 -1 0 1", ("1", "2", "5"), {"longest": "0.1"}),
    ("double_pendulum", "m2=2,l1=0.5", double(mpfr(1), mpfr(2), N("0.5"), mpfr(1)), "0.5 0.5 0 0", ("1", "5", "10"), {"longest": "0.2"}),
    ("spherical_pendulum", "", spherical, "1 0 0 0.5", ("1", "5", "10", "20"), {"longest": "0.2"}),
    ("coupled_pendulums", "kappa=0.1", coupled(N("0.1")), "1 0 0 0", ("1", "10", "30"), {}),
]
NUDGE = mpfr(2) ** -120


def digits(values):
    return " ".join(f"{value:.40g}" for value in values)


def motion(case, start):
    return Motion(case[2], start, **case[5])


def with_sensitivity(case, start, times):
    """The states, and how much more than their causes they change when a number of the start does."""
    plain = motion(case, start)
    states = [list(plain.go(mpfr(t))) for t in times]
    largest = [mpfr(0)] * len(times)
    for place in range(len(start)):
        nudged = list(start)
        nudged[place] += NUDGE
        other = motion(case, nudged)
        for i, t in enumerate(times):
            change = max(abs(a - b) for a, b in zip(other.go(mpfr(t)), states[i])) / NUDGE
            largest[i] = max(largest[i], change)
    return plain, states, largest


def attractor(case):
    """The state at drive phase zero that all motions nearby come to; closes to 1e-40."""
    period = 2 * gmpy2.const_pi() / N("2/3")
    one = motion(case, [mpfr("0.7"), mpfr("0.3")])
    last = None
    for n in range(1, 200):
        state = list(one.go(n * period))
        turns = gmpy2.rint(state[0] / (2 * gmpy2.const_pi()))
        state[0] -= 2 * gmpy2.const_pi() * turns
        if last and max(abs(a - b) for a, b in zip(state, last)) < mpfr("1e-42"):
            return state
        last = state
    raise ArithmeticError("no attractor")


print(
    """# Motions of the named systems. Source: reference/damped.py (extrapolated midpoint rule, 400 bits). The damped pendulums of one term, (54),
# the first two spring pendulums and the first two double pendulums were computed a second time by Taylor series in 320 bits:
# equal to 38 digits and more. Licence: MIT OR Apache-2.0. system: its key; set: values of parameters, those not given as the
# catalogue has them (omega0, g, l and masses 1); fractions and decimals of set and start mean the f64 next to them. start:
# coordinates, then velocities, at t = 0. kind: sample; turning (the first velocity vanishes at this time); attractor (every motion
# nearby has this state at whole drive periods, the angle in the turn). time in seconds. state: coordinates, then velocities, 40
# digits. sensitivity: by what factor a change of one number of the start, the worst one, grows until then; empty where it does
# not apply.
system,set,start,kind,time,state,sensitivity"""
)
for case in CASES:
    key, values, _, start, times, _ = case
    print(key, values, start, file=sys.stderr, flush=True)
    numbers = [number(text) for text in start.split()]
    one, states, sensitivities = with_sensitivity(case, numbers, times)
    for t, state, sensitivity in zip(times, states, sensitivities):
        print(f'{key},"{values}",{start},sample,{t},{digits(state)},{float(sensitivity):.3g}')
    for t, state in one.turning if len(numbers) == 2 else []:
        print(f'{key},"{values}",{start},turning,{t:.40g},{digits(state)},')
    if key == "driven_pendulum":
        print(f'{key},"{values}",{start},attractor,0,{digits(attractor(case))},')
    sys.stdout.flush()

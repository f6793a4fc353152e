"""Periods of oscillators from small amplitudes to 1e-12 from the separatrix, on both sides of it, to 30 digits. Needs mpmath.

    python reference/periods_near_separatrix.py > crates/libration-testing/data/periods_near_separatrix.csv

The energy integral: with the turning points a and b of V and x = (a + b)/2 + (a - b)/2*cos(p) the period is the integral of
sqrt(2/Q) over p from 0 to pi, Q = (V(a) - V(x))/((a - x)(x - b)). By Gauss's rule on panels that shrink by half towards the turning
points and towards the equilibria on the way, in 120 digits and on twice as many panels, which must agree. Where a closed form by
the arithmetic-geometric mean is known it must agree as well. Harmonics of duffing_soft and the pendulum by their nomes.
"""
from decimal import Decimal

from mpmath import acos, agm, cos, cosh, exp, mp, mpf, nstr, pi, sin, sqrt
from mpmath.calculus.quadrature import GaussLegendre

mp.dps = 120
ROOT = sqrt(mpf(2)) - 1


def exactly(value):
    """The decimal expansion of an f64."""
    return format(Decimal(value), "f")


def written(value):
    return nstr(value, 60, strip_zeros=False)


# V, the place of rest, the other equilibria, amplitudes.
OSCILLATORS = {
    "duffing": (lambda x: x**2 / 2 + x**4 / 4, 0, [], ["0.01", "0.5", "1", "100"]),
    "duffing_soft": (
        lambda x: x**2 / 2 - x**4 / 4, 0, [],
        ["0.1", "0.5", "0.9", "0.99", "0.999", "0.99999", "0.9999999", "0.999999999", exactly(0.999999999),
         exactly(0.99999), "0.999999999999", "1"]),
    "quadratic": (
        lambda x: x**2 / 2 + x**3 / 3, 0, [-1],
        ["0.05", "0.1", "0.4", "0.49", "0.4999", "0.49999999", "0.499999999999", exactly(0.499999999999), "0.5"]),
    "pendulum": (
        lambda x: 2 * sin(x / 2)**2, 0, [],
        ["0.5", "2", "3", "pi-1e-3", "pi-1e-6", "pi-1e-12", exactly(3.14159), "180deg"]),
    "rotating_hoop": (
        lambda x: 1 - cos(x) - sin(x)**2 / 4, 0, [],
        ["0.5", "2", "3", "pi-1e-3", "pi-1e-6", "pi-1e-9", "pi-1e-12", "180deg"]),
    "double_well": (
        lambda x: -x**2 / 2 + x**4 / 4, 1, [-1, 0],
        ["0.1", "0.3", "0.4", "0.41", "0.42", "0.5", "1.5", exactly(0.41421356237309503), exactly(0.41421356237309509)]
        + [written(ROOT + sign * mpf(10)**-n) for n in (3, 6, 9, 12) for sign in (-1, 1)]),
    "sinh": (lambda x: cosh(x) - 1, 0, [], ["1", "5"]),
    "x_over_sqrt": (lambda x: sqrt(1 + x**2) - 1, 0, [], ["1", "10"]),
    "cubic_quintic": (lambda x: x**2 / 2 + x**4 / 4 + x**6 / 6, 0, [], ["0.5", "10"]),
    # Released on the steep side, where the other turning point is far out on the flat one.
    "toda": (lambda x: exp(x) - x - 1, 0, [], ["0.5", "5"]),
}


def number(text):
    if text.startswith("pi-"):
        return pi - mpf(text[3:])
    if text.endswith("deg"):
        return pi * mpf(text[:-3]) / 180
    return mpf(text)


def bisected(v, energy, inside, outside):
    for _ in range(400):
        middle = (inside + outside) / 2
        if v(middle) < energy:
            inside = middle
        else:
            outside = middle
    return (inside + outside) / 2


def turning_point(v, energy, centre, start, wells):
    step = (start - centre) / 512
    inside = centre
    marks = sorted([mpf(place) for place in wells if place < centre], reverse=True)
    outside = centre - step
    while True:
        between = [mark for mark in marks if outside < mark < inside and v(mark) >= energy]
        if between:
            return bisected(v, energy, inside, between[0])
        if v(outside) >= energy:
            return bisected(v, energy, inside, outside)
        inside, outside = outside, outside - step


def panels(points):
    """Ends of panels that shrink by half towards each point."""
    ends = set()
    for left, right in zip(points, points[1:]):
        middle = (left + right) / 2
        half = middle - left
        for n in range(60):
            ends |= {left + half / 2**n, right - half / 2**n}
        ends |= {left, right}
    return sorted(ends)


def period(v, centre, others, start):
    energy = v(start)
    b = turning_point(v, energy, mpf(centre), start, others)
    middle, half = (start + b) / 2, (start - b) / 2

    def integrand(p):
        # 1 - cos p and 1 + cos p without cancellation.
        above, below = 2 * half * sin(p / 2)**2, 2 * half * sin((pi - p) / 2)**2
        x = start - above
        return sqrt(2 * above * below / (energy - v(x)))

    on_the_way = [acos((place - middle) / half) for place in sorted(others + [centre], reverse=True) if b < place < start]
    points = [mpf(0)] + on_the_way + [mpf(pi)]
    ends = panels(points)
    twice = sorted(ends + [(a + b) / 2 for a, b in zip(ends, ends[1:])])
    values = [gauss(integrand, grid) for grid in (ends, twice)]
    assert abs(values[0] / values[1] - 1) < mpf(10)**-32, (start, values)
    return values[1]


NODES = GaussLegendre(mp).calc_nodes(5, int(mp.prec))


def gauss(f, ends):
    total = mpf(0)
    for a, b in zip(ends, ends[1:]):
        total += (b - a) / 2 * sum(w * f((a + b) / 2 + (b - a) / 2 * x) for x, w in NODES)
    return total


def closed_form(key, a):
    if key == "duffing":
        return 2 * pi / agm(sqrt(1 + a**2), sqrt(1 + a**2 / 2))
    if key == "duffing_soft":
        # omega^2 = 1 - a^2/2 and m = a^2/(2 - a^2): T = 4 K/omega.
        return 2 * pi / agm(sqrt(1 - a**2 / 2), sqrt(1 - a**2))
    if key == "pendulum":
        return 2 * pi / agm(1, cos(a / 2))
    if key == "quadratic":
        p = 3 + 2 * a
        root = sqrt(p * (p - 8 * a))
        b, c = (root - p) / 4, (-root - p) / 4
        return sqrt(mpf(6)) * pi / agm(sqrt(a - c), sqrt(b - c))
    return None


def harmonic(key, a, n):
    """The coefficient of cos n*Omega*t, from the Fourier series of cd and of the pendulum."""
    if key == "duffing_soft":
        k, other = sqrt(a**2 / (2 - a**2)), sqrt((2 - 2 * a**2) / (2 - a**2))
        first, second = pi / 2 / agm(1, other), pi / 2 / agm(1, k)
        q = exp(-pi * second / first)
        j = (n - 1) // 2
        return a * 2 * pi / (k * first) * (-1)**j * q**(j + mpf(1) / 2) / (1 - q**n)
    if key == "pendulum":
        k, other = sin(a / 2), cos(a / 2)
        first, second = pi / 2 / agm(1, other), pi / 2 / agm(1, k)
        sign = (-1)**((n - 1) // 2)
        return sign * mpf(4) / n / cosh(n * pi * second / first / 2)
    return None


def shown(value):
    return "" if value is None else nstr(value, 32)


def main():
    print("# Periods of the catalogue's oscillators (default parameters) by the amplitude, the largest displacement from the")
    print("# equilibrium, which is exactly the decimal, pi less the decimal, or the degrees; inf on the separatrix. a1, a3: harmonics.")
    print("# Made by reference/periods_near_separatrix.py with mpmath, energy integrals in 120 digits; licence as the project's.")
    print("key,amplitude,period,a1,a3")
    separatrix = {("duffing_soft", "1"), ("quadratic", "0.5"), ("pendulum", "180deg"), ("rotating_hoop", "180deg")}
    for key, (v, centre, others, amplitudes) in OSCILLATORS.items():
        for text in amplitudes:
            if (key, text) in separatrix:
                print(f"{key},{text},inf,,")
                continue
            a = number(text)
            value = period(v, centre, others, centre + a)
            known = closed_form(key, a)
            assert known is None or abs(value / known - 1) < mpf(10)**-30, (key, text, value, known)
            print(f"{key},{text},{shown(value)},{shown(harmonic(key, a, 1))},{shown(harmonic(key, a, 3))}", flush=True)


main()

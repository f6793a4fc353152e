"""The cases of series.py on FLINT through python-flint: rational polynomials with one common denominator.

x_n, what stands before eps^n, is c p_n(c^2) with c = cos(tau), so that parity is never stored and the equation for x_n is
triangular: c^k'' = k (k-1) c^(k-2) - k^2 c^k. Gauge: eps is the coefficient of cos(tau).
"""
from math import comb, factorial

import flint
from flint import ctx, fmpq, fmpq_mat, fmpq_poly, fmpq_series

VERSION = f"python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
ZERO, ONE, U = fmpq_poly([]), fmpq_poly([1]), fmpq_poly([0, 1])


def total(terms):
    return sum(terms, ZERO)


def second(p):
    """d^2/dtau^2 of c p(c^2)."""
    slope = p.derivative()
    return 4 * U * (1 - U) * slope.derivative() + (6 - 8 * U) * slope - p


def twice(p, odd):
    """D^2 of c p(c^2), or of s p(c^2); D = -i d/dtau, s = i sin(tau)."""
    if not odd:
        return -second(p)
    slope = p.derivative()
    return 4 * U * (U - 1) * slope.derivative() + (8 * U - 2) * slope + p


def triangular(rest, size, odd):
    """Coefficients p_1, ... with (c p)'' + c p = -c rest (odd) or (s p)'' + s p = -s rest, and p_0 = 0 for now."""
    found = [fmpq(0)] * (size + 2)
    for i in range(size, 0, -1):
        k = 2 * i + odd
        found[i] = ((k + 2) * (k + 1) * found[i + 1] + rest[i]) / (k * k - 1 if odd else k * k + 2 * k)
    return found


def without_cosine(found):
    """c p with the p_0 that leaves no cos(tau)."""
    found[0] = -sum((a * comb(2 * i + 1, i) / 4**i for i, a in enumerate(found)), fmpq(0))
    return fmpq_poly(found)


def without_sine(found):
    """s p with the p_0 that leaves no sin(tau)."""
    found[0] = -sum((a * comb(2 * i, i) / ((i + 1) * 4**i) for i, a in enumerate(found)), fmpq(0))
    return fmpq_poly(found)


class Lindstedt:
    """The part of the recurrence that is independent of the force. `square` is Omega^2, all dictionaries by the power of eps."""

    def __init__(self):
        self.x, self.second, self.square = {1: ONE}, {1: -ONE}, {0: fmpq(1)}

    def step(self, n, force):
        """Finds x_n and the square of the frequency before eps^(n-1) from the force at order n without its term x_n."""
        rest = force + total(self.square[n - j] * self.second[j] for j in range(3, n, 2))
        found = triangular(rest, n // 2, 1)
        self.square[n - 1] = rest[0] + 6 * found[1]
        self.x[n] = without_cosine(found)
        self.second[n] = second(self.x[n])


def pendulum(order):
    """sin and cos of the series by n S_n = sum j x_j C_(n-j), n C_n = - sum j x_j S_(n-j)."""
    found = Lindstedt()
    slope, sine, cosine = {1: ONE}, {1: ONE}, {0: ONE}
    for n in range(3, order + 1, 2):
        cosine[n - 1] = -U * total(slope[j] * sine[n - 1 - j] for j in range(1, n - 1, 2)) / (n - 1)
        force = total(slope[j] * cosine[n - j] for j in range(1, n, 2)) / n
        found.step(n, force)
        slope[n], sine[n] = n * found.x[n], force + found.x[n]
    return found


def duffing(order):
    """x + x^3 by the series of x^2 and of x^2 x."""
    found = Lindstedt()
    x, squares = found.x, {2: ONE}
    for n in range(3, order + 1, 2):
        found.step(n, U * total(x[j] * squares[n - j] for j in range(1, n - 1, 2)))
        half = (n + 1) // 2
        squares[n + 1] = 2 * total(x[j] * x[n + 1 - j] for j in range(1, half, 2))
        if half % 2:
            squares[n + 1] += x[half] * x[half]
    return found


def frequency(found, order):
    """All coefficients of Omega in powers of eps^2."""
    ctx.cap = order // 2 + 1
    return fmpq_series([found.square[n] for n in range(0, order, 2)]).sqrt()


def harmonics(found, order):
    """Row k: the coefficients of cos((2k+1) tau) by powers of eps."""
    size = (order + 1) // 2
    powers = fmpq_mat([[found.x[2 * n + 1][i] for n in range(size)] for i in range(size)])
    binomials = [[comb(2 * i + 1, i - k) / fmpq(4) ** i if k <= i else 0 for i in range(size)] for k in range(size)]
    return fmpq_mat(binomials) * powers


def solve(oscillator, order):
    """The content of the command's `frequency_ratio` and `harmonics`; the check is the last frequency and the last a_3."""
    order -= 1 - order % 2
    found = oscillator(order)
    omega, table = frequency(found, order), harmonics(found, order)
    return omega, table, (omega[order // 2], table[1, order // 2])


def full(oscillator, order):
    """`of_amplitude` too: eps, Omega, T and all harmonics as series in the amplitude."""
    order -= 1 - order % 2
    omega, table, _ = solve(oscillator, order)
    size = (order + 1) // 2
    ctx.cap = order + 1
    amplitude = [0] * (order + 1)
    for n in range(size):
        amplitude[2 * n + 1] = sum(table[k, n] for k in range(size))
    eps = fmpq_series(amplitude).reversion()
    ctx.cap = size
    ratio = fmpq_series([eps[2 * n + 1] for n in range(size)])
    square = ratio * ratio * fmpq_series([0, 1])
    powers = [fmpq_series([1])]
    while len(powers) < size:
        powers.append(powers[-1] * square)
    in_amplitude = table * matrix([ratio * power for power in powers])
    omega = (fmpq_mat([[omega[n] for n in range(size)]]) * matrix(powers)).entries()
    period = 1 / fmpq_series(omega)
    return eps, omega, period, in_amplitude, (omega[size - 1], in_amplitude[1, size - 1])


def matrix(rows):
    return fmpq_mat([[row[n] for n in range(len(rows))] for row in rows])


class LimitCycle:
    """Van der Pol with mu = i nu: - W D^2 x + x = - nu Omega D(x - x^3/3), D = -i d/dtau, all rational.

    x_n is c p(c^2) for even n and s p(c^2) with s = i sin(tau) for odd n; D c = s, D s = c, s^2 = c^2 - 1. `pairs` is
    x^2 (divided by c s for odd n), `bend` is D(x - x^3/3), all by the power of nu.
    """

    def __init__(self):
        self.omega, self.square = {0: fmpq(1)}, {0: fmpq(1)}
        self.x, self.pairs, self.bend = {}, {}, {}
        self.keep(0, fmpq_poly([2]))

    def keep(self, n, x):
        self.x[n] = x
        p, g = self.x, self.pairs
        if n % 2:
            g[n] = 2 * alternate(p, p, n, 0)
            cube = alternate(p, g, n, 1) + U * alternate(p, g, n, 0)
        else:
            g[n] = U * mirrored(p, n, 0) + (U - 1) * mirrored(p, n, 1)
            cube = alternate(p, g, n, 0) + (U - 1) * alternate(p, g, n, 1)
        smooth = x - cube / 3
        self.bend[n] = smooth + 2 * (U - n % 2) * smooth.derivative()

    def step(self, n):
        rest = total(self.square[j] * twice(self.x[n - j], n % 2) for j in range(2, n, 2))
        rest -= total(self.omega[j] * self.bend[n - 1 - j] for j in range(0, n, 2))
        found = triangular(-rest, n, 1 - n % 2)
        if n % 2:
            self.set_fundamental(n, found, rest[0])
            self.keep(n, without_sine(found))
        else:
            self.square[n] = 3 * found[1] - rest[0] / 2
            self.omega[n] = (self.square[n] - sum(self.omega[j] * self.omega[n - j] for j in range(2, n, 2))) / 2
            self.keep(n, without_cosine(found))

    def set_fundamental(self, n, found, first):
        """The balance of sin(tau) at order n fixes the coefficient of cos(tau) in x_(n-1)."""
        if n > 1:
            amount = found[1] - first / 2
            self.x[n - 1] += amount
            self.pairs[n - 1] += 4 * amount * U
            self.bend[n - 1] += amount * (1 - 12 * U)
            found[1] -= 3 * amount / 2


def alternate(a, b, n, first):
    """The sum of a_j b_(n-j) over j of one parity."""
    return total(a[j] * b[n - j] for j in range(first, n + 1, 2))


def mirrored(p, n, first):
    """The same sum for p and p, with each pair once."""
    middle = p[n // 2] * p[n // 2] if n % 4 == 2 * first else ZERO
    return 2 * total(p[j] * p[n - j] for j in range(first, (n + 1) // 2, 2)) + middle


def van_der_pol(order):
    """Omega to mu^order; the check is its last coefficient and the last amplitude of cos(tau) found with it."""
    found = LimitCycle()
    for n in range(1, order + 1):
        found.step(n)
    amplitude = sum(a * comb(2 * i + 1, i) / 4**i for i, a in enumerate(found.x[order - 2].coeffs()))
    sign = (-1) ** (order // 2)
    return found, (sign * found.omega[order], -sign * amplitude)


def period_by_composition(order):
    """(2/pi) K(m) composed with m = sin^2(theta0/2) as a series in theta0^2."""
    size = order // 2 + 1
    ctx.cap = size
    in_m = [fmpq(1)]
    for n in range(size - 1):
        in_m.append(in_m[-1] * fmpq(2 * n + 1, 2 * n + 2) ** 2)
    parameter = [fmpq(0)] + [fmpq((-1) ** (n + 1), 2 * factorial(2 * n)) for n in range(1, size)]
    ratio = fmpq_series(in_m)(fmpq_series(parameter))
    return ratio, (ratio[size - 1],)


def period_by_euler_numbers(order):
    """4^-n/(2n)! times the coefficient of x^n in exp(sum |E_2j| x^j/(2j)); the Euler numbers by inverting cos."""
    size = order // 2 + 1
    ctx.cap = size
    secant = 1 / fmpq_series([fmpq((-1) ** n, factorial(2 * n)) for n in range(size)])
    terms = [fmpq(0)] + [secant[n] * factorial(2 * n) / (2 * n) for n in range(1, size)]
    exponential = fmpq_series(terms).exp()
    ratio = [exponential[n] / (factorial(2 * n) * 4**n) for n in range(size)]
    return ratio, (ratio[-1],)


CASES = {
    "pendulum": lambda order: solve(pendulum, order),
    "pendulum, full answer": lambda order: full(pendulum, order),
    "duffing": lambda order: solve(duffing, order),
    "duffing, full answer": lambda order: full(duffing, order),
    "van_der_pol": van_der_pol,
    "period": period_by_euler_numbers,
    "period, composition": period_by_composition,
}

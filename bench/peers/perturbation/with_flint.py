"""The cases of series.py on FLINT through python-flint: rational polynomials with one common denominator.

x_n, what stands before eps^n, is c p_n(c^2) with c = cos(tau), so that parity is never stored and the equation for x_n is
triangular: c^k'' = k (k-1) c^(k-2) - k^2 c^k. Gauge: eps is the coefficient of cos(tau).
"""
from math import comb, factorial

import flint
from flint import ctx, fmpq, fmpq_mat, fmpq_poly, fmpq_series

VERSION = f"python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
ZERO, ONE, U = fmpq_poly([]), fmpq_poly([1]), fmpq_poly([0, 1])


class Lindstedt:
    """The part of the recurrence that no force changes. `square` is Omega^2, all dictionaries by the power of eps."""

    def __init__(self):
        self.x, self.second, self.square = {1: ONE}, {1: -ONE}, {0: fmpq(1)}

    def step(self, n, force):
        """Finds x_n and the square of the frequency before eps^(n-1) from the force at order n without its term x_n."""
        rest = force + total(self.square[n - j] * self.second[j] for j in range(3, n, 2))
        found = [fmpq(0)] * (n // 2 + 2)
        for i in range(n // 2, 0, -1):
            k = 2 * i + 1
            found[i] = ((k + 2) * (k + 1) * found[i + 1] + rest[i]) / (k * k - 1)
        self.square[n - 1] = rest[0] + 6 * found[1]
        found[0] = -sum(a * comb(2 * i + 1, i) / 4**i for i, a in enumerate(found))
        self.x[n] = fmpq_poly(found)
        self.second[n] = fmpq_poly(
            [(2 * i + 3) * (2 * i + 2) * found[i + 1] - (2 * i + 1) ** 2 * found[i] for i in range(n // 2 + 1)]
        )


def total(terms):
    return sum(terms, ZERO)


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
    """Omega by powers of eps^2, as many as there are."""
    ctx.cap = order // 2 + 1
    return fmpq_series([found.square[n] for n in range(0, order, 2)]).sqrt()


def harmonics(found, order):
    """Row k: the coefficients of cos((2k+1) tau) by powers of eps."""
    size = (order + 1) // 2
    powers = fmpq_mat([[found.x[2 * n + 1][i] for n in range(size)] for i in range(size)])
    binomials = [[comb(2 * i + 1, i - k) / fmpq(4) ** i if k <= i else 0 for i in range(size)] for k in range(size)]
    return fmpq_mat(binomials) * powers


def solve(oscillator, order):
    """What the command's `frequency_ratio` and `harmonics` hold; the check is the last frequency and the last a_3."""
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

    x_n is c p(c^2) for even n and s p(c^2) with s = i sin(tau) for odd n; D c = s, D s = c, s^2 = c^2 - 1.
    """

    def __init__(self):
        self.omega, self.square = {0: fmpq(1)}, {0: fmpq(1)}
        self.x, self.pairs, self.bend = {}, {}, {}

    def keep(self, n, x):
        """x_n, and what stands before nu^n in x^2 and in D(x - x^3/3)."""
        self.x[n] = x
        u1, g, p = U - 1, self.pairs, self.x
        if n % 2:
            g[n] = 2 * total(p[j] * p[n - j] for j in range(0, n, 2))
            cube = total(p[j] * g[n - j] for j in range(1, n + 1, 2)) + U * total(p[j] * g[n - j] for j in range(0, n, 2))
            smooth = x - cube / 3
            self.bend[n] = smooth + 2 * u1 * smooth.derivative()
        else:
            g[n] = U * mirrored(p, n, 0) + u1 * mirrored(p, n, 1)
            cube = total(p[j] * g[n - j] for j in range(0, n + 1, 2)) + u1 * total(p[j] * g[n - j] for j in range(1, n, 2))
            smooth = x - cube / 3
            self.bend[n] = smooth + 2 * U * smooth.derivative()

    def shift_fundamental(self, n, amount):
        """Adds amount cos(tau) to x_n for even n."""
        self.x[n] += amount
        self.pairs[n] += 4 * amount * U
        self.bend[n] += amount * (1 - 12 * U)

    def rest(self, n):
        bends = total(self.omega[j] * self.bend[n - 1 - j] for j in range(0, n, 2))
        return total(self.square[j] * second(self.x[n - j], n % 2) for j in range(2, n, 2)) - bends

    def even(self, n):
        """The balance of cos(tau) fixes the frequency; the fundamental of x_n waits for the next order."""
        rest, found = self.rest(n), [fmpq(0)] * (n + 2)
        for i in range(n, 0, -1):
            k = 2 * i + 1
            found[i] = ((k + 2) * (k + 1) * found[i + 1] - rest[i]) / (k * k - 1)
        self.square[n] = 3 * found[1] - rest[0] / 2
        self.omega[n] = (self.square[n] - sum(self.omega[j] * self.omega[n - j] for j in range(2, n, 2))) / 2
        found[0] = -sum(a * comb(2 * i + 1, i) / 4**i for i, a in enumerate(found))
        self.keep(n, fmpq_poly(found))

    def odd(self, n):
        """The balance of sin(tau) fixes the fundamental of x_(n-1)."""
        rest, found = self.rest(n), [fmpq(0)] * (n + 2)
        for i in range(n, 0, -1):
            k = 2 * i
            found[i] = ((k + 2) * (k + 1) * found[i + 1] - rest[i]) / (k * k + 2 * k)
        if n > 1:
            amount = found[1] - rest[0] / 2
            self.shift_fundamental(n - 1, amount)
            found[1] -= 3 * amount / 2
        found[0] = -sum(a * comb(2 * i, i) / ((i + 1) * 4**i) for i, a in enumerate(found))
        self.keep(n, fmpq_poly(found))


def mirrored(p, n, parity):
    """The sum of p_j p_(n-j) over j of one parity."""
    if n % 4 == 2 * parity:
        pairs, middle = range(parity, n // 2, 2), p[n // 2] * p[n // 2]
    else:
        pairs, middle = range(parity, (n + 1) // 2, 2), ZERO
    return 2 * total(p[j] * p[n - j] for j in pairs) + middle


def second(p, odd):
    """D^2 of c p(c^2), or of s p(c^2)."""
    a = p.coeffs() + [0]
    return fmpq_poly([(2 * i + 1) ** 2 * a[i] - (2 * i + 3 - odd) * (2 * i + 2 - odd) * a[i + 1] for i in range(len(a) - 1)])


def van_der_pol(order):
    """Omega to mu^order; the check is its last coefficient and the last amplitude of cos(tau) found with it."""
    found = LimitCycle()
    found.keep(0, fmpq_poly([2]))
    for n in range(1, order + 1):
        (found.odd if n % 2 else found.even)(n)
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
    """4^-n/(2n)! times what stands before x^n in exp(sum |E_2j| x^j/(2j)); the Euler numbers by inverting cos."""
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

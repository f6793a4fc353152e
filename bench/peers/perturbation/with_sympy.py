"""The cases of series.py in SymPy: polynomials of sympy.polys.rings over the rationals (gmpy2's), the recurrences of with_flint.py.

IN_SYMBOLS holds the textbook's way: the ansatz put into the Taylor polynomial of the force, expanded, balanced.
"""
from math import comb, factorial

import sympy
from sympy import QQ, expand, ring, symbols
from sympy.external.gmpy import GROUND_TYPES
from sympy.polys.matrices import DomainMatrix
from sympy.polys.ring_series import rs_exp, rs_mul, rs_series_inversion, rs_square

VERSION = f"SymPy {sympy.__version__} on {GROUND_TYPES}"
_, U = ring("u", QQ)
RING, Y = ring("y", QQ)
ONE, ZERO = U.ring.one, U.ring.zero


def total(terms):
    return sum(terms, ZERO)


def second(p):
    """d^2/dtau^2 of c p(c^2)."""
    d = p.diff(U)
    return 4 * U * (1 - U) * d.diff(U) + (6 - 8 * U) * d - p


def twice(p, odd):
    """D^2 of c p(c^2), or of s p(c^2)."""
    if not odd:
        return -second(p)
    d = p.diff(U)
    return 4 * U * (U - 1) * d.diff(U) + (8 * U - 2) * d + p


def triangular(rest, size, odd):
    """Coefficients p with (c p)'' + c p = -c rest (odd) or (s p)'' + s p = -s rest, p_0 = 0 for now; and rest_0."""
    found, rest = [QQ(0)] * (size + 2), coefficients(rest, size + 1)
    for i in range(size, 0, -1):
        k = 2 * i + odd
        found[i] = ((k + 2) * (k + 1) * found[i + 1] + rest[i]) / (k * k - 1 if odd else k * k + 2 * k)
    return found, rest[0]


def coefficients(p, size):
    return [p.get((i,), QQ(0)) for i in range(size)]


def polynomial(found):
    return U.ring.from_dict({(i,): a for i, a in enumerate(found) if a})


def closed(found):
    """The series with p_0 such that cos(tau) does not occur."""
    found[0] = -sum((a * QQ(comb(2 * i + 1, i), 4**i) for i, a in enumerate(found)), QQ(0))
    return polynomial(found)


class Lindstedt:
    """The part of the recurrence that is independent of the force. `square` is Omega^2, all dictionaries by the power of eps."""

    def __init__(self):
        self.x, self.second, self.square = {1: ONE}, {1: -ONE}, {0: QQ(1)}

    def step(self, n, force):
        rest = force + total(self.second[j] * self.square[n - j] for j in range(3, n, 2))
        found, first = triangular(rest, n // 2, 1)
        self.square[n - 1] = first + 6 * found[1]
        self.x[n] = closed(found)
        self.second[n] = second(self.x[n])


def pendulum(order):
    found = Lindstedt()
    slope, sine, cosine = {1: ONE}, {1: ONE}, {0: ONE}
    for n in range(3, order + 1, 2):
        cosine[n - 1] = U * total(slope[j] * sine[n - 1 - j] for j in range(1, n - 1, 2)) * QQ(-1, n - 1)
        force = total(slope[j] * cosine[n - j] for j in range(1, n, 2)) * QQ(1, n)
        found.step(n, force)
        slope[n], sine[n] = n * found.x[n], force + found.x[n]
    return found


def duffing(order):
    found = Lindstedt()
    x, squares = found.x, {2: ONE}
    for n in range(3, order + 1, 2):
        found.step(n, U * total(x[j] * squares[n - j] for j in range(1, n - 1, 2)))
        half = (n + 1) // 2
        squares[n + 1] = 2 * total(x[j] * x[n + 1 - j] for j in range(1, half, 2))
        if half % 2:
            squares[n + 1] += x[half] ** 2
    return found


def root(square, order):
    """The square root of a series with 1 in front, by powers of eps^2."""
    omega = []
    for n in range(order // 2 + 1):
        inner = sum((omega[j] * omega[n - j] for j in range(1, n)), QQ(0))
        omega.append((square[2 * n] - inner) / 2 if n else QQ(1))
    return omega


def solve(oscillator, order):
    """The content of the command's `frequency_ratio` and `harmonics`; the check is the last frequency and the last a_3."""
    order -= 1 - order % 2
    found, size = oscillator(order), order // 2 + 1
    powers = [coefficients(found.x[2 * n + 1], size) for n in range(size)]
    binomials = [[QQ(comb(2 * i + 1, i - k), 4**i) if k <= i else QQ(0) for i in range(size)] for k in range(size)]
    table = matrix(binomials) * matrix(powers).transpose()
    omega = root(found.square, order)
    table = table.to_dense().rep.to_list()
    return omega, table, (omega[-1], table[1][-1])


def matrix(rows):
    return DomainMatrix(rows, (len(rows), len(rows[0])), QQ)


def series(numbers):
    return RING.from_dict({(i,): a for i, a in enumerate(numbers) if a})


def full(oscillator, order):
    """`of_amplitude` too: eps, Omega, T and all harmonics as series in the amplitude."""
    order -= 1 - order % 2
    omega, table, _ = solve(oscillator, order)
    size = order // 2 + 1
    ratio = reversion([sum((row[n] for row in table), QQ(0)) for n in range(size)])
    square = Y * rs_square(ratio, Y, size)
    powers = [RING.one]
    while len(powers) < size:
        powers.append(rs_mul(powers[-1], square, Y, size))
    rows = [[p.get((n,), QQ(0)) for n in range(size)] for p in powers]
    shifted = [[p.get((n,), QQ(0)) for n in range(size)] for p in (rs_mul(ratio, power, Y, size) for power in powers)]
    in_amplitude = (matrix(table) * matrix(shifted)).to_dense().rep.to_list()
    omega = (matrix([omega]) * matrix(rows)).to_dense().rep.to_list()[0]
    period = rs_series_inversion(series(omega), Y, size)
    return ratio, omega, period, in_amplitude, (omega[-1], in_amplitude[1][-1])


def reversion(amplitude):
    """eps/amplitude by powers of amplitude^2, from amplitude/eps by powers of eps^2, by Lagrange: [y^n] h^(-2n-1)/(2n+1)."""
    size = len(amplitude)
    power = rs_series_inversion(series(amplitude), Y, size)
    step, found = rs_square(power, Y, size), []
    for n in range(size):
        found.append(power.get((n,), QQ(0)) / (2 * n + 1))
        power = rs_mul(power, step, Y, size)
    return series(found)


class LimitCycle:
    """Van der Pol with mu = i nu, as in with_flint.py."""

    def __init__(self):
        self.omega, self.square = {0: QQ(1)}, {0: QQ(1)}
        self.x, self.pairs, self.bend = {}, {}, {}

    def keep(self, n, x):
        self.x[n] = x
        p, g = self.x, self.pairs
        if n % 2:
            g[n] = 2 * alternate(p, p, n, 0)
            cube = alternate(p, g, n, 1) + U * alternate(p, g, n, 0)
        else:
            g[n] = U * mirrored(p, n, 0) + (U - 1) * mirrored(p, n, 1)
            cube = alternate(p, g, n, 0) + (U - 1) * alternate(p, g, n, 1)
        smooth = x - cube * QQ(1, 3)
        self.bend[n] = smooth + 2 * (U - n % 2) * smooth.diff(U)

    def step(self, n):
        rest = total(twice(self.x[n - j], n % 2) * self.square[j] for j in range(2, n, 2))
        rest -= total(self.bend[n - 1 - j] * self.omega[j] for j in range(0, n, 2))
        found, first = triangular(-rest, n, 1 - n % 2)
        if n % 2:
            if n > 1:
                amount = found[1] + first / 2
                self.x[n - 1] += amount
                self.pairs[n - 1] += 4 * amount * U
                self.bend[n - 1] += amount * (1 - 12 * U)
                found[1] -= 3 * amount / 2
            found[0] = -sum((a * QQ(comb(2 * i, i), (i + 1) * 4**i) for i, a in enumerate(found)), QQ(0))
            self.keep(n, polynomial(found))
        else:
            self.square[n] = 3 * found[1] + first / 2
            self.omega[n] = (self.square[n] - sum(self.omega[j] * self.omega[n - j] for j in range(2, n, 2))) / 2
            self.keep(n, closed(found))


def alternate(a, b, n, first):
    """The sum of a_j b_(n-j) over j of one parity."""
    return total(a[j] * b[n - j] for j in range(first, n + 1, 2))


def mirrored(p, n, first):
    """The same sum for p and p, with each pair once."""
    middle = p[n // 2] ** 2 if n % 4 == 2 * first else ZERO
    return 2 * total(p[j] * p[n - j] for j in range(first, (n + 1) // 2, 2)) + middle


def van_der_pol(order):
    found = LimitCycle()
    found.keep(0, 2 * ONE)
    for n in range(1, order + 1):
        found.step(n)
    amplitude = sum(a * QQ(comb(2 * i + 1, i), 4**i) for (i,), a in found.x[order - 2].items())
    sign = (-1) ** (order // 2)
    return found, (sign * found.omega[order], -sign * amplitude)


def period_by_composition(order):
    """(2/pi) K(m) with m = sin^2(theta0/2) as a series in theta0^2, by Horner's rule."""
    size = order // 2 + 1
    in_m = [QQ(1)]
    for n in range(size - 1):
        in_m.append(in_m[-1] * QQ(2 * n + 1, 2 * n + 2) ** 2)
    m = series([QQ(0)] + [QQ((-1) ** (n + 1), 2 * factorial(2 * n)) for n in range(1, size)])
    ratio = RING.zero
    for a in reversed(in_m):
        ratio = rs_mul(ratio, m, Y, size) + a
    return ratio, (ratio[(size - 1,)],)


def period_by_euler_numbers(order):
    """4^-n/(2n)! times the coefficient of x^n in exp(sum |E_2j| x^j/(2j))."""
    size = order // 2 + 1
    secant = rs_series_inversion(series([QQ((-1) ** n, factorial(2 * n)) for n in range(size)]), Y, size)
    terms = [QQ(0)] + [secant[(n,)] * factorial(2 * n) / (2 * n) for n in range(1, size)]
    exponential = rs_exp(series(terms), Y, size)
    ratio = [exponential[(n,)] / (factorial(2 * n) * 4**n) for n in range(size)]
    return ratio, (ratio[-1],)


def sine_in_symbols(order):
    return in_symbols(order, {k: QQ((-1) ** (k // 2), factorial(k)) for k in range(3, order + 1, 2)})


def cubic_in_symbols(order):
    return in_symbols(order, {3: QQ(1)})


def in_symbols(order, force):
    """Order by order with unknowns for the next harmonics and the frequency; powers of x by Cauchy products, expanded."""
    order -= 1 - order % 2
    z, frequency, zero = symbols("z"), symbols("W"), sympy.Integer(0)
    x, x2, square = {1: wave(z, 1)}, {1: -wave(z, 1)}, {0: sympy.Integer(1)}
    powers = {1: x} | {k: {} for k in range(2, max(force) + 1)}
    for n in range(3, order + 1, 2):
        for k in range(2, min(n, max(force)) + 1):
            for m in (n - 1, n):
                lower = powers[k - 1]
                powers[k][m] = expand(sum((x[j] * lower[m - j] for j in range(1, m, 2) if m - j in lower), zero))
        unknown = {k: symbols(f"a{k}") for k in range(3, n + 1, 2)}
        x[n] = sum(a * wave(z, k) for k, a in unknown.items())
        x2[n] = -sum(k * k * a * wave(z, k) for k, a in unknown.items())
        square[n - 1] = frequency
        balance = x[n] + sum(sympy.Rational(a.numerator, a.denominator) * powers[k][n] for k, a in force.items() if k <= n)
        balance = expand(balance + sum(square[n - j] * x2[j] for j in range(1, n + 1, 2)))
        answer = sympy.solve([balance.coeff(z, k) for k in range(1, n + 1, 2)], [frequency, *unknown.values()])
        x[n], x2[n], square[n - 1] = (expand(it.subs(answer)) for it in (x[n], x2[n], frequency))
    omega = root({n: QQ(it.p, it.q) for n, it in square.items()}, order)[-1]
    return x, (omega, answer[unknown[3]])


def wave(z, k):
    """cos(k tau), z = exp(i tau)."""
    return (z**k + z**-k) / 2


def mixed_in_letters(order):
    """x'' + w^2 x + a x^2 + b x^3 = 0 with all parameters symbolic, u = 1/w^2: the harmonics of each order as {k: polynomial in a, b, u}.

    The check is every coefficient of Omega/omega0 and of each harmonic."""
    letters, a, b, u = ring("a b u", QQ)
    x, pairs, square = {1: {1: letters.one}}, {}, {0: letters.one}
    for n in range(2, order + 1):
        pairs[n] = waves(letters, [(x[j], x[n - j]) for j in range(1, n)])
        cube = waves(letters, [(x[j], pairs[n - j]) for j in range(1, n - 1)])
        force = {k: u * (a * pairs[n].get(k, 0) + b * cube.get(k, 0)) for k in range(n + 1)}
        square[n - 1] = force[1]
        known = {k: sum((square[n - j] * x[j].get(k, 0) for j in range(1, n)), letters.zero) for k in force}
        x[n] = {k: (k * k * known[k] - force[k]) * QQ(1, 1 - k * k) for k in force if k != 1}
    omega = [letters.one]
    for n in range(1, order):
        inner = sum((omega[j] * omega[n - j] for j in range(1, n)), letters.zero)
        omega.append((square[n] - inner) * QQ(1, 2))
    series = [("frequency", omega)]
    series += [(f"cos {k}", [x[n].get(k, letters.zero) if n else letters.zero for n in range(order + 1)]) for k in range(order + 1)]
    return x, [f"{name} {n}: {terms(p)}" for name, list_ in series for n, p in enumerate(list_) if p]


def waves(letters, products):
    """The sum of products of sums of cosines."""
    found = {}
    for p, q in products:
        for (k, c), (l, d) in ((one, other) for one in p.items() for other in q.items()):
            half = c * d * QQ(1, 2)
            for m in (k + l, abs(k - l)):
                found[m] = found.get(m, letters.zero) + half
    return found


def terms(polynomial):
    """The powers of a, b, w of each term, with its coefficient."""
    return ", ".join(f"{i} {j} {-2 * m} {factor}" for (i, j, m), factor in sorted(polynomial.items()))


CASES = {
    "mixed, letters": mixed_in_letters,
    "pendulum": lambda order: solve(pendulum, order),
    "pendulum, full answer": lambda order: full(pendulum, order),
    "duffing": lambda order: solve(duffing, order),
    "duffing, full answer": lambda order: full(duffing, order),
    "van_der_pol": van_der_pol,
    "period": period_by_euler_numbers,
    "period, composition": period_by_composition,
}
IN_SYMBOLS = {"pendulum": sine_in_symbols, "duffing": cubic_in_symbols}

"""Lindstedt-Poincare series in exact rationals on FLINT, by the plainest recurrences.

An oscillator x'' + f(x) = 0 enters by the Taylor coefficients of f, so every force is a polynomial here. x_n, what stands
before eps^n, is a polynomial in c = cos(tau); W = Omega^2/omega0^2.
"""
from math import comb

from flint import fmpq, fmpq_poly

ZERO = fmpq_poly([])


def second_derivative(x):
    """d^2/dtau^2 of a polynomial in cos(tau): c^k gives k (k-1) c^(k-2) - k^2 c^k."""
    return fmpq_poly([(k + 2) * (k + 1) * x[k + 2] - k * k * x[k] for k in range(x.length())])


def without_resonance(rest, degree):
    """The coefficients of x with x'' + x = -rest but for those before c and below."""
    x = [fmpq(0)] * (degree + 3)
    for k in range(degree, 1, -1):
        x[k] = -(rest[k] + (k + 2) * (k + 1) * x[k + 2]) / (1 - k * k)
    x[0] = -rest[0] - 2 * x[2]
    return x


def fundamental(x):
    """The coefficient of cos(tau)."""
    return sum((x[k] * comb(k, k // 2) / 2 ** (k - 1) for k in range(1, len(x), 2)), fmpq(0))


def conservative(force, order, gauge):
    """W to eps^(order-1) and [x_0, ..., x_order] for f(x) = sum force[k] x^k, fundamental sum gauge[n] eps^n."""
    first, top = fmpq(gauge[1]), max(k for k, a in enumerate(force[: order + 1]) if a)
    frequency, x = [fmpq(1)], [ZERO, fmpq_poly([0, first])]
    powers = {1: x} | {k: [ZERO] * (order + 1) for k in range(2, top + 1)}
    for n in range(2, order + 1):
        for k in range(2, min(n, top) + 1):
            powers[k][n] = sum((x[j] * powers[k - 1][n - j] for j in range(1, n - k + 2)), ZERO)
        rest = sum((force[k] * powers[k][n] for k in range(2, min(n, top) + 1)), ZERO)
        rest += sum((frequency[n - j] * second_derivative(x[j]) for j in range(2, n)), ZERO)
        found = without_resonance(rest, n)
        frequency.append((rest[1] + 6 * found[3]) / first)
        found[1] = fmpq(gauge.get(n, 0)) - fundamental(found)
        x.append(fmpq_poly(found))
    return frequency, x


def harmonics(x):
    """{k: [what stands before eps^n cos(k tau)]} of [x_0, x_1, ...]."""
    table = {k: [fmpq(0)] * len(x) for k in range(len(x))}
    for n, polynomial in enumerate(x):
        for power, coefficient in enumerate(polynomial.coeffs()):
            for i in range(power // 2 + 1):
                k = power - 2 * i
                table[k][n] += coefficient * comb(power, i) / 2 ** (power - 1 if k else power)
    return table


class Laurent:
    """sum p[i] z^(2i - degree), z = exp(i tau): all powers of one parity."""

    def __init__(self, polynomial, degree):
        self.polynomial, self.degree = polynomial, degree

    def __getitem__(self, power):
        index = self.degree + power
        return fmpq(0) if index % 2 or index < 0 else self.polynomial[index // 2]

    def __add__(self, other):
        """Sum of polynomials whose degrees have the same parity."""
        low, high = sorted((self, other), key=lambda it: it.degree)
        return Laurent(high.polynomial + low.polynomial.left_shift((high.degree - low.degree) // 2), high.degree)

    def __mul__(self, other):
        return Laurent(self.polynomial * other.polynomial, self.degree + other.degree)

    def times(self, number):
        return Laurent(self.polynomial * number, self.degree)

    def derivative(self):
        """z d/dz."""
        return Laurent(fmpq_poly([(2 * i - self.degree) * a for i, a in enumerate(self.polynomial.coeffs())]), self.degree)


def van_der_pol(order):
    """x'' + x = mu (1 - x^2) x' with mu = i nu: Omega to nu^order, [x_0, ..., x_(order-1)] as Laurent polynomials.

    -W D^2 x + x = -nu Omega D(x - x^3/3), D = z d/dz, all rational; x_n is even in tau for even n, odd for odd n.
    No sin(tau) occurs, and the coefficient of cos(tau) in x_(n-1) is what lets x_n be periodic for odd n.
    """
    omega, square, x, bent = [fmpq(1)], [fmpq(1)], [Laurent(fmpq_poly([1, 1]), 1)], []
    for n in range(1, order + 1):
        bent.append(bend(x, n - 1))
        if n % 2 and n > 1:
            # alpha (z + 1/z) more in x_(n-1) is 2 alpha z more on the right.
            alpha = -right_side(omega, square, x, bent, n)[1] / 2
            x[n - 1] += Laurent(fmpq_poly([alpha, alpha]), 1)
            bent[n - 1] = bend(x, n - 1)
        right = right_side(omega, square, x, bent, n)
        square.append(-right[1])
        omega.append((square[n] - sum((omega[j] * omega[n - j] for j in range(1, n)), fmpq(0))) / 2)
        x.append(periodic(right, n))
    return omega, x[:order]


def bend(x, n):
    """The coefficient of nu^n in x - x^3/3."""
    return x[n] + cube(x, n).times(fmpq(-1, 3))


def cube(x, n):
    """The coefficient of nu^n in x^3."""
    total = Laurent(ZERO, 1)
    for i in range(n + 1):
        pair = sum_of(x[j] * x[i - j] for j in range(i + 1))
        total += pair * x[n - i]
    return total


def sum_of(terms):
    terms = iter(terms)
    total = next(terms)
    for term in terms:
        total += term
    return total


def right_side(omega, square, x, bent, n):
    """x_n - D^2 x_n but for the term with W_n."""
    total = sum_of(bent[n - 1 - j].derivative().times(-omega[j]) for j in range(n))
    for j in range(1, n):
        total += x[n - j].derivative().derivative().times(square[j])
    return total


def periodic(right, n):
    """x with x - D^2 x = right, without z and 1/z."""
    d = 2 * n + 1
    return Laurent(fmpq_poly([0 if abs(k) == 1 else right[k] / (1 - k * k) for k in range(-d, d + 1, 2)]), d)

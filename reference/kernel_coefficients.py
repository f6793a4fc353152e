#!/usr/bin/env python3
"""Polynomial tables of the double-precision kernels.

Prints, for each kernel, the interpolant of the function at Chebyshev nodes (60 digits, mpmath), rounded to
f64 (leading coefficients that are kept in two words as a pair), with the largest relative error of the
rounded polynomial, evaluated without rounding error, on the interval. Needs `pip install mpmath`.
"""
from mpmath import mp, mpf, matrix, lu_solve, cos, ellipe, sin, pi, agm, log, exp, atan, sinh, cosh, sqrt, atanh

mp.dps = 90


def interpolant(function, low, high, count):
    """Coefficients of the polynomial with `count` terms through the Chebyshev nodes of [low, high]."""
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * count)) for i in range(count)]
    system = matrix(count, count)
    values = matrix(count, 1)
    for i, x in enumerate(nodes):
        values[i] = function(x)
        for j in range(count):
            system[i, j] = x ** j
    return list(lu_solve(system, values))


def two_words(x):
    high = float(x)
    return high, float(x - mpf(high))


def table(name, function, low, high, count, pairs=0, exact=()):
    """Print a table; the first `pairs` coefficients as two words. `exact` coefficients are known in closed form."""
    known = len(exact)

    def rest(x):
        value = function(x)
        for power, c in enumerate(exact):
            value -= c * x ** power
        return value / x ** known if known else value

    low, high = mpf(low), mpf(high)
    fitted = interpolant(rest, low, high, count - known)
    coefficients = list(exact) + fitted
    rounded = [sum(map(mpf, two_words(c))) if i < pairs else mpf(float(c)) for i, c in enumerate(coefficients)]
    worst = mpf(0)
    for i in range(1, 802):
        x = low + (high - low) * i / 801
        value = function(x)
        worst = max(worst, abs(sum(c * x ** j for j, c in enumerate(rounded)) / value - 1))
    print(f"/// {name} on [{mp.nstr(low, 5)}, {mp.nstr(high, 5)}], relative error {mp.nstr(worst, 2)}.")
    for i, c in enumerate(coefficients):
        print("   ", two_words(c) if i < pairs else repr(float(c)), end=",\n")
    print()


def reciprocal(low, high, count):
    """Print the polynomial p with `count` terms for which 1 - x p(x) is Chebyshev's polynomial, one at x = 0: nearest to 1/x."""
    start = (low + high) / (low - high)
    terms = [[mpf(1)], [start, 2 / (high - low)]]
    while len(terms) <= count:
        twice = [mpf(0)] * (len(terms[-1]) + 1)
        for i, c in enumerate(terms[-1]):
            twice[i] += 2 * start * c
            twice[i + 1] += 4 / (high - low) * c
        for i, c in enumerate(terms[-2]):
            twice[i] -= c
        terms.append(twice)
    print(f"/// 1/x on [{mp.nstr(low, 5)}, {mp.nstr(high, 5)}], relative error {mp.nstr(abs(1 / terms[count][0]), 2)}.")
    for c in terms[count][1:]:
        print("   ", mp.nstr(-c / terms[count][0], 9), end=",\n")
    print()


def ratio(s):
    """T/T0 of the amplitude s."""
    return 1 / agm(1, cos(s / 2))


def nome(s):
    return exp(-pi * agm(1, cos(s / 2)) / agm(1, sin(s / 2)))


def positive(function, at_zero):
    """The function, with its limit at zero."""
    return lambda u: function(u) if u > mpf(10) ** -40 else mpf(at_zero)


u_max = (pi / 2) ** 2 * (1 + mpf(2) ** -40)
tiny = mpf(10) ** -30
table("(T/T0 - 1)/u, u = amplitude^2", lambda u: (ratio(sqrt(u)) - 1) / u, tiny, u_max, 15,
      exact=(mpf(1) / 16, mpf(11) / 3072))
table("ln(64 q/u)/u, q the nome of amplitude sqrt(u)", lambda u: log(64 * nome(sqrt(u)) / u) / u, tiny, u_max, 14,
      pairs=1, exact=(mpf(1) / 24,))
table("8 sqrt(q/u)", lambda u: 8 * sqrt(nome(sqrt(u)) / u), tiny, u_max, 14, exact=(mpf(1),))
eighth = (pi / 4) ** 2 * (1 + mpf(2) ** -40)
table("(sin r - r)/r^3 in r^2", lambda x: (sin(sqrt(x)) - sqrt(x)) / sqrt(x) ** 3, tiny, eighth, 6)
table("(cos r - 1 + r^2/2)/r^4 in r^2", lambda x: (cos(sqrt(x)) - 1 + x / 2) / x ** 2, tiny, eighth, 6)
half_ln2 = (log(2) / 2) ** 2 * (1 + mpf(2) ** -40)
table("(sinh r - r)/r^3 in r^2", lambda x: (sinh(sqrt(x)) - sqrt(x)) / sqrt(x) ** 3, tiny, half_ln2, 5)
table("(cosh r - 1 - r^2/2)/r^4 in r^2", lambda x: (cosh(sqrt(x)) - 1 - x / 2) / x ** 2, tiny, half_ln2, 5)
table("(atan t - t)/t^3 in t^2", lambda x: (atan(sqrt(x)) - sqrt(x)) / sqrt(x) ** 3, tiny,
      (sqrt(2) - 1) ** 2 * (1 + mpf(2) ** -40), 11)
table("(2 atanh q - 2q)/q^3 in q^2", lambda x: (2 * atanh(sqrt(x)) - 2 * sqrt(x)) / sqrt(x) ** 3, tiny,
      ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * (1 + mpf(2) ** -40), 8)
reciprocal(1 + sqrt(mpf(1) / 2), 1 + sqrt(mpf(2)), 4)
table("(2 atanh q - 2q)/q^3 in q^2, in two words", lambda x: (2 * atanh(sqrt(x)) - 2 * sqrt(x)) / sqrt(x) ** 3, tiny,
      ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * (1 + mpf(2) ** -40), 14, pairs=9)
table("(sin r - r)/r^3 in r^2, first coefficient in two words", lambda x: (sin(sqrt(x)) - sqrt(x)) / sqrt(x) ** 3, tiny,
      eighth, 7, pairs=1, exact=(-mpf(1) / 6,))
table("(cos r - 1 + r^2/2)/r^4 in r^2, first coefficient in two words", lambda x: (cos(sqrt(x)) - 1 + x / 2) / x ** 2,
      tiny, eighth, 7, pairs=1, exact=(mpf(1) / 24,))


def first(p):
    """2K/pi of the parameter p."""
    return 1 / agm(1, sqrt(1 - p))


def log_of_nome(p):
    """ln(16 q/p)."""
    return log(16 / p) - pi * agm(1, sqrt(1 - p)) / agm(1, sqrt(p))


def second(p):
    """2E/pi."""
    return 2 / pi * ellipe(p)


def of_logarithm(p):
    """A in E(k') = 1 + p/4 (A ln(16/p) - B): 4(K - E)/(pi p)."""
    return 2 * (first(p) - second(p)) / p


def without_logarithm(p):
    """B, by Legendre's relation."""
    return of_logarithm(p) * log_of_nome(p) + 4 * (1 - 1 / first(p)) / p


half = mpf(1) / 2
table("(2K/pi - 1 - p/4 - 9p^2/64)/p^3", lambda p: (first(p) - 1 - p / 4 - 9 * p**2 / 64) / p**3, tiny, half, 20)
table("(ln(16 q/p) - p/2 - 13p^2/64)/p^3", lambda p: (log_of_nome(p) - p / 2 - 13 * p**2 / 64) / p**3, tiny, half, 19)
table("(2E/pi - 1 + p/4)/p^2", lambda p: (second(p) - 1 + p / 4) / p**2, tiny, half, 19)
table("(A - 1 - 3p/8)/p^2, A = 4(K - E)/(pi p)", lambda p: (of_logarithm(p) - 1 - 3 * p / 8) / p**2, tiny, half, 20)
table("(B - 1 - 13p/16)/p^2, E(k') = 1 + p/4 (A ln(16/p) - B)", lambda p: (without_logarithm(p) - 1 - 13 * p / 16) / p**2,
      tiny, half, 20)

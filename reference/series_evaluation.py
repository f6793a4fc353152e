"""Tables for the evaluation of the pendulum's series: how many terms are needed, and Pade approximants.

The coefficients of T/T0 come from the differential equation of Legendre's function P_{-1/2}(cos theta0) by a recurrence
in exact fractions, those of the frequency from the reciprocal series, the period itself from the arithmetic-geometric
mean; Pade approximants by elimination.
Run: python reference/series_evaluation.py terms_needed > crates/libration-testing/data/series_terms_needed.csv
     python reference/series_evaluation.py pade         > crates/libration-testing/data/series_pade.csv
"""
import math
import sys
from fractions import Fraction

from mpmath import agm, cos, log, mp, mpf, nstr, pi, polyroots

mp.dps = 60
CORRECTIONS = 330


def cotangent(count):
    """c_k of cot x = 1/x + sum c_k x^(2k-1), k = 1 ... count, from sin x cot x = cos x."""
    sine = [Fraction((-1) ** k, math.factorial(2 * k + 1)) for k in range(count + 1)]
    series = []
    for k in range(count + 1):
        cosine = Fraction((-1) ** k, math.factorial(2 * k))
        series.append(cosine - sum(sine[k - i] * series[i] for i in range(k)))
    return series


def period(count):
    """t_n of T/T0 = sum t_n theta0^(2n): R'' + cot(theta0) R' = R/4."""
    cot = cotangent(count)
    t = [Fraction(1)]
    for n in range(1, count + 1):
        known = t[n - 1] / 4 - sum(2 * i * t[i] * cot[n - i] for i in range(1, n))
        t.append(known / (2 * n * (2 * n - 1) + 2 * n))
    return t


def reciprocal(t):
    d = [Fraction(1)]
    for n in range(1, len(t)):
        d.append(-sum(t[i] * d[n - i] for i in range(1, n + 1)))
    return d


def exact(value):
    return mpf(value.numerator) / value.denominator


def first_within(coefficients, truth, square, tolerance):
    """The least number of corrections whose sum is within the tolerance."""
    total, power = mpf(0), mpf(1)
    for n, coefficient in enumerate(coefficients):
        total += coefficient * power
        power *= square
        if abs(total / truth - 1) <= tolerance:
            return n
    return ""


def certified(ratio, square, tolerance):
    """From 0 < R - sum <= (11 pi^4/1536) sum_{n>N} x^n/n, the tail of the logarithm summed exactly."""
    x = square / pi**2
    tail, power = -log(1 - x), x
    for n in range(10**4):
        if 11 * pi**4 / 1536 * tail <= tolerance * ratio:
            return n
        tail -= power / (n + 1)
        power *= x
    return ""


def terms_needed():
    print("# How many corrections make the pendulum's series right to a fraction. Source: computed by")
    print("# reference/series_evaluation.py (exact fractions, mpmath). Licence: MIT OR Apache-2.0.")
    print("# period: of T/T0 by powers of theta0^2; certified: the same by its proven bound; frequency: of T0/T.")
    print("degrees,tolerance,period,certified,frequency")
    t = period(CORRECTIONS)
    t, d = [exact(c) for c in t], [exact(c) for c in reciprocal(t)]
    for degrees in (5, 10, 30, 45, 60, 90, 120, 150, 160, 170):
        angle = mpf(degrees) * pi / 180
        ratio = 1 / agm(1, cos(angle / 2))
        for text in ("1e-3", "1e-6", "1e-9", "1e-12", "2.2e-16"):
            cells = (
                first_within(t, ratio, angle**2, mpf(text)),
                certified(ratio, angle**2, mpf(text)),
                first_within(d, 1 / ratio, angle**2, mpf(text)),
            )
            print(degrees, text, *cells, sep=",")


def eliminated(matrix, right):
    n = len(right)
    rows = [row + [value] for row, value in zip(matrix, right)]
    for i in range(n):
        pivot = next(j for j in range(i, n) if rows[j][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for j in range(n):
            if j != i:
                rows[j] = [a - rows[j][i] * b for a, b in zip(rows[j], rows[i])]
    return [row[-1] for row in rows]


def pade():
    print("# Pade approximants of T/T0 by powers of theta0^2. Source: computed by reference/series_evaluation.py (exact")
    print("# fractions, elimination). Licence: MIT OR Apache-2.0. Coefficients of ascending powers, separated by blanks;")
    print("# poles in theta0^2 by ascending distance.")
    print("m,n,numerator,denominator,poles_re,poles_im")
    t = period(24)
    for m, n in ((0, 1), (1, 1), (1, 2), (2, 2), (3, 3), (4, 4), (5, 5), (6, 3), (2, 7), (10, 10)):
        c = lambda k: t[k] if k >= 0 else Fraction(0)
        matrix = [[c(m + i - j) for j in range(1, n + 1)] for i in range(1, n + 1)]
        q = [Fraction(1)] + eliminated(matrix, [-c(m + i) for i in range(1, n + 1)])
        p = [sum(q[j] * c(k - j) for j in range(min(k, n) + 1)) for k in range(m + 1)]
        roots = polyroots([exact(value) for value in reversed(q)], maxsteps=500, extraprec=500)
        roots.sort(key=abs)
        parts = [[nstr(part, 20) for part in both] for both in ([r.real for r in roots], [r.imag for r in roots])]
        print(m, n, *(" ".join(map(str, cells)) for cells in (p, q, *parts)), sep=",")


if __name__ == "__main__":
    {"terms_needed": terms_needed, "pade": pade}[sys.argv[1]]()

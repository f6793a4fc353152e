"""tests/data/truncated_system.csv: every solution of the pendulum's equations for few harmonics.

Projections by exact Fourier arithmetic in SymPy, all unknowns but one eliminated by a resultant, its roots to 50
digits by mpmath, the other unknowns from a common root; nothing is followed by continuation.
Run: python reference/truncated_system.py > crates/libration-testing/data/truncated_system.csv
"""
import math

import sympy
from mpmath import mp, mpc, mpf, nstr, polyroots

mp.dps = 60
HEADER = """\
# Solutions of Delta^2 x'' + x - x^3/3! + ... = 0 projected on the odd harmonics of x = a1 cos t + a3 cos 3t (+ a5 cos 5t),
# the force cut off after x^degree, with a1 + a3 (+ a5) = amplitude; squared = Delta^2. Source: computed by
# reference/truncated_system.py (SymPy, mpmath, elimination by resultants). Licence: MIT OR Apache-2.0.
# Every solution is listed, complex ones and those with a1 = 0 included."""
CASES = [
    (2, 3, sympy.Rational(3, 4)),
    (2, 3, sympy.Rational(3)),
    (2, 5, sympy.Rational(3, 2)),
    (3, 3, sympy.Rational(3, 2)),
    (3, 5, sympy.Rational(3, 4)),
    (3, 5, sympy.Rational(5, 2)),
]


def projections(amplitudes, degree):
    """Coefficients of z^1, z^3, ... (doubled) of the cut-off sine, x written in z = e^{it}."""
    count = len(amplitudes)
    x = {}
    for i, a in enumerate(amplitudes):
        x[2 * i + 1] = x[-2 * i - 1] = a / 2
    total = [0] * count
    power = {0: sympy.Integer(1)}
    for p in range(1, degree + 1):
        product = {}
        for k, u in power.items():
            for l, v in x.items():
                product[k + l] = sympy.expand(product.get(k + l, 0) + u * v)
        power = product
        if p % 2:
            factor = sympy.Rational((-1) ** (p // 2), math.factorial(p))
            total = [t + 2 * factor * power.get(2 * i + 1, 0) for i, t in enumerate(total)]
    return [sympy.expand(t) for t in total]


def numeric(polynomial, *symbols):
    return sympy.lambdify(symbols, polynomial, "mpmath")


def coefficients(polynomial, symbol):
    return [mp.mpmathify(c) for c in sympy.Poly(polynomial, symbol).all_coeffs()]


def roots(values):
    while abs(values[0]) < mpf(10) ** -45 * max(abs(v) for v in values):
        values = values[1:]
    return polyroots(values, maxsteps=2000, extraprec=2000)


def solutions(count, degree, amplitude):
    a = sympy.symbols("a1 a3 a5")[:count]
    others = a[1:]
    force = [g.subs(a[0], amplitude - sum(others)).expand() for g in projections(a, degree)]
    first = amplitude - sum(others)
    # Parallel vectors: n^2 a_n g_1 = a_1 g_n.
    conditions = [
        sympy.expand((2 * i + 1) ** 2 * a[i] * force[0] - first * force[i]) for i in range(1, count)
    ]
    if count == 2:
        points = [(root,) for root in roots(coefficients(conditions[0], a[1]))]
    else:
        points = common_roots(conditions, others)
    for point in points:
        values = (mp.mpmathify(amplitude) - sum(point), *point)
        pairs = [(n * n * v, numeric(g, *others)(*point)) for n, v, g in zip((1, 3, 5), values, force)]
        inertia, strongest = max(pairs, key=lambda pair: abs(pair[0]))
        squared = strongest / inertia
        # Where a1 and g_1 both vanish the conditions hold although the other vectors are not parallel.
        if all(abs(squared * u - g) < mpf(10) ** -20 for u, g in pairs):
            yield values, squared


def common_roots(conditions, others):
    a3, a5 = others
    resultant = sympy.resultant(*(sympy.Poly(c, a5, a3) for c in conditions))
    resultant = sympy.Poly(resultant.as_expr(), a3).sqf_part()
    # Without a third harmonic the roots are multiple, so there the common ones are found exactly.
    without = sympy.gcd(*(sympy.Poly(c.subs(a3, 0), a5) for c in conditions))
    yield from ((mpf(0), root) for root in roots(coefficients(without.sqf_part().as_expr(), a5)))
    for root in roots(coefficients(sympy.cancel(resultant.as_expr() / a3), a3)):
        in_a5 = [numeric(c, a3) for c in sympy.Poly(conditions[0], a5).all_coeffs()]
        candidates = roots([mpc(c(root)) for c in in_a5])
        second = numeric(conditions[1], a3, a5)
        yield from ((root, c) for c in candidates if abs(second(root, c)) < mpf(10) ** -20)


def row(count, degree, amplitude, values, squared):
    cells = [count, degree, float(amplitude)]
    for number in (*values, *[mpc(0)] * (3 - count), squared):
        number = mpc(number)
        cells += [nstr(part, 25) if abs(part) > mpf(10) ** -40 else "0" for part in (number.real, number.imag)]
    return ",".join(map(str, cells))


if __name__ == "__main__":
    print(HEADER)
    print("harmonics,degree,amplitude,a1_re,a1_im,a3_re,a3_im,a5_re,a5_im,squared_re,squared_im")
    for case in CASES:
        found = sorted(solutions(*case), key=lambda it: (abs(mpc(it[1]).imag), mpc(it[1]).real))
        for values, squared in found:
            print(row(*case, values, squared))

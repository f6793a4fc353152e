"""tests/data/expansions_*.csv: perturbation series in exact rationals, by FLINT.

The oscillators' series come by the recurrences of lindstedt.py and, independently, by reversion of the potential; the
pendulum's must also be their closed forms. Every agreement is asserted while the tables are made.
Run: python reference/expansions.py TABLE > crates/libration-testing/data/expansions_TABLE.csv
TABLE is pendulum, oscillators or limit_cycles. Needs python-flint.
"""
import sys
from math import comb, factorial

from flint import ctx, fmpq, fmpq_series

from lindstedt import conservative, harmonics, van_der_pol

LICENCE = "Source: computed by reference/expansions.py (FLINT, exact rationals). Licence: MIT OR Apache-2.0."
COLUMNS = """\
# series: frequency_ratio is Omega/omega0, period_ratio its reciprocal, x_max and x_min the turning points, cosK and sinK
# what stands before cos(K Omega t) and sin(K Omega t); coefficient stands before variable^power; zeros are left out.
# gauge names the variable: fundamental = coefficient of cos(Omega t), x_max = the turning point at t = 0, half_swing =
# (x_max - x_min)/2, energy = sqrt(2E)/omega0, nome = 8 sqrt(q), or the fundamental as A1 eps + A3 eps^3."""
FULL = 31
SHORT = 23
HARMONICS = 11
IN_AMPLITUDE = 22


def row(*cells):
    print(",".join(map(str, cells)))


def rows(oscillator, gauge, series, coefficients, step=1, first=0):
    for n, a in enumerate(coefficients):
        if a:
            row(oscillator, gauge, series, first + step * n, a)


def root(square):
    """The square root of a series with 1 in front, as long as it is."""
    ctx.cap = len(square)
    return listed(fmpq_series(square).sqrt())


def listed(series):
    return [series[n] for n in range(ctx.cap)]


def reciprocal(series):
    ctx.cap = len(series)
    return listed(1 / fmpq_series(series))


def reversion(series):
    ctx.cap = len(series)
    return listed(fmpq_series(series).reversion())


def composed(outer, inner):
    ctx.cap = len(inner)
    return listed(fmpq_series(outer)(fmpq_series(inner)))


class Expansion:
    """The series of an oscillator in one gauge."""

    def __init__(self, force, order, gauge):
        square, x = conservative(force, order, gauge)
        self.frequency, self.harmonics = root(square), harmonics(x)
        self.x_max = [sum(polynomial.coeffs(), fmpq(0)) for polynomial in x]
        self.x_min = [polynomial(fmpq(-1)) for polynomial in x]

    def print(self, oscillator, gauge):
        rows(oscillator, gauge, "frequency_ratio", self.frequency)
        rows(oscillator, gauge, "x_max", self.x_max)
        rows(oscillator, gauge, "x_min", self.x_min)
        for k, series in self.harmonics.items():
            rows(oscillator, gauge, f"cos{k}", series)


def fundamental_in(variable):
    """The gauge whose variable is a given series in the fundamental."""
    return dict(enumerate(reversion(variable)))


class Well:
    """Series of x'' + f(x) = 0 from its potential V = xi^2/2, x = X(xi), dt = X'(xi) dphi with xi = sqrt(2E) sin(phi)."""

    def __init__(self, force, order):
        ctx.cap = order + 1
        root_of = fmpq_series([2 * force[k] / (k + 1) for k in range(1, order + 2)]).sqrt()
        self.xi = [fmpq(0)] + [root_of[n] for n in range(order)]
        self.x = reversion(self.xi)
        self.period_in_energy = [
            (n + 1) * self.x[n + 1] * comb(n, n // 2) / 2**n if n % 2 == 0 else fmpq(0) for n in range(order)
        ]
        self.period = composed(self.period_in_energy, self.xi)[:order]
        self.frequency = reciprocal(self.period)
        self.x_min = composed(self.x, [-a for a in self.xi])

    def print(self, oscillator):
        rows(oscillator, "energy", "period_ratio", self.period_in_energy)
        rows(oscillator, "x_max", "frequency_ratio", self.frequency)
        rows(oscillator, "x_max", "period_ratio", self.period)
        if any(self.x_min[2:]):
            rows(oscillator, "x_max", "x_min", self.x_min)
            x_max = [fmpq(int(n == 1)) for n in range(len(self.x_min))]
            half_swing = [(high - low) / 2 for high, low in zip(x_max, self.x_min)]
            rows(oscillator, "half_swing", "frequency_ratio", composed(self.frequency, reversion(half_swing)[: len(self.frequency)]))


def odd(coefficient, order):
    """A force with coefficient(k) before x^(2k+1)."""
    return [fmpq(coefficient(n // 2)) if n % 2 else fmpq(0) for n in range(order + 2)]


def force_of(polynomial, order):
    return [fmpq(polynomial.get(n, 0)) for n in range(order + 2)]


def forces(order):
    """Taylor coefficients of f in x'' + f(x) = 0."""
    every = range(order + 2)
    return {
        "x + x^3": force_of({1: 1, 3: 1}, order),
        "x - x^3": force_of({1: 1, 3: -1}, order),
        "x + x^3 + x^5": force_of({1: 1, 3: 1, 5: 1}, order),
        "x + x^2": force_of({1: 1, 2: 1}, order),
        "x + x^2 + x^3": force_of({1: 1, 2: 1, 3: 1}, order),
        "x/sqrt(1 + x^2)": odd(lambda k: fmpq((-1) ** k * comb(2 * k, k), 4**k), order),
        "x/(1 + x^2)": odd(lambda k: (-1) ** k, order),
        "sin(x)": odd(lambda k: fmpq((-1) ** k, factorial(2 * k + 1)), order),
        "sinh(x)": odd(lambda k: fmpq(1, factorial(2 * k + 1)), order),
        "exp(-x) - exp(-2*x)": [fmpq((-1) ** n * (1 - 2**n), factorial(n)) for n in every],
        "exp(x) - 1": [fmpq(int(n > 0), factorial(n)) for n in every],
    }


def relativistic(order):
    """T/2pi of x'' + x (1 - x'^2)^(3/2) = 0: the mean of (1 + w)/sqrt(1 + w/2), w = (A^2/2) cos^2 phi."""
    size = order // 2
    ctx.cap = size
    integrand = listed(fmpq_series([1, 1]) / fmpq_series([1, fmpq(1, 2)]).sqrt())
    period = [a * comb(2 * n, n) / fmpq(8) ** n for n, a in enumerate(integrand)]
    return period, reciprocal(period)


def header(*lines):
    print(*(f"# {line}" for line in (*lines, LICENCE)), COLUMNS, "oscillator,gauge,series,power,coefficient", sep="\n")


def oscillators():
    header(
        "Conservative oscillators x'' + force = 0, omega0 = 1, from two roads that agree: the reversion of the potential and",
        "Lindstedt-Poincare. The relativistic x*(1-x'^2)^(3/2) comes from its first integral.",
    )
    for name, force in forces(IN_AMPLITUDE + 1).items():
        well = Well(force, IN_AMPLITUDE + 1)
        well.print(name)
        expansion = Expansion(force, HARMONICS, {1: 1})
        expansion.print(name, "fundamental")
        in_x_max = Expansion(force, HARMONICS, fundamental_in(expansion.x_max))
        assert in_x_max.x_max == [int(n == 1) for n in range(HARMONICS + 1)]
        assert in_x_max.x_min == well.x_min[: HARMONICS + 1]
        assert in_x_max.frequency == well.frequency[:HARMONICS]
        for k, series in in_x_max.harmonics.items():
            rows(name, "x_max", f"cos{k}", series)
    period, frequency = relativistic(IN_AMPLITUDE + 2)
    rows("x*(1-x'^2)^(3/2)", "x_max", "frequency_ratio", frequency, step=2)
    rows("x*(1-x'^2)^(3/2)", "x_max", "period_ratio", period, step=2)


def pendulum():
    header("The pendulum x'' + sin(x) = 0. The gauges fundamental, x_max, energy and nome also meet their closed forms.")
    sine = forces(FULL)["sin(x)"]
    expansion = Expansion(sine, FULL, {1: 1})
    in_amplitude = Expansion(sine, FULL, fundamental_in(expansion.x_max))
    in_energy = Expansion(sine, SHORT, fundamental_in(composed(energy_variable(FULL + 1), expansion.x_max)))
    in_nome = Expansion(sine, SHORT, dict(enumerate(nome_fundamental(SHORT))))
    assert reciprocal(in_amplitude.frequency) == Well(sine, FULL).period
    assert reciprocal(in_energy.frequency) == complete_integral(SHORT)
    assert reciprocal(in_nome.frequency) == theta_square(SHORT)
    assert expansion.frequency == reciprocal(secant_sum(FULL))
    for n in range(FULL // 2 + 1):
        assert expansion.harmonics[2 * n + 1] == closed_harmonic(n, FULL + 1)
    expansion.print("sin(x)", "fundamental")
    Expansion(sine, FULL, {1: 1, 3: -1}).print("sin(x)", "A1=1 A3=-1")
    in_amplitude.print("sin(x)", "x_max")
    rows("sin(x)", "x_max", "period_ratio", reciprocal(in_amplitude.frequency))
    in_energy.print("sin(x)", "energy")
    in_nome.print("sin(x)", "nome")


def energy_variable(length):
    """2 sin(theta0/2)."""
    return [fmpq((-1) ** (n // 2), factorial(n) * 2 ** (n - 1)) if n % 2 else fmpq(0) for n in range(length)]


def complete_integral(length):
    """(2/pi) K in 2 k."""
    return [fmpq(comb(n, n // 2) ** 2, 8**n) if n % 2 == 0 else fmpq(0) for n in range(length)]


def nome_fundamental(length):
    """a1 = 8 sqrt(q)/(1 + q) in 8 sqrt(q)."""
    return [fmpq((-1) ** (n // 2), 64 ** (n // 2)) if n % 2 else fmpq(0) for n in range(length + 1)]


def theta_square(length):
    """theta_3(q)^2 in 8 sqrt(q)."""
    ctx.cap = length
    theta = [fmpq(0)] * length
    for n in range(length):
        if 2 * n * n < length:
            theta[2 * n * n] = fmpq(2 if n else 1, 64 ** (n * n))
    return listed(fmpq_series(theta) ** 2)


def chebyshev(k):
    """Coefficients of x^k T_k(1/x)."""
    before, now = [1], [1, 0]
    for _ in range(k - 1):
        doubled = [2 * a for a in now] + [0]
        before, now = now, [a - b for a, b in zip(doubled, [0, 0] + before)]
    return now if k else before


def over_chebyshev(k, length):
    """1/T_k(4/eps)."""
    ctx.cap = length
    scaled = [fmpq(a * 4 ** (k - n), 1) for n, a in enumerate(chebyshev(k))]
    return listed(fmpq_series([int(n == k) for n in range(length)]) / fmpq_series(scaled))


def closed_harmonic(n, length):
    return [4 * (-1) ** n * a / (2 * n + 1) for a in over_chebyshev(2 * n + 1, length)]


def secant_sum(length):
    """T/T0 = 1 + 2 sum 1/T_2n(4/eps)."""
    terms = [over_chebyshev(2 * n, length) for n in range(1, length // 2 + 1)]
    return [int(n == 0) + 2 * sum(term[n] for term in terms) for n in range(length)]


def limit_cycles():
    header(
        "Limit cycles: the variable is mu, without sin(tau). van_der_pol: x'' + x = mu (1 - x^2) x'. rayleigh:",
        "x'' + x = mu (1 - x'^2/3) x', whose x' is Van der Pol's x; with 1 - x'^2 all harmonics are divided by sqrt(3).",
    )
    omega, x = van_der_pol(LONGEST)
    omega = [(-1) ** (n // 2) * a for n, a in enumerate(omega)]
    table = real_harmonics(x)
    rows("van_der_pol", "mu", "frequency_ratio", omega)
    for name, series in table.items():
        rows("van_der_pol", "mu", name, series if name == "cos1" else series[: HARMONICS + 1])
    for name, series in of_integral(table, omega).items():
        rows("rayleigh", "mu", name, series)


def real_harmonics(x):
    """cosK and sinK in mu = i nu: z^k + z^-k is 2 cos, nu (z^k - z^-k) is 2 mu sin."""
    table = {}
    for k in range(1, 2 * HARMONICS + 2, 2):
        signed = [2 * (-1) ** (n // 2) * a[k] for n, a in enumerate(x)]
        table[f"cos{k}"] = [fmpq(0) if n % 2 else a for n, a in enumerate(signed)]
        table[f"sin{k}"] = [a if n % 2 else fmpq(0) for n, a in enumerate(signed)]
    return table


def of_integral(table, omega):
    """The harmonics of the integral over t, a quarter of a period later: the fundamental is a cosine again."""
    shorter = {"frequency_ratio": omega[: HARMONICS + 1]}
    slowness = reciprocal(shorter["frequency_ratio"])
    ctx.cap = HARMONICS + 1
    for name, series in table.items():
        k = int(name[3:])
        shorter[name] = [(-1) ** (k // 2) * a / k for a in listed(fmpq_series(series) * fmpq_series(slowness))]
    return shorter


LONGEST = 61
TABLES = {"pendulum": pendulum, "oscillators": oscillators, "limit_cycles": limit_cycles}

if __name__ == "__main__":
    if sys.argv[1:] and sys.argv[1] in TABLES:
        TABLES[sys.argv[1]]()
    else:
        sys.exit(__doc__)

"""tests/data/formulas_*.csv: the published formulas for T/T0, their exact errors, and where these are equal.

Every formula is written out here from its paper; the exact period is 1/agm(1, cos(theta0/2)) (DLMF 19.8.5).
`formulas_oeis_series.csv` is not made here: it is a copy of the OEIS.
Run: python reference/formulas.py TABLE > crates/libration-testing/data/formulas_TABLE.csv
with TABLE one of errors, error_quotients, claims, worst_errors, series.
"""
import sys
from fractions import Fraction
from math import comb, factorial

from mpmath import agm, besselj, cos, exp, findroot, inf, log, mp, mpf, nstr, pi, polyval, radians, sin, sqrt

TERMS = 12


def rational(fraction):
    return mpf(fraction.numerator) / fraction.denominator


# The series, in exact rationals.


def times(a, b):
    """The product of two series, cut to TERMS."""
    return [sum(a[i] * b[n - i] for i in range(n + 1)) for n in range(TERMS)]


def reciprocal(a):
    """1/a for a[0] = 1."""
    inverse = [Fraction(1)]
    for n in range(1, TERMS):
        inverse.append(-sum(a[i] * inverse[n - i] for i in range(1, n + 1)))
    return inverse


def period_in_sine_squared():
    """(2/pi) K = sum ((2n)!/(2^n n!)^2)^2 k^(2n) (DLMF 19.5.1)."""
    return [Fraction(comb(2 * n, n), 4**n) ** 2 for n in range(TERMS)]


def period_in_amplitude():
    """The series composed with k^2 = (1 - cos theta0)/2 as a series in theta0^2."""
    sine_squared = [Fraction(0)] + [Fraction((-1) ** (n + 1), 2 * factorial(2 * n)) for n in range(1, TERMS)]
    power, total = [Fraction(1)] + [Fraction(0)] * (TERMS - 1), [Fraction(0)] * TERMS
    for coefficient in period_in_sine_squared():
        total = [t + coefficient * p for t, p in zip(total, power)]
        power = times(power, sine_squared)
    return total


PERIOD = period_in_amplitude()
FREQUENCY = reciprocal(PERIOD)


def series():
    yield "# Exact coefficients: T/T0 in theta0^2, T0/T in theta0^2, T/T0 in sin^2(theta0/2)."
    yield "# " + MADE_BY.format("exact rationals, (2/pi)K composed with sin^2(theta0/2), and its reciprocal")
    yield "series,n,coefficient"
    for name, coefficients in [
        ("period_in_amplitude", PERIOD),
        ("frequency_in_amplitude", FREQUENCY),
        ("period_in_sine_squared", period_in_sine_squared()),
    ]:
        yield from (f"{name},{n},{c}" for n, c in enumerate(coefficients))


# The formulas: x is theta0, c = cos(x/2), k = sin(x/2).


def polynomial(coefficients, x, corrections):
    return sum(rational(c) * x ** (2 * n) for n, c in enumerate(coefficients[: corrections + 1]))


def power_series(corrections):
    return lambda x: polynomial(PERIOD, x, corrections)


def black_vel(corrections):
    return lambda x: 1 / polynomial(FREQUENCY, x, corrections)


def pade(coefficients, degree, variable):
    """The quotient whose product with its denominator agrees with the series (mpmath.pade, Baker and Graves-Morris)."""

    def formula(x):
        # In the digits of the moment.
        series = [rational(c) for c in coefficients[: 2 * degree + 1]]
        numerator, denominator = mp.pade(series, degree, degree)
        return polyval(numerator[::-1], variable(x)) / polyval(denominator[::-1], variable(x))

    return formula


def molina(x):
    return (x / sin(x)) ** (mpf(3) / 8) if x else mpf(1)


def carvalhaes_suppes(x):
    return 4 / (1 + sqrt(cos(x / 2))) ** 2


def belendez(x):
    s = sqrt(cos(x / 2))
    return 64 / (16 * (1 + s) ** 2 - (1 - s) ** 4)


def cubic_force(x):
    """Defined below 2 sqrt 2."""
    return 1 / sqrt(1 - x**2 / 8) if x**2 < 8 else inf


def ganley_parwani(x):
    y = sqrt(3) / 2 * x
    return sqrt(y / sin(y))


def lima_arun(x):
    c = cos(x / 2)
    return -log(c) / (1 - c)


def cromer(x):
    return 2 / pi * log(4 / cos(x / 2))


def two_term_log(x):
    c = cos(x / 2)
    return 2 / pi * (log(4 / c) + (log(4 / c) - 1) * c**2 / 4)


def lima_2008(x):
    low, high = mpf("7.17") * cos(x / 2) ** 2, sin(x / 2) ** 2
    return (low * lima_arun(x) + high * cromer(x)) / (low + high)


def chachiyo(x):
    n = log(pi / 4) / (log(4) - pi / 2)
    b = exp(n * pi / 2) - mpf(4) ** n
    return 2 / (pi * n) * log((4 / cos(x / 2)) ** n + b)


def means(x, steps):
    """a_n and b_n of the AGM from 1 and c."""
    a, b = mpf(1), cos(x / 2)
    for _ in range(steps):
        a, b = (a + b) / 2, sqrt(a * b)
    return a, b


def nome_one_root(x):
    s = sqrt(cos(x / 2))
    small = (1 - s) / (2 * (1 + s))
    q = small + 2 * small**5
    return 4 * (1 + 2 * q**4) ** 2 / (1 + s) ** 2


FORMULAS = {
    "small_angle": lambda x: mpf(1),
    "bernoulli": lambda x: 1 + x**2 / 16,
    "molina": molina,
    "kidd_fogg": lambda x: 1 / sqrt(cos(x / 2)),
    "butikov": lambda x: 2 / pi * log(8 / (pi - x)),
    "power_series_2": power_series(2),
    "power_series_3": power_series(3),
    "denman": black_vel(1),
    "black_vel_2": black_vel(2),
    "black_vel_3": black_vel(3),
    "carvalhaes_suppes": carvalhaes_suppes,
    "belendez": belendez,
    "ganley_parwani": ganley_parwani,
    "cubic_force": cubic_force,
    "describing_function": lambda x: sqrt(x / (2 * besselj(1, x))),
    "lima_arun": lima_arun,
    "cromer": cromer,
    "two_term_log": two_term_log,
    "lima_2008": lima_2008,
    "agm_a1": lambda x: 1 / means(x, 1)[0],
    "agm_b2": lambda x: 1 / means(x, 2)[1],
    "agm_a3": lambda x: 1 / means(x, 3)[0],
    "agm_a4": lambda x: 1 / means(x, 4)[0],
    "agm_a5": lambda x: 1 / means(x, 5)[0],
    "chachiyo": chachiyo,
    "nome_one_root": nome_one_root,
    **{f"pade_power_{n}": pade(PERIOD, n, lambda x: x**2) for n in (1, 2, 3, 5)},
    **{f"pade_sin2_{n}": pade(period_in_sine_squared(), n, lambda x: sin(x / 2) ** 2) for n in (1, 2, 3, 5)},
}


def exact(x):
    return 1 / agm(1, cos(x / 2))


def error(key, x):
    return FORMULAS[key](x) / exact(x) - 1


# The tables.

MADE_BY = "Source: computed by reference/formulas.py ({}). Licence: MIT OR Apache-2.0."

TWELVE = """small_angle bernoulli molina kidd_fogg butikov power_series_2 power_series_3 denman black_vel_2 black_vel_3
carvalhaes_suppes belendez""".split()
AMPLITUDES = """1e-300 1e-100 1e-08 0.001 0.1 0.03490658503988659 0.17453292519943295 0.3490658503988659 0.5235987755982988
0.7853981633974483 1.0471975511965976 1.3089969389957472 1.5707963267948966 1.8325957145940461 2.0943951023931953
2.356194490192345 2.6179938779914944 2.8797932657906435 3.0543261909900767 3.12413936106985 3.1315926535897933
3.1415916535897934 3.141592653588793 3.141592653589793 2.0""".split()


WORST = """small_angle bernoulli power_series_2 power_series_3 denman black_vel_2 black_vel_3 molina kidd_fogg
ganley_parwani cubic_force describing_function lima_arun cromer butikov two_term_log lima_2008 agm_a1 agm_b2
carvalhaes_suppes belendez agm_a3 agm_a4 agm_a5 chachiyo nome_one_root
pade_power_1 pade_power_2 pade_power_3 pade_power_5 pade_sin2_1 pade_sin2_2 pade_sin2_3 pade_sin2_5""".split()


def digits(x, count):
    return nstr(x, count, strip_zeros=False, min_fixed=-5, max_fixed=6)


def errors():
    mp.dps = 3200  # the smallest error, of belendez at 1e-300, is 1e-3008
    yield "# T/T0 by the formulas and formula/exact - 1 at exactly these f64 amplitudes theta0 (rad)."
    yield "# " + MADE_BY.format("mpmath, 3200 digits, AGM")
    yield "amplitude_rad,key,ratio,fractional_error"
    for text in AMPLITUDES:
        x = mpf(float(text))
        for key in TWELVE:
            yield f"{text},{key},{digits(FORMULAS[key](x), 40)},{digits(error(key, x), 50)}"


def error_quotients():
    mp.dps = 80
    yield "# |fractional error of the first formula/that of the second| at amplitudes in degrees."
    yield "# " + MADE_BY.format("mpmath, 80 digits, AGM")
    yield "degrees,first,second,quotient"
    b, c, d = "black_vel_3", "carvalhaes_suppes", "belendez"
    for degrees in (1, 5, 10, 20, 30, 45, 60, 75, 90, 105, 120, 135, 150, 165, 170, 175, 179):
        for first, second in ((b, c), (c, d), (b, d)):
            quotient = error(first, radians(mpf(degrees))) / error(second, radians(mpf(degrees)))
            yield f"{degrees},{first},{second},{nstr(abs(quotient), 12)}"


CLAIMS = """zero,denman,,
crossover,denman,black_vel_2,
crossover,denman,black_vel_3,
crossover,butikov,denman,
crossover,butikov,black_vel_3,
crossover,denman,carvalhaes_suppes,
crossover,denman,belendez,
crossover,butikov,carvalhaes_suppes,
crossover,butikov,belendez,
crossover,denman,power_series_3,
crossover,denman,power_series_2,
tolerance,denman,,1e-3
tolerance,black_vel_2,,1e-3
tolerance,black_vel_3,,1e-3
tolerance,small_angle,,1e-3
tolerance,bernoulli,,1e-3
tolerance,kidd_fogg,,1e-3
tolerance,molina,,1e-3
tolerance,carvalhaes_suppes,,1e-3
tolerance,belendez,,1e-3
tolerance,butikov,,1e-3
ratio,black_vel_3,belendez,100
ratio,carvalhaes_suppes,belendez,100
ratio,carvalhaes_suppes,belendez,10
crossover,kidd_fogg,bernoulli,
crossover,molina,bernoulli,"""


def condition(kind, first, second, value):
    """The function that vanishes at the claimed amplitudes."""
    if kind == "zero":
        return lambda x: error(first, x)
    if kind == "tolerance":
        return lambda x: abs(error(first, x)) - mpf(value)
    factor = mpf(value or 1)
    return lambda x: abs(error(first, x)) - factor * abs(error(second, x))


def zeros(f):
    """Every change of sign between points 0.01 rad apart, refined."""
    points = [mpf(i) / 100 for i in range(5, 315)]
    values = [f(x) for x in points]
    for i in range(len(points) - 1):
        if values[i] * values[i + 1] < 0:
            yield findroot(f, points[i : i + 2], solver="anderson", tol=mpf(10) ** -90)


def claims():
    mp.dps = 50
    yield "# Amplitudes (rad) at which an error is zero or of the given value, two are equal, or of the given ratio."
    yield "# " + MADE_BY.format("mpmath, 50 digits, findroot on formula/exact - 1")
    yield "kind,first,second,value,amplitude_rad"
    for claim in CLAIMS.splitlines():
        for amplitude in zeros(condition(*claim.split(","))):
            yield f"{claim},{nstr(amplitude, 30)}"


def worst_errors():
    mp.dps = 80
    yield "# The largest |formula/exact - 1| of the 360 amplitudes i/360, i = 1..360, of 90, 150 and 179 degrees."
    yield "# " + MADE_BY.format("mpmath, 80 digits, AGM")
    yield "key,to_90deg,to_150deg,to_179deg"
    for key in WORST:
        yield ",".join([key] + [nstr(worst(key, bound), 6) for bound in (90, 150, 179)])


def worst(key, bound):
    return max(abs(error(key, radians(mpf(bound) * i / 360))) for i in range(1, 361))


TABLES = {table.__name__: table for table in (errors, error_quotients, claims, worst_errors, series)}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in TABLES:
        sys.exit(f"give one table of: {', '.join(TABLES)}")
    for line in TABLES[sys.argv[1]]():
        print(line)

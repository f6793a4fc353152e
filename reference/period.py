"""tests/data/period.csv: T/T0, T/T0 - 1, the nome and the condition number, to 40 digits.

Run: python reference/period.py > crates/libration-testing/data/period.csv
"""
import math
import random

from mpmath import mp, mpf, nstr, pi, sin, cos

from elliptic import first, nome, second

mp.dps = 720  # complements of 1e-300 leave 100 digits and more
HEADER = """\
# T/T0 of the pendulum. Source: computed by reference/period.py (mpmath, 720 digits, AGM). Licence: MIT OR Apache-2.0.
# given: `amplitude` (theta0, rad) or `complement` (pi - theta0, rad); value_hex: that input, exactly this f64;
# ratio: T/T0; excess: T/T0 - 1; nome: q of k = sin(theta0/2); condition: (theta0/T) dT/dtheta0."""


def amplitudes():
    half_pi, top = math.pi / 2, math.pi
    hard = [0.0, 1e-300, 1e-150, 1e-100, 1e-20, 1e-8, 1e-4, 1e-3, 0.01, 0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.1, 3.14]
    hard += [math.radians(d) for d in (1, 5, 10, 20, 30, 45, 60, 75, 90, 105, 120, 135, 150, 160, 170, 175, 179, 179.9)]
    hard += [2.46309021118030, 2.78823112410720430, 3.1415, 3.14159, 3.141592, 3.1415926, 3.14159265, 3.14159265358]
    for x in (half_pi, 1.0, 2.0, 0.5, 0.25, top / 4, 3 * top / 4):
        hard += [math.nextafter(x, 0), x, math.nextafter(x, 4)]
    x = top  # fl(pi) is below pi
    for _ in range(6):
        hard.append(x)
        x = math.nextafter(x, 0)
    random.seed(1)
    hard += [top * random.random() for _ in range(120)]
    hard += [10 ** random.uniform(-9, 0) for _ in range(60)] + [10 ** random.uniform(-150, -9) for _ in range(20)]
    hard += [top - 10 ** random.uniform(-15, 0) for _ in range(60)]
    return sorted(set(hard + seam()))


def complements():
    random.seed(2)
    hard = [10.0**-n for n in (1, 2, 3, 6, 9, 12, 15, 16, 17, 20, 30, 50, 100, 150, 154, 155, 200, 250, 300)] + [2.0, 3.0, math.pi]
    hard += [10 ** random.uniform(-300, 0) for _ in range(60)] + [10 ** random.uniform(-20, 0.4) for _ in range(40)]
    hard += [5e-324, 1.5e-323, 1e-315, 1e-310, 2.2250738585072014e-308, 4.4e-308, 4.5e-308]
    return sorted(set(hard + seam()))


def seam():
    """Next to pi/2, where the period changes its expansion, from either side."""
    random.seed(3)
    chosen = [1.54, 1.57, 1.58, 1.6, 1.61] + [random.uniform(1.54, 1.61) for _ in range(40)]
    below = above = math.pi / 2
    for _ in range(8):
        below, above = math.nextafter(below, 0), math.nextafter(above, 2)
        chosen += [below, above]
    return chosen + WORST


# Found by the ledger: where errors of the period and its excess are largest within 0.1 of pi/2.
WORST = [
    1.5856140646997476, 1.5924752844642647, 1.5823036714601353, 1.8525657374535773, 1.5707963267949003, 1.5707963267947003,
    1.570796326794859, 1.5707963267948937, 1.549630644254244, 1.6209414836408274, 1.6143471347751024,
]  # fmt: skip


def row(given, value):
    theta = mpf(value) if given == "amplitude" else pi - mpf(value)
    delta = pi - theta if given == "amplitude" else mpf(value)
    k, kc = sin(theta / 2), sin(delta / 2)
    ratio = 2 / pi * first(k, kc)
    # dK/dk = (E - kc^2 K)/(k kc^2) and dk/dtheta0 = kc/2 (DLMF 19.4.1).
    slope = 0 if k == 0 else (second(k, kc) - kc**2 * first(k, kc)) / (k * kc) / pi
    q = 0 if k == 0 else nome(k, kc)
    numbers = [ratio, ratio - 1, q, theta * slope / ratio]
    return ",".join([given, float(value).hex()] + [nstr(mpf(x), 40) for x in numbers])


if __name__ == "__main__":
    print(HEADER)
    print("given,value_hex,ratio,excess,nome,condition")
    for x in amplitudes():
        print(row("amplitude", x))
    for x in complements():
        print(row("complement", x))

"""Compares reference/oracle.cpp with mpmath at 720 digits, on the oracle's own random inputs and on hard ones.

Run: python reference/check_oracle.py target/oracle [COUNT]
Prints, for every answer, the largest deviation in ulp of the f64 value beyond what the error of the phase explains:
2^-108 |u| for the Jacobi functions and 2^-62 |t| for motions (one that starts one ulp from the separatrix has its energy
above or below it to 60 bits), times the derivative. That is a thousandth of what the promises allow.
"""
import math
import struct
import subprocess
import sys

from mpmath import cos, cosh, mp, mpf, nstr, pi, sin, sqrt

from elliptic import first, incomplete_first, jacobi, nome, second
from motion import Motion

mp.dps = 720
SMALLEST = mpf(2) ** -1074  # answers are written as f64
WIDTHS = {"period": (3, 2), "excess": (3, 2), "complete": (3, 4), "incomplete": (4, 1), "jacobi": (4, 4), "motion": (5, 3), "harmonics": (4, 1)}


def modulus(kind, x):
    x = mpf(x)
    return [(sqrt(x), sqrt(1 - x)), (sqrt(1 - x), sqrt(x)), (x, sqrt(1 - x * x)), (sqrt(1 - x * x), x)][int(kind)]


def half_angles(kind, x):
    """k = sin(theta0/2) and k' of an amplitude or its complement."""
    x = mpf(x)
    return (sin(x / 2), cos(x / 2)) if kind == 0 else (cos(x / 2), sin(x / 2))


def true_answers(name, given):
    """[(answer, error allowed by the phase)]."""
    kind, x, *rest = given
    if name in ("period", "excess"):
        ratio = 2 / pi * first(*half_angles(kind, x))
        return [(ratio, 0), (ratio - 1, 0)]
    if name == "harmonics":
        k, kc = half_angles(kind, x)
        n = int(rest[0])
        return [((-1) ** (n // 2) * 4 / (n * cosh(n * pi * first(kc, k) / (2 * first(k, kc)))), 0)]
    if name == "motion":
        (b, time), motion = rest, Motion("complement" if kind else "angle", x, rest[0])
        angle, velocity, complement = motion.at(time)
        slack = abs(mpf(time)) * mpf(2) ** -62
        return [(angle, abs(velocity) * slack), (velocity, abs(sin(angle)) * slack), (complement, abs(velocity) * slack)]
    k, kc = modulus(kind, x)
    if name == "complete":
        return [(first(k, kc), 0), (second(k, kc), 0), (first(kc, k), 0), (nome(k, kc), 0)]
    u = mpf(rest[0])
    if name == "incomplete":
        return [(incomplete_first(u, k, kc), 0)]
    sn, cn, dn, am = jacobi(u, k, kc)
    slack = abs(u) * mpf(2) ** -108
    slopes = (abs(cn * dn), abs(sn * dn), abs(k * k * sn * cn), dn)
    return [(f, slope * slack) for f, slope in zip((sn, cn, dn, am), slopes)]


def hard_inputs(name):
    if name == "jacobi":
        for kc in (1e-300, 1e-160, 1e-20, 0.5, 1.0):
            quarter = float(first(*modulus(3, kc)))
            for n in (0.5, 1, 1.5, 2, 3, 1000001, 1000000):
                for u in (n * quarter, math.nextafter(n * quarter, 0), math.nextafter(n * quarter, math.inf)):
                    yield (3, kc, u)
    if name == "motion":
        for delta in (1e-300, 1e-20, 1e-3):
            for b in (0.0, delta, -delta, math.nextafter(delta, 0), math.nextafter(delta, 1)):
                for time in (0.0, 1.0, -100.0, 2000.0, 1e8):
                    yield (1, delta, b, time)


def records(oracle, name, count):
    width, answers = WIDTHS[name]
    typed = [(0, *given) for given in hard_inputs(name)]
    packed = b"".join(struct.pack(f"<{width}d", *given) for given in typed)
    hard = subprocess.run([oracle, name], input=packed, capture_output=True, check=True).stdout
    drawn = subprocess.run([oracle, name, str(count), "7"], capture_output=True, check=True).stdout
    size = width + 2 * answers
    for record in struct.iter_unpack(f"<{size}d", hard + drawn):
        yield record[1:width], [mpf(record[i]) + mpf(record[i + 1]) for i in range(width, size, 2)]


def ulp(x):
    return mpf(math.ulp(float(x)))


if __name__ == "__main__":
    oracle, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    for name, (_, answers) in WIDTHS.items():
        worst, total = [(mpf(0), None)] * answers, 0
        for given, got in records(oracle, name, count):
            total += 1
            for i, (value, (truth, slack)) in enumerate(zip(got, true_answers(name, given))):
                deviation = max(mpf(0), abs(value - truth) - slack - SMALLEST) / ulp(truth)
                worst[i] = max(worst[i], (deviation, given), key=lambda pair: pair[0])
        print(name, total, "  ".join(f"{nstr(d, 3)} at {g}" if d > 1e-4 else nstr(d, 3) for d, g in worst), flush=True)

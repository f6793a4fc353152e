"""tests/data/fourier.csv: Fourier coefficients of libration and rotation, to 40 digits.

The coefficients come from the trapezoidal sum of the exact motion over a period, not from the nome.
Run: python reference/fourier.py > crates/libration-testing/data/fourier.csv
"""
import math

from mpmath import asin, cos, mp, mpf, nstr, pi, sin, sqrt

from elliptic import first, jacobi

mp.dps = 130
SMALLEST = mpf(10) ** -14
HEADER = """\
# Harmonics of the pendulum, omega0 = 1. Source: computed by reference/fourier.py (mpmath, trapezoidal sum of the exact
# motion, which converges geometrically). Licence: MIT OR Apache-2.0.
# regime libration: value_hex = amplitude theta0 (rad), theta = sum angle_n cos(n Omega t), t from the turning point;
# regime libration-complement: value_hex = pi - theta0; regime rotation: value_hex = velocity at the bottom (rad/s),
# theta = Omega t + sum angle_n sin(n Omega t); fundamental = Omega (rad/s); angle = angle_n (rad), kept above 1e-14."""
NEAR_TOP = [1e-6, 1e-12, 1e-30]
AMPLITUDES = [0.001, math.radians(10), 0.5, 1.0, math.pi / 2, 2.0, math.radians(150), 3.0, math.radians(179), 3.14159]
ROTATIONS = [2.000001, 2.1, 3.0, 10.0]


def coefficients(angles, periodic):
    """(n, coefficient) from samples (phase, angle) over half a period; periodic is cos (odd n only) or sin."""
    n = 1
    step = 2 if periodic is cos else 1
    small = 0
    while small < 2 and n < len(angles) // 2:
        total = mpf(2) / len(angles) * sum(x * periodic(n * phase) for phase, x in angles)
        yield n, total
        small = small + 1 if abs(total) < SMALLEST else 0
        n += step


def samples(angle_at, half_period, points):
    """(phase, angle) at the midpoints of half a period."""
    middles = [mpf(2 * i + 1) / (2 * points) for i in range(points)]
    return [(pi * x, angle_at(half_period * x)) for x in middles]


def libration(delta):
    """Half the period, and the angle from the turning point: sin(theta/2) = k cd(t)."""
    k, kc = cos(delta / 2), sin(delta / 2)
    quarter = first(k, kc)
    return 2 * quarter, lambda t: 2 * asin(k * jacobi(t + quarter, k, kc)[0])


def rotation(velocity):
    """Half the turn time, and the periodic part of theta = 2 am(v t/2), whose modulus is 2/v."""
    k = 2 / velocity
    kc = sqrt((1 - k) * (1 + k))
    half_turn = 2 / velocity * first(k, kc)
    return half_turn, lambda t: 2 * jacobi(velocity * t / 2, k, kc)[3] - pi * t / half_turn


def rows(regime, value, delta):
    half_period, angle_at = rotation(mpf(value)) if regime == "rotation" else libration(delta)
    periodic, points = (sin if regime == "rotation" else cos), 200 + int(40 * half_period)
    for n, a in coefficients(samples(angle_at, half_period, points), periodic):
        if abs(a) >= SMALLEST:
            print(f"{regime},{float(value).hex()},{nstr(pi / half_period, 40)},{n},{nstr(a, 40)}")


if __name__ == "__main__":
    print(HEADER)
    print("regime,value_hex,fundamental,n,angle")
    for x in AMPLITUDES:
        rows("libration", x, pi - mpf(x))
    for x in NEAR_TOP:
        rows("libration-complement", x, mpf(x))
    for x in ROTATIONS:
        rows("rotation", x, None)

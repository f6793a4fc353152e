"""tests/data/action.csv: action and energy of motions in every regime, at ordinary and extreme frequencies, to 40 digits.

The action is the quadrature of the velocity over the angle, not a combination of complete integrals.
Run: python reference/action.py > crates/libration-testing/data/action.csv
"""
from mpmath import cos, mp, mpf, nstr, pi, quad, sin, sqrt

mp.dps = 60
HEADER = """\
# Action and energy of the pendulum per m l^2. Source: computed by reference/action.py (mpmath, 60 digits, quadrature of the
# velocity over the angle). Licence: MIT OR Apache-2.0. given: `amplitude` (rad, from rest), `complement` (pi - amplitude) or
# `ratio` (energy/2mgl, through the bottom); value_hex, omega_hex: that and omega0 (rad/s), exactly these f64; action: (1/2 pi)
# oint velocity d angle over a period of a libration, a turn of a rotation or the separatrix (rad^2/s); energy: E/(m l^2)."""
VALUES = [
    ("amplitude", 1e-160), ("amplitude", 1e-8), ("amplitude", 0.1), ("amplitude", 1.0), ("amplitude", 1.5707963267948966),
    ("amplitude", 1.5707963267948968), ("amplitude", 2.5), ("amplitude", 3.14159),
    ("complement", 1e-6), ("complement", 1e-20), ("complement", 1e-300),
    ("ratio", 5e-324), ("ratio", 1e-300), ("ratio", 0.5), ("ratio", 0.9999999999999999), ("ratio", 1.0),
    ("ratio", 1.0000000000000002), ("ratio", 1.5), ("ratio", 2.0), ("ratio", 1e3), ("ratio", 1e100), ("ratio", 1e300),
]  # fmt: skip
FREQUENCIES = [1.0, 3.7, 1e-290, 1e-160, 1e-150, 1e150, 1e154, 1e290]


def pieces():
    """Ends of pieces of [0, pi/2] that halve towards 0, where integrands turn sharply next to the separatrix."""
    return sorted({pi / 2 / 2**n for n in range(60)} | {mpf(0)})


def libration(k, kc):
    """(8/pi) k^2 int cos^2 p / sqrt(cos^2 p + kc^2 sin^2 p), from sin(theta/2) = k sin p; distances d = pi/2 - p."""
    integrand = lambda d: sin(d) ** 2 / sqrt(sin(d) ** 2 + (kc * cos(d)) ** 2) if d else mpf(0)
    return 8 / pi * k**2 * quad(integrand, pieces())


def rotation(energy):
    """(4/pi) int_0^(pi/2) sqrt(energy - sin^2 p) dp, p = theta/2."""
    return 4 / pi * quad(lambda d: sqrt((energy - 1) + sin(d) ** 2), pieces())


def action_and_ratio(given, value):
    x = mpf(value)
    if given == "ratio":
        return (libration(sqrt(x), sqrt(1 - x)) if x < 1 else rotation(x)), x
    k, kc = (sin(x / 2), cos(x / 2)) if given == "amplitude" else (cos(x / 2), sin(x / 2))
    return libration(k, kc), k**2


if __name__ == "__main__":
    print(HEADER)
    print("given,value_hex,omega_hex,action,energy")
    for given, value in VALUES:
        action, ratio = action_and_ratio(given, value)
        for omega in FREQUENCIES:
            cells = [given, float(value).hex(), omega.hex(), nstr(mpf(omega) * action, 40), nstr(2 * mpf(omega) ** 2 * ratio, 40)]
            print(",".join(cells))

"""Incomplete integrals next to multiples of a quarter turn, nomes of extreme moduli, Jacobi functions of extreme arguments.

Legendre's integrals come down the ladder of the arithmetic-geometric mean, as the library's do not; k and k' of a nome
from the plain theta series, without Jacobi's imaginary transformation.
Run: python reference/elliptic_seams.py TABLE > crates/libration-testing/data/elliptic_TABLE.csv   (TABLE: angles, nomes, arguments)
"""
import math
import sys

from mpmath import atan, mp, mpf, nint, nstr, pi, sin, sqrt, tan

from elliptic import first, jacobi, ladder, nome, second

mp.dps = 760  # k' = 1e-300 and angles of 1e300 leave 100 digits
HEADERS = {
    "angles": """\
# Legendre's incomplete integrals next to odd and even multiples of pi/2, and far out. Source: computed by
# reference/elliptic_seams.py (mpmath, 760 digits). Licence: MIT OR Apache-2.0. given: `m`, `kc` (k') or `k`; value_hex, phi_hex:
# modulus and angle (rad), exactly these f64; first: F(phi, k), second: E(phi, k).
given,value_hex,phi_hex,first,second""",
    "nomes": """\
# The nome of extreme moduli, and the moduli of extreme nomes. Source: computed by reference/elliptic_seams.py (mpmath, 760
# digits). Licence: MIT OR Apache-2.0. given: `k`, `kc` (k') or `q`, whose value_hex is exactly that f64; k, kc, q: all three.
given,value_hex,k,kc,q""",
    "arguments": """\
# Jacobi functions of very large, small and subnormal arguments, and of subnormal k'. Source: computed by
# reference/elliptic_seams.py (mpmath, 760 digits). Licence: MIT OR Apache-2.0. given: `m` or `kc` (k'); value_hex, u_hex: modulus
# and argument, exactly these f64.
given,value_hex,u_hex,sn,cn,dn,am""",
}


def modulus(given, value):
    x = mpf(value)
    return {"m": lambda: (sqrt(x), sqrt(1 - x)), "k": lambda: (x, sqrt(1 - x * x)), "kc": lambda: (sqrt(1 - x * x), x)}[given]()


def incomplete(phi, k, kc):
    """(F, E): phases doubled down the ladder; E = (E/K) F + sum c_n sin phi_n (Abramowitz & Stegun 17.6)."""
    a, b, c = ladder(k, kc)
    zeta = mpf(0)
    for n in range(len(a) - 1):
        tangent = tan(phi)
        phi += atan(b[n] / a[n] * tangent) + nint((phi - atan(tangent)) / pi) * pi
        zeta += c[n + 1] * sin(phi)
    f = phi / (mpf(2) ** (len(a) - 1) * a[-1])
    return f, second(k, kc) / first(k, kc) * f + zeta


def arguments():
    limit = 2.0**99 * math.pi / 2
    for given, value in [("m", 0.0), ("m", 1e-9), ("m", 0.3), ("m", 0.5), ("m", 0.7), ("m", 0.999999), ("kc", 1e-300)]:
        k, kc = modulus(given, value)
        small = neighbours(2.0**-27, 1) + [5e-324, 1e-323, -5e-324, 1e-320, 2.2250738585072014e-308, 1e-300, 1e-100, 1e-9]
        far = [1e7, 1e15, 6e18, -1e20, 3e22, 1e24, 1e26, 5e27, 6.2e27, 6.3e27, 1e28, -7e28, 3e29, 0.999 * limit]
        for u in small + far:
            yield [given, value.hex(), u.hex()] + [nstr(x, 40) for x in jacobi(mpf(u), k, kc)]
    for value in [1e-301, 1e-307, 1e-310, 1e-315, 1e-320, 5e-324]:
        k, kc = modulus("kc", value)
        for u in [1e-320, 1.0, 300.0, 700.0, 745.0, 1000.0, 1120.0, 1400.0, 1e5]:
            yield ["kc", value.hex(), u.hex()] + [nstr(x, 40) for x in jacobi(mpf(u), k, kc)]


def neighbours(x, reach):
    """x and a number of f64 to each side."""
    down, up = [x], [x]
    for _ in range(reach):
        down.append(math.nextafter(down[-1], -math.inf))
        up.append(math.nextafter(up[-1], math.inf))
    return sorted(set(down + up))


def angles():
    quarters = [1, 2, 3, 4, 5, 7, 11, 12, 99, 1001, 1000002, 2**40 + 1, 2**53 + 1]
    for given, value in [("kc", 1e-300), ("kc", 1e-8), ("m", 0.999), ("m", 0.5), ("k", 1e-3), ("kc", 1e-20)]:
        k, kc = modulus(given, value)
        near = [phi for n in quarters for phi in neighbours(float(n * pi / 2), 1)]
        for phi in near + [4.71238898038469, 17.27875959474386, -4.71238898038469, 1e16, math.nextafter(1e18, 0), 1e18, math.nextafter(1e18, 2e18), 1e22, 1e300]:
            yield [given, float(value).hex(), float(phi).hex()] + [nstr(x, 40) for x in incomplete(mpf(phi), k, kc)]


def moduli_of(q):
    """k = (theta2/theta3)^2, k' = (theta4/theta3)^2."""
    half, third, fourth, n, power = mpf(1), mpf(1), mpf(1), 1, q
    while power > mpf(10) ** (-mp.dps - 10):
        half += power * q**n
        third += 2 * power
        fourth += (-1) ** n * 2 * power
        n += 1
        power = q ** (n * n)
    return 4 * sqrt(q) * (half / third) ** 2, (fourth / third) ** 2


def nomes():
    for value in [1e-3, 1e-100, 1e-150, math.nextafter(1e-150, 1), 8.9e-161, 8e-161, 7e-161, 1e-161, 8.9e-162, 6.4e-162, 6.2e-162, 1e-200, 5e-324]:
        k, kc = modulus("k", value)
        yield ["k", value.hex()] + [nstr(x, 40) for x in (k, kc, nome(k, kc))]
    for value in [0.5, 1e-3, 1e-150, math.nextafter(1e-150, 0), 1e-300]:
        k, kc = modulus("kc", value)
        yield ["kc", value.hex()] + [nstr(x, 40) for x in (k, kc, nome(k, kc))]
    seam = float(mp.exp(-pi))
    for value in [5e-324, 1e-323, 1e-320, 1.1e-310, 2.2250738585072014e-308, 1e-300, 1e-150, 1e-8, 0.5, 0.9, 0.99, 0.9929] + neighbours(seam, 2):
        q = mpf(value)
        yield ["q", value.hex()] + [nstr(x, 40) for x in (*moduli_of(q), q)]


if __name__ == "__main__":
    table = sys.argv[1]
    print(HEADERS[table])
    for row in {"angles": angles, "nomes": nomes, "arguments": arguments}[table]():
        print(",".join(row))

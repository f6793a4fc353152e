"""Elliptic integrals and Jacobi functions to any precision, by the arithmetic-geometric mean in mpmath.

Every function takes the modulus k together with its complement kc, so that kc = 1e-300 is an ordinary
input. Callers set `mp.dps` to the digits they want plus twice the decimal exponents that occur.
References: Abramowitz & Stegun 16.4 (Jacobi functions), 17.6 (integrals); DLMF 19.8, 22.20.
"""
from mpmath import asin, atan, cos, exp, mp, mpf, nint, pi, sin, sqrt, tan


def ladder(k, kc):
    """The AGM of (1, kc): lists a, b, c with c[0] = k, until c is negligible."""
    a, b, c = [mpf(1)], [mpf(kc)], [mpf(k)]
    while abs(c[-1]) > mpf(10) ** (-mp.dps - 10):
        a_n, b_n = a[-1], b[-1]
        a.append((a_n + b_n) / 2)
        b.append(sqrt(a_n * b_n))
        c.append(c[-1] ** 2 / (4 * a[-1]))
    return a, b, c


def first(k, kc):
    """K."""
    return pi / (2 * ladder(k, kc)[0][-1])


def second(k, kc):
    """E = K (1 - sum 2^(n-1) c_n^2)."""
    a, _, c = ladder(k, kc)
    return pi / (2 * a[-1]) * (1 - sum(mpf(2) ** (n - 1) * c_n**2 for n, c_n in enumerate(c)))


def nome(k, kc):
    """q = exp(-pi K'/K)."""
    return exp(-pi * first(kc, k) / first(k, kc))


def incomplete_first(phi, k, kc):
    """F(phi, k): phases doubled down the ladder, tan(phi[n+1] - phi[n]) = (b/a) tan phi[n]."""
    a, b, _ = ladder(k, kc)
    for n in range(len(a) - 1):
        tangent = tan(phi)
        branch = nint((phi - atan(tangent)) / pi)
        phi += atan(b[n] / a[n] * tangent) + branch * pi
    return phi / (mpf(2) ** (len(a) - 1) * a[-1])


def jacobi(u, k, kc):
    """(sn, cn, dn, am) of u; the hyperbolic limits for kc = 0."""
    if kc == 0:
        am = 2 * atan(exp(u)) - pi / 2
        return sin(am), cos(am), cos(am), am
    a, _, c = ladder(k, kc)
    n = len(a) - 1
    phi = mpf(2) ** n * a[n] * u
    for i in range(n, 0, -1):
        phi = (phi + asin(c[i] / a[i] * sin(phi))) / 2
    sn, cn = sin(phi), cos(phi)
    return sn, cn, sqrt(kc**2 + (k * cn) ** 2), phi

"""Values of the functions by mpmath: nothing here was made by this library."""

import mpmath as mp
import numpy as np

mp.mp.dps = 60


def ulps(found, truth):
    """The error in units in the last place of the truth."""
    truth = mp.mpf(truth)
    if mp.isinf(truth):
        return 0 if found == truth else mp.inf
    return abs(mp.mpf(float(found)) - truth) / mp.mpf(float(np.spacing(abs(float(truth)))))


def ratio(amplitude):
    return 2 / mp.pi * mp.ellipk(mp.sin(mp.mpf(amplitude) / 2) ** 2)


def ratio_near_top(complement):
    return 2 / mp.pi * first(mp.sin(mp.mpf(complement) / 2))


def first(kp):
    """K by the arithmetic-geometric mean, which takes k' as it is."""
    return mp.pi / 2 / mp.agm(1, kp) if kp > 0 else mp.inf


def seconds(amplitude, length, gravity):
    return 2 * mp.pi * mp.sqrt(mp.mpf(length) / mp.mpf(gravity)) * ratio(amplitude)


def nome(kp):
    if kp == 0:
        return mp.mpf(1)
    if kp == 1:
        return mp.mpf(0)
    return mp.exp(-mp.pi * first(mp.sqrt(1 - kp * kp)) / first(kp))


def jacobi(u, m):
    u, m = mp.mpf(u), mp.mpf(m)
    if u == 0:
        return 0, 1, 1, 0
    if m == 1:
        return mp.tanh(u), mp.sech(u), mp.sech(u), 2 * mp.atan(mp.tanh(u / 2))
    sn, cn, dn = (mp.re(mp.ellipfun(name, u, m=m)) for name in ("sn", "cn", "dn"))
    half_turns = mp.nint(u / (2 * mp.ellipk(m)))
    return sn, cn, dn, half_turns * mp.pi + (-1) ** int(half_turns) * mp.asin(sn)


def motion(t, angle, velocity, omega0):
    """Angle and velocity; not on the separatrix."""
    t, angle, velocity, omega0 = map(mp.mpf, (t, angle, velocity, omega0))
    sign = -1 if velocity < 0 else 1
    angle, velocity = sign * angle, sign * velocity
    turns = mp.nint(angle / (2 * mp.pi))
    half = angle / 2 - turns * mp.pi
    k2 = mp.sin(half) ** 2 + (velocity / (2 * omega0)) ** 2
    k = mp.sqrt(k2)
    if k2 < 1:
        sn, cn, _, _ = jacobi(omega0 * t + mp.ellipf(mp.asin(mp.sin(half) / k), k2), k2)
        return sign * (2 * mp.asin(k * sn) + 2 * mp.pi * turns), sign * 2 * k * omega0 * cn
    _, _, dn, am = jacobi(k * omega0 * t + mp.ellipf(half, 1 / k2), 1 / k2)
    return sign * (2 * am + 2 * mp.pi * turns), sign * 2 * k * omega0 * dn

"""Reference angles: the pendulum in closed form, the driven one by its Taylor series in 25 digits."""
from elliptic import jacobi
from mpmath import asin, cos, factorial, fdot, mp, mpf, pi, sin


def pendulum_angle(start, end):
    """Released from rest: sin(theta/2) = k cd(t)."""
    half = mpf(start) / 2
    sn, cn, dn, _ = jacobi(mpf(end), sin(half), cos(half))
    return 2 * asin(sin(half) * cn / dn)


def driven_angle(start, end):
    """theta'' = 1.2 cos(2t/3) - sin theta - theta'/2, in steps so short that 30 powers of the time suffice."""
    with mp.workdps(25):
        angle, velocity = map(mpf, start)
        steps = int(8 * end) + 1
        h = mpf(end) / steps
        for step in range(steps):
            angle, velocity = after(angle, velocity, step * h, h)
        return angle


def after(angle, velocity, time, h, order=30):
    theta, rate, sine, cosine = [angle], [velocity], [sin(angle)], [cos(angle)]
    for n in range(order):
        drive = mpf(6) / 5 * (mpf(2) / 3) ** n * cos(2 * time / 3 + n * pi / 2) / factorial(n)
        theta.append(rate[n] / (n + 1))
        rate.append((drive - sine[n] - rate[n] / 2) / (n + 1))
        weighted = [k * theta[k] for k in range(1, n + 2)]
        sine.append(fdot(weighted, cosine[::-1]) / (n + 1))
        cosine.append(-fdot(weighted, sine[n::-1]) / (n + 1))
    powers = [h**n for n in range(order + 1)]
    return fdot(theta, powers), fdot(rate, powers)

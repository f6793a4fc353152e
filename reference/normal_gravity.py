"""Normal gravity of the Geodetic Reference System 1980 from its four defining constants (H. Moritz, Bull. Geod. 54, 395 (1980)): equatorial radius,
geocentric gravitational constant, dynamical form factor J2 and angular velocity. Flattening and gravity at equator and pole follow from these; gravity
on the ellipsoid is Somigliana's closed form, and above it the gradient of the exact potential in ellipsoidal coordinates.

    python reference/normal_gravity.py
prints the table of crates/libration-lab/tests/suite/fit/normal_gravity.rs.
"""

from mpmath import atan, cos, diff, findroot, mp, mpf, radians, sin, sqrt

mp.dps = 40
A, GM, J2, OMEGA = mpf(6378137), mpf("3986005e8"), mpf("108263e-8"), mpf("7292115e-11")


def q(e):
    """2 q0 at the second eccentricity e."""
    return (1 + 3 / e**2) * atan(e) - 3 / e


def of_eccentricity(e2):
    e = sqrt(e2)
    second = e / sqrt(1 - e2)
    return 3 * J2 + mpf(4) / 15 * OMEGA**2 * A**3 / GM * e**3 / q(second) - e2


E2 = findroot(of_eccentricity, mpf("0.00669438"))
B = A * sqrt(1 - E2)
LINEAR = sqrt(A**2 - B**2)


def potential(p, z):
    """The normal potential at a distance p from the axis and z from the equator: closed form in ellipsoidal coordinates u, beta."""
    square = p**2 + z**2 - LINEAR**2
    u = sqrt((square + sqrt(square**2 + 4 * LINEAR**2 * z**2)) / 2)
    sine = z / u
    half = lambda x: ((1 + 3 * x**2 / LINEAR**2) * atan(LINEAR / x) - 3 * x / LINEAR) / 2
    return (
        GM / LINEAR * atan(LINEAR / u)
        + OMEGA**2 * A**2 / 2 * half(u) / half(B) * (sine**2 - mpf(1) / 3)
        + OMEGA**2 * p**2 / 2
    )


def gravity(latitude, height):
    phi = radians(latitude)
    n = A / sqrt(1 - E2 * sin(phi) ** 2)
    p, z = (n + height) * cos(phi), (n * (1 - E2) + height) * sin(phi)
    slope = [diff(lambda t: potential(p + t, z), 0), diff(lambda t: potential(p, z + t), 0)]
    return sqrt(slope[0] ** 2 + slope[1] ** 2)


if __name__ == "__main__":
    print("1/f =", mp.nstr(1 / (1 - B / A), 15))
    for latitude in ["1e-20", 15, 30, "43.07", 45, 48, 60, 75, "89.9999999"]:
        for height in [0, 500, 3000]:
            print(f"({latitude}, {height}, {mp.nstr(gravity(mpf(latitude), mpf(height)), 12)}),")

"""Periods of pendulums with a bob of finite size, a rod, a support that yields, a knife edge that rolls, warmer than when their length was measured.

Independent of the library: moments of inertia by integration over horizontal slices (mpmath), periods as the lowest frequency of the linear equations
of motion for the displacement of the support and the angle, M q'' + K q = 0 with
    M = [[m, s], [s, i]],  K = [[stiffness, 0], [0, g (s + m rho)]]
for the whole mass m, its first moment s and moment of inertia i about the contact, and the radius rho of the edge that rolls on a plane.

    python reference/corrections.py
prints the cases of crates/libration-lab/tests/suite/fit/budget/corrections.rs.
"""

from mpmath import mp, mpf, pi, quad, sqrt

mp.dps = 30
G = mpf("9.81")


def gyration(shape, r, h=0, inner=0):
    """The moment of inertia about the horizontal axis through the centre of mass, over the mass."""
    if shape in ("disc", "ring"):
        # Rings about the horizontal axis of the disc.
        mass = quad(lambda s: 2 * pi * s, [inner, r])
        return quad(lambda s: 2 * pi * s**3, [inner, r]) / mass
    if shape == "gyration":
        return mpf(r) ** 2
    square, low, high = {
        "ball": (lambda z: r**2 - z**2, -r, r),
        "cap": (lambda z: r**2 - z**2, r - h, r),
        "cylinder": (lambda z: r**2 + 0 * z, 0, h),
    }[shape]
    mass = quad(lambda z: pi * square(z), [low, high])
    centre = quad(lambda z: pi * square(z) * z, [low, high]) / mass
    return quad(lambda z: pi * square(z) ** 2 / 4 + pi * square(z) * (z - centre) ** 2, [low, high]) / mass


def period(length, kappa, mass, rod=0, rod_length=0, stiffness=None, rho=0, warming=0):
    length, rod_length = [it * (1 + warming) for it in (length, mpf(rod_length))]
    whole = mass + rod
    first = mass * length + rod * rod_length / mpf(2)
    inertia = mass * (length**2 + kappa) + rod * rod_length**2 / 3
    torque = G * (first + whole * rho)
    if stiffness is None:
        return 2 * pi * sqrt(inertia / torque)
    # det(y K - M) = 0 for y = 1/omega^2, of which the larger root is that of the pendulum.
    square, linear = stiffness * torque, stiffness * inertia + whole * torque
    root = sqrt(linear**2 - 4 * square * (whole * inertia - first**2))
    return 2 * pi * sqrt((linear + root) / (2 * square))


CASES = {
    "ball": dict(length=mpf("0.6"), bob=("ball", mpf("0.05"))),
    "disc": dict(length=mpf("0.6"), bob=("disc", mpf("0.05"))),
    "cylinder": dict(length=mpf("0.6"), bob=("cylinder", mpf("0.03"), mpf("0.08"))),
    "ring": dict(length=mpf("0.6"), bob=("ring", mpf("0.05"), 0, mpf("0.03"))),
    "cap": dict(length=mpf("0.6"), bob=("cap", mpf("0.05"), mpf("0.03"))),
    "gyration": dict(length=mpf("0.6"), bob=("gyration", mpf("0.04"))),
    "support": dict(length=mpf("0.6"), stiffness=mpf(400)),
    "support and rod": dict(length=mpf("0.6"), rod=mpf("0.03"), rod_length=mpf("0.55"), stiffness=mpf(400)),
    "support and disc": dict(length=mpf("0.6"), bob=("disc", mpf("0.05")), stiffness=mpf(400)),
    "knife edge": dict(length=mpf("0.6"), rho=mpf("0.002")),
    "knife edge and rod": dict(length=mpf("0.6"), rod=mpf("0.03"), rod_length=mpf("0.55"), rho=mpf("0.002")),
    "temperature": dict(length=mpf("0.6"), warming=mpf("1.2e-5") * 5),
    "temperature and rod": dict(
        length=mpf("0.6"), rod=mpf("0.03"), rod_length=mpf("0.55"), warming=mpf("1.2e-5") * 5
    ),
    "all": dict(
        length=mpf("0.6"),
        bob=("cylinder", mpf("0.03"), mpf("0.08")),
        rod=mpf("0.03"),
        rod_length=mpf("0.55"),
        stiffness=mpf(400),
        rho=mpf("0.002"),
        warming=mpf("1.2e-5") * 5,
    ),
}

if __name__ == "__main__":
    for name, case in CASES.items():
        bob = case.pop("bob", None)
        kappa = gyration(*bob) if bob else mpf(0)
        print(f"{name:20} kappa = {mp.nstr(kappa, 17):24} T0 = {mp.nstr(period(kappa=kappa, mass=mpf('0.2'), **case), 17)}")

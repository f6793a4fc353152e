"""tests/data/symbolic_expansions.csv: perturbation series with letters, by SymPy.

Run: python reference/symbolic_expansions.py > crates/libration-testing/data/symbolic_expansions.csv

The whole ansatz is one polynomial in eps, z = exp(i tau) and its inverse, the letters, and, order by order, unknown numbers for the
next harmonics and the next frequency; it is put into the equation of motion as it stands, and what stands before eps^n z^k is solved.
No recurrence is written down. Needs: pip install sympy. Takes a second.
"""
from math import factorial

from sympy import QQ, ring

# In units of omega0: x'' W + x + force = 0. u is the inverse of omega0^2 in letters.
CASES = [
    # equation, letters, what u is in them (letter and power), order, force by x, x'^2 and W
    ("x'' + w^2*x + a*x^2 + b*x^3 = 0", "a b w", ("w", -2), 9, lambda x, v2, w, a, b, u: a * u * x**2 + b * u * x**3),
    ("x'' + k*x + b*x*x'^2 + c*x^3 = 0", "b c k", ("k", -1), 7, lambda x, v2, w, b, c, u: b * x * v2 * w + c * u * x**3),
    (
        "x'' + a*sin(k*x)/k = 0", "a k", ("a", -1), 9,
        lambda x, v2, w, k, u: sum((-1) ** j * k ** (2 * j) * x ** (2 * j + 1) * QQ(1, factorial(2 * j + 1)) for j in range(1, 5)),
    ),
]


def truncated(p, order):
    """Without powers of eps above the order."""
    return p.ring.from_dict({powers: c for powers, c in p.items() if powers[0] <= order})


class Powers:
    """A polynomial whose products are truncated at an order of eps."""

    def __init__(self, p, order):
        self.p, self.order = truncated(p, order), order

    def of(self, other):
        return other.p if isinstance(other, Powers) else other

    def __mul__(self, other):
        return Powers(self.p * self.of(other), self.order)

    def __add__(self, other):
        return Powers(self.p + self.of(other), self.order)

    def __pow__(self, n):
        found = self
        for _ in range(n - 1):
            found = found * self
        return found

    __rmul__, __radd__ = __mul__, __add__


def expansion(letters, inverse, order, force):
    """Omega^2/omega0^2 by powers of eps, and the harmonics {k: by powers of eps}, as polynomials in the letters and u."""
    others = [name for name in letters.split() if name != inverse[0]] + ["u"]
    whole, eps, z, y, *rest = ring(["eps", "z", "y", *others], QQ)
    x, w = eps * (z + y) * QQ(1, 2), whole.one
    harmonics, frequency = {1: {1: whole.one}}, {0: whole.one}
    for n in range(2, order + 1):
        slope = whole.from_dict({(e, k, m, *more): (k - m) * c for (e, k, m, *more), c in x.items()})
        bend = whole.from_dict({(e, k, m, *more): -((k - m) ** 2) * c for (e, k, m, *more), c in x.items()})
        one = lambda p: Powers(joined(p), n)
        # (i (z - y) ...)^2 = -(...)^2.
        v2 = one(slope) * one(slope) * QQ(-1)
        left = joined((one(bend) * one(w) + one(x) + force(one(x), v2, one(w), *rest)).p)
        found = {k: coefficient(left, n, k) for k in range(n + 1)}
        # A new W at order n - 1 adds -W/2 (z + y), a new harmonic a cos k tau adds (1 - k^2) a.
        frequency[n - 1] = found[1] * 2
        w += eps ** (n - 1) * frequency[n - 1]
        for k in [k for k in found if k != 1]:
            amount = found[k] * QQ(1 if k == 0 else 2, k * k - 1)
            harmonics.setdefault(k, {})[n] = amount
            x += eps**n * amount * (z**k + y**k) * QQ(1, 2)
    return frequency, harmonics


def joined(p):
    """The y with z y = 1."""
    found = {}
    for (e, k, m, *more), c in p.items():
        low = min(k, m)
        key = (e, k - low, m - low, *more)
        found[key] = found.get(key, 0) + c
    return p.ring.from_dict({key: c for key, c in found.items() if c})


def coefficient(p, n, k):
    return p.ring.from_dict({(0, 0, 0, *more): c for (e, i, m, *more), c in p.items() if (e, i, m) == (n, k, 0)})


def square_root(square, order):
    found = [square[0]]
    for n in range(1, order):
        found.append((square.get(n, 0) - sum(found[j] * found[n - j] for j in range(1, n))) * QQ(1, 2))
    return found


def terms(p, letters, inverse):
    """The powers of the letters, in their order, and the fraction of each term."""
    others = [name for name in letters if name != inverse[0]]
    found = []
    for (_, _, _, *powers), c in p.items():
        power = dict(zip(others, powers)) | {inverse[0]: inverse[1] * powers[-1]}
        found.append(" ".join(str(power[name]) for name in letters) + f" {c}")
    return "; ".join(sorted(found))


def main():
    print("# Expansions with letters in the gauge in which eps is the coefficient of cos tau. Source: reference/symbolic_expansions.py (SymPy).")
    print("# Licence: MIT OR Apache-2.0. quantity: Omega/omega0, or a harmonic. terms: for each the powers of the letters in the order of the")
    print("# alphabet and the fraction before them.")
    print("equation,quantity,power,terms")
    for equation, letters, inverse, order, force in CASES:
        square, harmonics = expansion(letters, inverse, order, force)
        series = {"frequency": dict(enumerate(square_root(square, order)))} | {f"cos {k}": it for k, it in sorted(harmonics.items())}
        for name, by_power in series.items():
            for power, p in sorted(by_power.items()):
                if p:
                    print(f'"{equation}",{name},{power},"{terms(p, letters.split(), inverse)}"')


main()

#!/usr/bin/env python3
"""Slow flows of weakly nonlinear, damped and driven oscillators at their lowest order, by SymPy.

    python reference/symbolic_slow_flow.py > crates/libration-testing/data/symbolic_slow_flow.csv

With constant A and phi the displacement x = A*cos(psi) + X is put into x'' + w0^2*x = f, psi = (q/p)*W*t + phi. X, without the frequency of psi, is
solved order by order. The first harmonic that is left over at the lowest order, C*cos(psi) + S*sin(psi) on the right side, gives
A' = -S/(2*w0) and A*phi' = -C/(2*w0) - (q/p)*A*(W - (p/q)*w0). Forces with abs and sign are integrated over half periods instead. Steady states are found
by Newton's method in (sigma, phi) for a given A, and the Jacobian of (A', phi') there by differentiation. No series of the library's kind is used: real
functions of time, no complex amplitude, and numbers by SymPy's evalf.
"""
import csv
import sys

import mpmath
import sympy as sp

A, phi, s, sigma, e, psi = sp.symbols("A phi s sigma e psi", real=True)
X, V = sp.symbols("x v")


def harmonics(expression):
    """The coefficients of exp(i*k*s), by k."""
    found = {}
    for term in sp.Add.make_args(sp.expand(expression.rewrite(sp.exp), power_exp=True, complex=False)):
        term = sp.powsimp(term, combine="exp")
        k, rest = 0, term
        for factor in sp.Mul.make_args(term):
            if isinstance(factor, sp.exp):
                slope = sp.expand(factor.exp).coeff(s, 1)
                if slope != 0:
                    k += slope / sp.I
                    rest = sp.powsimp(rest * sp.exp(-slope * s), combine="exp")
        found[k] = found.get(k, 0) + sp.expand(rest)
    return found


def lowest_order(force, w0, p, q, highest):
    """C and S of a force f(x, v, s, e) with powers of the bookkeeping letter e; x'' has the unit w0/q of ds/dt."""
    rate = w0 / q
    wave = A * sp.cos(q * s + phi)
    at_zero = force.subs({e: 0})
    for k, value in harmonics(at_zero).items():
        if k != 0 or value != 0:
            wave += sp.re(0) + value * sp.exp(sp.I * k * s) / (w0**2 - (k * rate) ** 2)
    for n in range(1, highest + 1):
        velocity = rate * sp.diff(wave, s)
        left = force.subs({X: wave, V: velocity}) - rate**2 * sp.diff(wave, s, 2) - w0**2 * wave
        left = sp.series(sp.expand(left), e, 0, n + 1).removeO().coeff(e, n)
        found = harmonics(left)
        first = sp.simplify(found.get(q, 0) * sp.exp(-sp.I * phi))
        if first != 0:
            # c*exp(i*psi) + conjugate = 2*Re(c)*cos(psi) - 2*Im(c)*sin(psi).
            real, imaginary = first.rewrite(sp.cos).expand(complex=False).as_real_imag()
            return n, sp.simplify(2 * real), sp.simplify(-2 * imaginary)
        for k, value in found.items():
            if abs(k) != q:
                wave += e**n * value * sp.exp(sp.I * k * s) / (w0**2 - (k * rate) ** 2)
    raise ValueError("no slow flow")


def kinked(force, w0):
    """C and S of a force of x and v with kinks, over the four quarters of a period."""
    here = force.subs({X: A * sp.cos(psi), V: -A * w0 * sp.sin(psi)})
    quarters = [(1, -1), (-1, -1), (-1, 1), (1, 1)]
    cosine = sine = 0
    for n, (of_x, of_v) in enumerate(quarters):
        ends = (psi, n * sp.pi / 2, (n + 1) * sp.pi / 2)
        own = here.subs({sp.Symbol("sx"): of_x, sp.Symbol("sv"): of_v})
        cosine += sp.integrate(sp.expand(own * sp.cos(psi)), ends) / sp.pi
        sine += sp.integrate(sp.expand(own * sp.sin(psi)), ends) / sp.pi
    return sp.simplify(cosine), sp.simplify(sine)


def letters(names):
    return sp.symbols(names, positive=True)


a, a2, a3, b, c, m, h, mu, F, R, w0, W = letters("a a2 a3 b c m h mu F R w0 W")
sx, sv = sp.symbols("sx sv")


def drive(p, sine=False):
    return sp.sin(p * s) if sine else sp.cos(p * s)


# Equation as the library reads it; resonance; small letters; force with orders in e, by the resonance's p and q; part with kinks.
E = sp.Symbol("e", real=True)
ROWS = [
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V - e*a*X**3 + e*F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*sin(W*t)", (1, 1), "", -2*e*mu*V - e*a*X**3 + e*F*drive(1, True), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^5 = eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V - e*a*X**5 + e*F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", (1, 3), "", -2*e*mu*V - e*a*X**3 + F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = F*cos(W*t)", (3, 1), "", -2*e*mu*V - e*a*X**3 + F*drive(3), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 = F*cos(W*t)", (1, 2), "", -2*e*mu*V - e*a*X**2 + F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^2 + eps*b*x^3 = F*cos(W*t)", (2, 1), "", -2*e*mu*V - e*a*X**2 - e*b*X**3 + F*drive(2), 0),
    ("x'' + 2*mu*x' + w0^2*x + a2*x^2 + a3*x^3 = F*cos(W*t)", (1, 1), "a2:1,a3:2,mu:2,F:2", -2*e**2*mu*V - e*a2*X**2 - e**2*a3*X**3 + e**2*F*drive(1), 0),
    ("x'' + 2*mu*x' + w0^2*sin(x) = F*cos(W*t)", (1, 1), "mu:2,F:2", -2*e**2*mu*V + e**2*w0**2*X**3/6 + e**2*F*drive(1), 0),
    ("x'' + 2*mu*x' + w0^2*sin(x) = R + F*cos(W*t)", (1, 1), "mu:2,F:2,R:1", -2*e**2*mu*V + e*R + e**2*w0**2*X**3/6 + e**2*F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + (w0^2 + eps*h*cos(W*t))*x + eps*a*x^3 = 0", (2, 1), "", -2*e*mu*V - e*h*X*drive(2) - e*a*X**3, 0),
    ("x'' + 2*mu*x' + (w0^2 + h*cos(W*t))*x + a*x^3 = 0", (1, 1), "h:1,mu:2,a:2", -2*e**2*mu*V - e*h*X*drive(1) - e**2*a*X**3, 0),
    ("x'' + 2*mu*x' + (w0^2 + h*cos(W*t))*sin(x) = 0", (2, 1), "mu:2,h:2", -2*e**2*mu*V - e**2*h*X*drive(2) + e**2*w0**2*X**3/6, 0),
    ("x'' + w0^2*x = eps*(m*(1 - x^2)*x' + F*cos(W*t))", (1, 1), "", e*m*(1 - X**2)*V + e*F*drive(1), 0),
    ("x'' + w0^2*x = eps*(m*(1 - x^2)*x' - b*x^3 + F*cos(W*t))", (1, 1), "", e*m*(1 - X**2)*V - e*b*X**3 + e*F*drive(1), 0),
    ("x'' + w0^2*x = eps*m*(1 - x^2)*x' + F*cos(W*t)", (3, 1), "", e*m*(1 - X**2)*V + F*drive(3), 0),
    ("x'' + w0^2*x = eps*(m*(x' - x'^3/3) + F*cos(W*t))", (1, 1), "", e*m*(V - V**3/3) + e*F*drive(1), 0),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*a*x*x'^2 = eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V - e*a*X*V**2 + e*F*drive(1), 0),
    ("x'' + eps*c*x'^3 + w0^2*x = eps*F*cos(W*t)", (1, 1), "", -e*c*V**3 + e*F*drive(1), 0),
    ("x'' + w0^2*x + eps*R*sign(x') = eps*F*cos(W*t)", (1, 1), "", e*F*drive(1), -R*sv),
    ("x'' + w0^2*x + eps*c*x'*abs(x') + eps*a*x^3 = eps*F*cos(W*t)", (1, 1), "", -e*a*X**3 + e*F*drive(1), -c*V**2*sv),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*b*x*abs(x) = eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V + e*F*drive(1), -b*X**2*sx),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*b*abs(x)*x' = eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V + e*F*drive(1), -b*X*V*sx),
    ("x'' + 2*eps*mu*x' + w0^2*x + eps*b*x'^2*abs(x') + eps*R*sign(x)= eps*F*cos(W*t)", (1, 1), "", -2*e*mu*V + e*F*drive(1), -b*V**3*sv - R*sx),
    ("x'' + 2*c*abs(x')*x' + w0^2*sin(x) = F*cos(W*t)", (1, 1), "c:1,F:2", e**2*w0**2*X**3/6 + e**2*F*drive(1), -2*c*V**2*sv),
]
VALUES = {a: "7/10", a2: "3/10", a3: "4/5", b: "3/5", c: "2/5", m: "3/4", h: "9/10", mu: "1/20", F: "1/2", R: "1/5", w0: "6/5"}
POINTS = ["1/50", "1/10", "1/2", "9/10", "3/2", "19/10", "5"]


def text(expression):
    return str(expression).replace("**", "^")


def main():
    print("# Slow flows at their lowest order: amplitude_rate is A', phase_rate A*phi' without detuning, with eps = 1.")
    print("# Steady states at the values: A, sigma, trace and determinant of the Jacobian of (A', phi').")
    print("# Source: reference/symbolic_slow_flow.py (SymPy), written for this project; same licence as the project.")
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow("equation resonance small order values amplitude_rate phase_rate steady".split())
    for equation, (p, q), small, force, kink in ROWS:
        order, cosine, sine = lowest_order(force, w0, p, q, 3)
        more = kinked(kink, w0) if kink != 0 else (0, 0)
        cosine, sine = cosine + more[0], sine + more[1]
        rates = sp.simplify(-sine / (2 * w0)), sp.simplify(-cosine / (2 * w0))
        used = sorted((letter for letter in VALUES if (force + kink).has(letter) or letter == w0), key=str)
        given = {**VALUES, F: "3"} if p > 1 else VALUES
        values = {letter: sp.Rational(given[letter]) for letter in used}
        steady = []
        full = rates[0].subs(values), (rates[1] / A - sp.Rational(q, p) * sigma).subs(values)
        for amplitude in POINTS:
            point = steady_state(full, sp.Rational(amplitude))
            if point is not None:
                steady.append(" ".join([amplitude] + [sp.N(it, 20).__str__() for it in point]))
        written = ",".join(f"{letter}={given[letter]}" for letter in used)
        row = [equation, f"{p}/{q}", small, str(order), written, text(rates[0]), text(rates[1]), ";".join(steady)]
        table.writerow(row)


def steady_state(rates, amplitude):
    """sigma, trace and determinant where both rates vanish; None where no phase is steady."""
    growth = sp.lambdify(phi, rates[0].subs(A, amplitude), "mpmath")
    mpmath.mp.dps = 40
    grid = [mpmath.mpf(n) * 2 * mpmath.pi / 720 + mpmath.mpf("0.001") for n in range(721)]
    for left, right in zip(grid, grid[1:]):
        if growth(left) * growth(right) < 0:
            root = mpmath.findroot(growth, (left, right), solver="anderson", tol=1e-60)
            place = {A: amplitude, phi: sp.Float(str(root), 40)}
            detuning = sp.solve(rates[1].subs(place), sigma)[0]
            jacobian = sp.Matrix(2, 2, [sp.diff(rate, by) for rate in rates for by in (A, phi)])
            jacobian = jacobian.subs({**place, sigma: detuning})
            return detuning, jacobian.trace(), jacobian.det()
    return None


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Successive turning points of damped oscillators, from first integrals.

    python reference/slow_flow.py > crates/libration-testing/data/slow_flow.csv

While x falls, x'' + c*x'*abs(x') + F(x) = 0 has the first integral x'^2*exp(-2*c*x) + 2*integral F(y)*exp(-2*c*y) dy, and
x'' + c*sign(x') + F(x) = 0 has x'^2/2 - c*x + V(x). Each takes the turning point A to the next one, -M(A), as a power series in A and c.
The flow dA/dpsi = g(A) that takes A to M(A) over a phase of pi is found order by order from exp(pi*g*d/dA) A = M(A); pi*g has rational
coefficients. No phase and no harmonic occurs, and no library but Python's fractions.
"""
from fractions import Fraction
from math import factorial

DEGREE, POWER = 11, 4  # of A and c
SHOWN = 6  # powers of A below this


def add(*sums):
    """Polynomials are dictionaries from (power of A, power of c) to coefficients."""
    total = {}
    for one in sums:
        for place, value in one.items():
            total[place] = total.get(place, 0) + value
    return {place: value for place, value in total.items() if value}


def times(a, b):
    total = {}
    for (i, j), x in a.items():
        for (k, l), y in b.items():
            if i + k <= DEGREE and j + l <= POWER:
                total[i + k, j + l] = total.get((i + k, j + l), 0) + x * y
    return {place: value for place, value in total.items() if value}


def scaled(a, factor):
    return {place: factor * value for place, value in a.items()}


def composed(outer, inner):
    """outer, a polynomial in A and c, at A = inner."""
    total, power = {}, {(0, 0): Fraction(1)}
    for i in range(DEGREE + 1):
        part = {(0, j): value for (k, j), value in outer.items() if k == i}
        total = add(total, times(power, part))
        power = times(power, inner)
    return total


def integral(a):
    return {(i + 1, j): Fraction(value, 1) / (i + 1) for (i, j), value in a.items() if i < DEGREE}


def slope(a):
    return {(i - 1, j): value * i for (i, j), value in a.items() if i}


def over_force(a, force):
    """a/F, both beginning with A."""
    quotient = {}
    for i in range(DEGREE):
        for j in range(POWER + 1):
            known = sum(quotient.get((i - k, j), 0) * force.get((k + 1, 0), 0) for k in range(1, i + 1))
            quotient[i, j] = (a.get((i + 1, j), Fraction(0)) - known) / force[1, 0]
    return {place: value for place, value in quotient.items() if value}


A = {(1, 0): Fraction(1)}


def drag(force):
    """The integral of the force between the turning points, with its weight, vanishes."""
    weight = {(j, j): Fraction((-2) ** j, factorial(j)) for j in range(POWER + 1)}
    work = integral(times(force, weight))
    return lambda image: add(composed(work, A), scaled(composed(work, scaled(image, -1)), -1))


def friction(force):
    """The potential energy lost between turning points is the work of friction."""
    potential = integral(force)
    way = lambda image: times(add(A, image), {(0, 1): Fraction(-1)})
    return lambda image: add(composed(potential, A), scaled(composed(potential, scaled(image, -1)), -1), way(image))


def next_turning_point(force, balance):
    image = dict(A)
    for power in range(1, POWER + 1):
        rest = over_force(balance(image), force)
        image = add(image, {(i, j): value for (i, j), value in rest.items() if j == power})
    return image


def flow(image):
    """pi*g with exp(pi*g*d/dA) A = image."""
    g = {}
    for power in range(1, POWER + 1):
        term, total = dict(A), dict(A)
        for k in range(1, power + 1):
            term = scaled(times(g, slope(term)), Fraction(1, k))
            total = add(total, term)
        rest = add(image, scaled(total, -1))
        g = add(g, {(i, j): value for (i, j), value in rest.items() if j == power})
    return g


spring = dict(A)
sine = {(i, 0): Fraction((-1) ** (i // 2), factorial(i)) for i in range(1, DEGREE + 1, 2)}
print("# Coefficients of dA/dpsi, times pi, where A is a turning point and psi grows by pi from one to the next.")
print("# By reference/slow_flow.py, in fractions from first integrals. MIT or Apache-2.0, as the project.")
print("equation,c_power,a_power,pi_times_coefficient")
for text, force, balance in [
    ("x'' + c*x'*abs(x') + x = 0", spring, drag(spring)),
    ("x'' + c*x'*abs(x') + sin(x) = 0", sine, drag(sine)),
    ("x'' + c*sign(x') + sin(x) = 0", sine, friction(sine)),
]:
    for (degree, power), value in sorted(flow(next_turning_point(force, balance)).items(), key=lambda it: it[0][::-1]):
        if degree < SHOWN:
            print(f"{text},{power},{degree},{value}")

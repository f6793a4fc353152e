"""The cases of series.py in the package `asymptotics` (its Lindstedt-Poincare method on SymPy), at the orders it reaches.

It takes x'' + x + eps f(x, x') with the displacement and velocity at the start. Its eps is the square of the amplitude here,
so order N is its order (N-1)/2; sin enters as the Taylor polynomial of that order. It gives the frequency in the
amplitude, but no series of the harmonics in it. It cannot be asked for a limit cycle: started at 2, as textbooks do, it is
not on Van der Pol's from the second order on.
"""
import contextlib
import io
from importlib.metadata import version
from math import factorial

from asymptotics import ODE

VERSION = f"asymptotics {version('asymptotics')}"
PENDULUM = ["u(0) = 1", "u'(0) = 0"]


def last_frequency(equation, start, order):
    with contextlib.redirect_stdout(io.StringIO()):
        problem = ODE(equation, dependent="u", small_param="eps", independent="t", conditions=start)
        omega = problem.expand_lindstedt(order=order).omega_expansion
    eps = next(iter(omega.free_symbols))
    return omega, (omega.coeff(eps, order), None)


def pendulum(order):
    steps = (order - 1) // 2
    sine = "".join(f" {'-' if k % 2 else '+'} eps**{k}*u**{2 * k + 1}/{factorial(2 * k + 1)}" for k in range(1, steps + 1))
    return last_frequency("u'' + u" + sine, PENDULUM, steps)


def duffing(order):
    return last_frequency("u'' + u + eps*u**3", PENDULUM, (order - 1) // 2)


def van_der_pol(order):
    return last_frequency("u'' + u - eps*(1-u**2)*u'", ["u(0) = 2", "u'(0) = 0"], order)


CASES = {"pendulum, full answer": pendulum, "duffing, full answer": duffing, "van_der_pol": van_der_pol}

"""Changes of motions with parameters and initial values: python reference/sensitivities.py > crates/libration-testing/data/sensitivities.csv

Central differences of motions by extrapolation of the midpoint rule (extrapolation.py) in mpmath floats of 60 digits, each step refined
until two columns agree to 1e-50; shifts of 1e-14 err by 1e-28 of the third derivative. Needs: pip install mpmath. Takes a minute.
"""
from mpmath import mp, mpf, nstr, sin

from extrapolation import Extrapolation

mp.dps = 60
STEPS = Extrapolation(tolerance=mpf("1e-50"), columns=34)
SHIFT = mpf("1e-14")

HEADER = """\
# How motions change with parameters and initial values. Source: reference/sensitivities.py (central differences of motions by the
# extrapolated midpoint rule, 60 digits). Licence: MIT OR Apache-2.0. values: of the parameters, exact f64. start: coordinates, then
# velocities, at t = 0. to: a parameter or a number of the state, whose initial value is changed. derivatives: of the numbers of the state,
# 24 digits.
equation,values,start,time,to,derivatives"""


def pendulum(p, t, s):
    omega, c = p
    theta, v = s
    return [v, -omega * omega * sin(theta) - c * v * abs(v)]


def lorenz(p, t, s):
    sigma, rho, beta = p
    x, y, z = s
    return [sigma * (y - x), x * (rho - z) - y, x * y - beta * z]


def thermostat(p, t, s):
    (k,) = p
    x, z, v = s
    return [v, v * v - k, -x - z * v]


# equation, names of parameters, their values, names of the state, start, times, step
CASES = [
    (
        "theta'' = -omega^2*sin(theta) - c*theta'*abs(theta')",
        pendulum,
        "omega c",
        "1.25 0.125",
        "theta theta'",
        "2 0.5",
        ["1", "10"],
    ),
    (
        "x' = sigma*(y - x); y' = x*(rho - z) - y; z' = x*y - beta*z",
        lorenz,
        "sigma rho beta",
        "10 28 2.5",
        "x y z",
        "1 1 1",
        ["0.5", "5"],
    ),
    ("x'' = -x - z*x'; z' = x'^2 - k", thermostat, "k", "1.5", "x z x'", "0.5 0.25 1.5", ["1", "10"]),
]


def end(f, parameters, start, time):
    """The state at a time; a kink of |v| at v = 0 is met by a step that ends there."""
    t, y = mpf(0), start
    rate = lambda t, s: f(parameters, t, s)
    while t < time:
        length = min(mpf("0.0625"), time - t)
        after = STEPS.advance(rate, t, y, length)
        if f is pendulum and y[1] * after[1] < 0:
            length, after = to_turn(rate, t, y, length)
        t, y = t + length, after
    return y


def to_turn(rate, t, y, length):
    """The step to where the velocity vanishes, which is just passed."""
    for _ in range(12):
        after = STEPS.advance(rate, t, y, length)
        length -= after[1] / rate(t + length, [after[0], mpf(0)])[1]
    after = STEPS.advance(rate, t, y, length)
    return length, [after[0], mpf(0)]


def rows(equation, f, names, values, state, start, times):
    parameters = [mpf(word) for word in values.split()]
    begin = [mpf(word) for word in start.split()]
    for time in times:
        for place, name in enumerate(names.split() + state.split()):

            def moved(by):
                numbers = parameters + begin
                numbers[place] += by
                return end(f, numbers[: len(parameters)], numbers[len(parameters) :], mpf(time))

            difference = [(a - b) / (2 * SHIFT) for a, b in zip(moved(SHIFT), moved(-SHIFT))]
            derivatives = " ".join(nstr(x, 24) for x in difference)
            yield f'"{equation}",{values},{start},{time},{name},{derivatives}'


def main():
    print(HEADER)
    for case in CASES:
        for row in rows(*case):
            print(row, flush=True)


if __name__ == "__main__":
    main()

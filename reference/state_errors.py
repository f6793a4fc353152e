"""Chaotic and regular motions by 40-digit integration: python reference/state_errors.py > crates/libration-testing/data/state_errors.csv

By Taylor series of order 50 in 220 bits (python-flint). Picard's iteration makes the series: each integration of the right-hand sides
adds one power. A step is as long as the last two coefficients allow for an error of 1e-42. The samples end where a second run, of order
36 in 160 bits to 1e-30, differs by 1e-10 of the largest size so far; 25 digits of the first are written. Decimals are exact; starts are
doubles. Needs: pip install python-flint. Takes about ten minutes on two cores.
"""
import ast
import re
import sys
from multiprocessing import Pool

from flint import arb, arb_series, ctx, fmpq

DOUBLE = (
    "theta1'' = (-3*sin(theta1) - sin(theta1 - 2*theta2) - 2*sin(theta1 - theta2)*(theta2'^2 + theta1'^2*cos(theta1 - theta2)))"
    "/(3 - cos(2*theta1 - 2*theta2)); "
    "theta2'' = 2*sin(theta1 - theta2)*(2*theta1'^2 + 2*cos(theta1) + theta2'^2*cos(theta1 - theta2))/(3 - cos(2*theta1 - 2*theta2))"
)
SPRING = "r'' = r*theta'^2 + cos(theta) - {k}*(r - 1); theta'' = (-sin(theta) - 2*r'*theta')/r"
DRIVEN = "theta'' = -sin(theta) - {c}*theta' + {a}*cos({w}*t)"
DUFFING = "x'' = x - x^3 - {c}*x' + {a}*cos({w}*t)"
HENON = "x'' = -x - 2*x*y; y'' = -y - x^2 + y^2"
LORENZ = "x' = 10*(y - x); y' = x*({rho} - z) - y; z' = x*y - 8/3*z"
POL = "x'' = {mu}*(1 - x^2)*x' - x"
DRIVEN_POL = "x'' = {mu}*(1 - x^2)*x' - x + {a}*cos({w}*t)"
ROESSLER = "x' = -y - z; y' = x + y/5; z' = 1/5 + z*(x - 5.7)"
KEPLER = "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)"
PENDULUM = "theta'' = -sin(theta)"

# name, equations, start, tolerance, step and number of the times
RUNS = [
    ("double 2 2", DOUBLE, "2 2 0 0", 1e-12, 2, 40),
    ("double 1 1", DOUBLE, "1 1 0 0", 1e-12, 2, 40),
    ("double 0.5 0.25", DOUBLE, "0.5 0.25 0 0", 1e-12, 2, 40),
    ("double 3 0", DOUBLE, "3 0 0 0", 1e-12, 2, 40),
    ("double 2.5 -1", DOUBLE, "2.5 -1 0 0", 1e-15, 2, 40),
    ("double 1.5 1.75", DOUBLE, "1.5 1.75 0 0", 1e-9, 2, 40),
    ("double 0 3", DOUBLE, "0 3 0 0", 1e-12, 2, 40),
    ("double turning", DOUBLE, "0 0 3 1", 1e-12, 2, 40),
    ("double small", DOUBLE, "0.0625 -0.125 0 0", 1e-6, 2, 40),
    ("spring 4", SPRING.format(k=4), "1.25 0.5 0 0", 1e-12, 5, 40),
    ("spring 3", SPRING.format(k=3), "1.5 1.25 0 0", 1e-12, 5, 40),
    ("spring chaotic", SPRING.format(k=4), "1.25 2 0 0", 1e-12, 5, 40),
    ("spring 6.5", SPRING.format(k="6.5"), "1.25 1.5 0 0", 1e-9, 5, 40),
    ("spring wild", SPRING.format(k=5), "1 2.75 0 0", 1e-12, 3, 40),
    ("driven 1.2", DRIVEN.format(c="0.5", a="1.2", w="2/3"), "0.25 0", 1e-12, 5, 40),
    ("driven 1.5", DRIVEN.format(c="0.5", a="1.5", w="2/3"), "0.25 0", 1e-12, 5, 40),
    ("driven 1.15", DRIVEN.format(c="0.5", a="1.15", w="2/3"), "0.25 0", 1e-15, 5, 40),
    ("driven periodic", DRIVEN.format(c="0.1", a="0.15", w="0.82"), "0.5 0", 1e-12, 10, 40),
    ("driven weak", DRIVEN.format(c="0.01", a="0.1", w="0.7"), "1 0", 1e-9, 20, 40),
    ("driven undamped", DRIVEN.format(c="0", a="0.5", w="1.1"), "1 0", 1e-12, 5, 40),
    ("driven loose", DRIVEN.format(c="0.2", a="0.4", w="0.9"), "1 0", 1e-6, 10, 40),
    ("duffing chaotic", DUFFING.format(c="0.25", a="0.3", w="1"), "0.5 0", 1e-12, 5, 40),
    ("duffing Ueda", "x'' = -x^3 - 0.05*x' + 7.5*cos(t)", "3 4", 1e-12, 3, 40),
    ("duffing two wells", DUFFING.format(c="0.15", a="0.3", w="1"), "1 0.5", 1e-12, 5, 40),
    ("duffing free", DUFFING.format(c="0", a="0", w="1"), "1.5 0", 1e-12, 10, 40),
    ("duffing saddle", DUFFING.format(c="0", a="0", w="1"), "1.4140625 0", 1e-12, 5, 40),
    ("duffing hard", "x'' = -x - 0.1*x^3", "3 0", 1e-15, 20, 40),
    ("duffing loose", "x'' = -x - 0.1*x^3", "3 0", 1e-6, 10, 40),
    ("henon 1/12", HENON, "0 0.1 0.375 0", 1e-12, 10, 40),
    ("henon chaotic", HENON, "0 -0.25 0.46875 0", 1e-12, 10, 40),
    ("henon 1/6", HENON, "0.125 0.125 0.375 0.375", 1e-12, 10, 40),
    ("henon near edge", HENON, "0 0.5 0.375 0", 1e-9, 5, 40),
    ("lorenz 28", LORENZ.format(rho=28), "1 1 1", 1e-12, 1, 40),
    ("lorenz 28 loose", LORENZ.format(rho=28), "1 1 20", 1e-6, 1, 40),
    ("lorenz 28 sharp", LORENZ.format(rho=28), "-8 7 27", 1e-16, 1, 40),
    ("lorenz 160", LORENZ.format(rho=160), "1 1 100", 1e-12, 1, 40),
    ("lorenz 14", LORENZ.format(rho=14), "1 1 1", 1e-12, 2, 40),
    ("lorenz transient", LORENZ.format(rho=22), "1 1 1", 1e-12, 1, 40),
    ("pol 1", POL.format(mu=1), "0.5 0", 1e-12, 5, 40),
    ("pol 5", POL.format(mu=5), "2 0", 1e-12, 5, 40),
    ("pol 20", POL.format(mu=20), "2 0", 1e-9, 5, 40),
    ("pol weak", POL.format(mu="0.1"), "0.125 0", 1e-12, 5, 40),
    ("pol driven", DRIVEN_POL.format(mu=5, a=5, w="2.463"), "1 0", 1e-12, 5, 40),
    ("pol locked", DRIVEN_POL.format(mu=1, a=1, w="1.1"), "1 0", 1e-12, 5, 40),
    ("roessler", ROESSLER, "1 1 0", 1e-12, 10, 40),
    ("roessler loose", ROESSLER, "-4 0 0.5", 1e-6, 5, 40),
    ("kepler 0.5", KEPLER, "1 0 0 0.75", 1e-12, 10, 40),
    ("kepler 0.9", KEPLER, "1 0 0 0.3125", 1e-12, 1, 40),
    ("pendulum 3", PENDULUM, "3 0", 1e-12, 10, 40),
    ("pendulum 3.140625", PENDULUM, "3.140625 0", 1e-12, 5, 40),
    ("pendulum rotating", PENDULUM, "0 2.0625", 1e-12, 10, 40),
    ("pendulum near edge", PENDULUM, "0 2.000030517578125", 1e-12, 5, 40),
    ("pendulum long", PENDULUM, "2 0", 1e-12, 25, 40),
    ("linear", "x'' = -x", "1 0", 1e-12, 10, 40),
    ("stiff", "x' = -50*(x - cos(t))", "0 ", 1e-12, 1, 40),
    ("growing", "x'' = x - 0.25*x'", "1 -1", 1e-12, 1, 40),
    ("parametric", "x'' = -(1 + 0.4*cos(2*t))*x - 0.1*x^3", "0.5 0", 1e-12, 5, 40),
    ("coupled", "x'' = -sin(x) + 0.1*(y - x); y'' = -sin(y) + 0.1*(x - y)", "2 -1 0 0", 1e-12, 5, 40),
    ("three", "x'' = y - 2*x - x^3; y'' = x - 2*y + z - y^3; z'' = y - 2*z - z^3", "1 -2 2.5 0 0 0", 1e-12, 5, 40),
    ("prey", "x' = x - x*y; y' = x*y - y", "4 0.5", 1e-12, 5, 40),
]


class Exact(ast.NodeTransformer):
    """Decimals as fractions."""

    def visit_Constant(self, node):
        return ast.parse(f"Q({str(node.value)!r})", mode="eval").body

    def visit_BinOp(self, node):
        if isinstance(node.op, ast.Pow):
            exponent = eval(compile(ast.Expression(node.right), "", "eval"), {})
            half = ast.Constant(int(round(2 * exponent)))
            call = ast.parse("power(0, 0)", mode="eval").body
            call.args = [self.visit(node.left), half]
            return call
        return self.generic_visit(node)


def Q(text):
    whole, _, part = text.partition(".")
    return arb(fmpq(int(whole + part), 10 ** len(part)))


def power(base, halves):
    root = base if halves % 2 == 0 else base.sqrt()
    count = halves // 2 if halves % 2 == 0 else halves
    result = root
    for _ in range(count - 1):
        result = result * root
    return result


def constant(value):
    return value if isinstance(value, arb_series) else arb_series([value])


FUNCTIONS = {
    "Q": Q,
    "power": power,
    "sin": lambda x: constant(x).sin(),
    "cos": lambda x: constant(x).cos(),
}


class Motion:
    def __init__(self, equations, start):
        sides = [equation.split("=") for equation in equations.split(";")]
        names = [re.match(r"\s*(\w+)('+)", left).groups() for left, _ in sides]
        self.second = [len(primes) == 2 for _, primes in names]
        self.names = [name for name, _ in names]
        self.state_names = self.names + [f"{n}_p" for n, second in zip(self.names, self.second) if second]
        formulas = [right.strip().replace("^", "**").replace("'", "_p") for _, right in sides]
        trees = [Exact().visit(ast.parse(formula, mode="eval")) for formula in formulas]
        self.formulas = [compile(ast.fix_missing_locations(tree), "", "eval") for tree in trees]
        self.start = [float(value) for value in start.split()]
        velocities = iter(range(len(self.names), len(self.state_names)))
        self.velocity = [next(velocities) if second else None for second in self.second]
        self.driven = [self.velocity[i] if self.second[i] else i for i in range(len(self.names))]

    def rates(self, series, t):
        values = dict(zip(self.state_names, series), t=t)
        rates = [None] * len(series)
        for i, formula in enumerate(self.formulas):
            rates[self.driven[i]] = constant(eval(formula, FUNCTIONS, values))
            if self.second[i]:
                rates[i] = series[self.velocity[i]]
        return rates

    def series(self, state, t0, order):
        series = [arb_series([value], prec=1) for value in state]
        for n in range(1, order + 1):
            ctx.cap = n
            series = [arb_series(list(s.coeffs()), prec=n) for s in series]
            rates = self.rates(series, arb_series([t0, 1], prec=n))
            ctx.cap = n + 1
            series = [
                arb_series([y] + [(rate[k]).mid() / (k + 1) for k in range(n)], prec=n + 1)
                for y, rate in zip(state, rates)
            ]
        return series

    def states(self, times, order, bits, tolerance):
        ctx.prec = bits
        tolerance = arb(tolerance)
        state, t = [arb(value) for value in self.start], arb(0)
        for time in times:
            goal = arb(time)
            while t < goal:
                series = self.series(state, t, order)
                length = goal - t
                for s in series:
                    for n in (order - 1, order):
                        size = abs(s[n]).mid()
                        if size > 0:
                            length = min(length, ((tolerance / size).log() / n).exp().mid(), key=float)
                state = [self.value(s, length, order) for s in series]
                t = goal if float(length) == float(goal - t) else (t + length).mid()
            yield [value.mid() for value in state]

    @staticmethod
    def value(series, h, order):
        total = arb(0)
        for n in range(order, -1, -1):
            total = (total * h + series[n]).mid()
        return total


def lines(run):
    name, equations, start, tolerance, step, count = run
    motion = Motion(equations, start)
    times = [step * n for n in range(1, count + 1)]
    found = []
    runs = zip(list(motion.states(times, 50, 220, "1e-42")), list(motion.states(times, 36, 160, "1e-30")))
    sizes = [0.0] * len(motion.state_names)
    sizes = [max(size, abs(value)) for size, value in zip(sizes, motion.start)]
    for time, (state, other) in zip(times, runs):
        ctx.prec = 220
        sizes = [max(size, abs(float(value))) for size, value in zip(sizes, state)]
        if any(float(abs(a - b)) > 1e-10 * size for a, b, size in zip(state, other, sizes)):
            break
        state = " ".join(value.str(25, radius=False) for value in state)
        found.append(f'{name},"{equations}",{" ".join(start.split())},{tolerance:g},{time},{state}')
    print(name, len(found), file=sys.stderr)
    return found


if __name__ == "__main__":
    print("# Chaotic and regular motions. Source: reference/state_errors.py (Taylor series to 1e-42 in 220 bits; a run to 1e-30 agrees to 1e-10).")
    print("# Licence: MIT OR Apache-2.0. start: coordinates, then velocities, at t = 0, as doubles;")
    print("# decimals in the equations are exact. tolerance: that of the integration that is tested. state: 25 digits.")
    print("run,equations,start,tolerance,time,state")
    with Pool(2) as pool:
        for found in pool.imap(lines, RUNS):
            print("\n".join(found), flush=True)

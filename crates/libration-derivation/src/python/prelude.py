# What the cells below compute with: Python's own fractions and floats, and nothing else.
import math
from fractions import Fraction as Q
from itertools import count
from math import pi, radians


class Series:
    """A power series in one small variable, its coefficients known up to some power."""

    def __init__(self, coefficients):
        self.c = list(coefficients)

    def __len__(self):
        return len(self.c)

    def __add__(self, other):
        other = series(other, len(self))
        return Series(a + b for a, b in zip(self.c, other.c))

    def __neg__(self):
        return Series(-a for a in self.c)

    def __sub__(self, other):
        return self + -series(other, len(self))

    def __rsub__(self, other):
        return series(other, len(self)) - self

    def __mul__(self, other):
        if hasattr(other, "wave") or hasattr(other, "times") or hasattr(other, "cosine"):
            return NotImplemented
        other = series(other, len(self))
        n = min(len(self), len(other))
        return Series(sum((self.c[i] * other.c[k - i] for i in range(k + 1)), Q(0)) for k in range(n))

    def __truediv__(self, other):
        a, b = list(self.c), list(series(other, len(self)).c)
        while b and b[0] == 0:
            if a[:1] != [0]:
                raise ZeroDivisionError("the quotient is not a power series")
            a, b = a[1:], b[1:]
        quotient = []
        for k in range(min(len(a), len(b))):
            known = sum((quotient[i] * b[k - i] for i in range(k)), Q(0))
            quotient.append((a[k] - known) / exact(b[0]))
        return Series(quotient)

    def __rtruediv__(self, other):
        return series(other, len(self)) / self

    def __pow__(self, n):
        result = series(1, len(self))
        for _ in range(n):
            result = result * self
        return result

    __radd__, __rmul__ = __add__, __mul__


def exact(x):
    return Q(x) if isinstance(x, int) else x


def series(x, terms):
    return x if isinstance(x, Series) else Series([exact(x)] + [Q(0)] * (terms - 1))


def variable(terms):
    return Series([Q(0), Q(1)] + [Q(0)] * (terms - 2))


def O(x):
    """Terms left out: a series known up to them, and nothing for numbers."""
    if isinstance(x, Series):
        first = next((k for k, a in enumerate(x.c) if a != 0), len(x))
        return Series([Q(0)] * first)
    return 0


def integrated(x, start):
    return Series([start] + [a / (k + 1) for k, a in enumerate(x.c)][:-1])


def derived(x):
    return Series([k * a for k, a in enumerate(x.c)][1:] + [Q(0)])


def at_zero(function, x, values):
    """The function where the series begins: exactly there, else in floats."""
    return values[x.c[0]] if x.c[0] in values else function(float(x.c[0]))


def by_equation(x, start, slope):
    """y with y' = slope(y) x', coefficient by coefficient."""
    y = Series([start] + [Q(0)] * (len(x) - 1))
    for k in range(1, len(x)):
        y.c[k] = integrated(slope(y) * derived(x), start).c[k]
    return y


def sine_and_cosine(x):
    sine = Series([at_zero(math.sin, x, {0: Q(0)})] + [Q(0)] * (len(x) - 1))
    cosine = Series([at_zero(math.cos, x, {0: Q(1)})] + [Q(0)] * (len(x) - 1))
    rate = derived(x)
    for k in range(1, len(x)):
        s, c = (cosine * rate).c[k - 1] / k, (sine * rate).c[k - 1] / k
        sine.c[k], cosine.c[k] = s, -c
    return sine, cosine


def sin(x):
    if hasattr(x, "wave"):
        return x.wave(1)
    if hasattr(x, "sine"):
        return x.sine()
    return sine_and_cosine(x)[0] if isinstance(x, Series) else math.sin(x)


def cos(x):
    if hasattr(x, "cosine"):
        return x.cosine()
    if hasattr(x, "wave"):
        return x.wave(0)
    return sine_and_cosine(x)[1] if isinstance(x, Series) else math.cos(x)


def sign(x):
    return (x > 0) - (x < 0)


def tan(x):
    return sin(x) / cos(x)


def exp(x):
    if isinstance(x, Series):
        return by_equation(x, at_zero(math.exp, x, {0: Q(1)}), lambda y: y)
    return math.exp(x)


def ln(x):
    if isinstance(x, Series):
        return integrated(derived(x) / x, at_zero(math.log, x, {1: Q(0)}))
    return math.log(x)


def sinh(x):
    return (exp(x) - exp(-x)) / 2


def cosh(x):
    return (exp(x) + exp(-x)) / 2


def tanh(x):
    return sinh(x) / cosh(x)


def asin(x):
    if isinstance(x, Series):
        return integrated(derived(x) / sqrt(1 - x * x), at_zero(math.asin, x, {0: Q(0)}))
    return math.asin(x)


def atan(x):
    if isinstance(x, Series):
        return integrated(derived(x) / (1 + x * x), at_zero(math.atan, x, {0: Q(0)}))
    return math.atan(x)


def sqrt(x):
    return power(x, Q(1, 2))


def power(x, exponent):
    if exponent == int(exponent):
        return x ** int(exponent) if exponent >= 0 else 1 / x ** int(-exponent)
    if not isinstance(x, Series):
        return float(x) ** float(exponent)
    start = at_zero(lambda a: a ** float(exponent), x, {1: Q(1)})
    # y' x = exponent y x'.
    y = Series([start] + [Q(0)] * (len(x) - 1))
    for k in range(1, len(x)):
        known = sum(((exponent * i - (k - i)) * x.c[i] * y.c[k - i] for i in range(1, k + 1)), Q(0))
        y.c[k] = known / (k * x.c[0])
    return y


def agm(a, b):
    """The arithmetic-geometric mean."""
    if isinstance(a, Series) or isinstance(b, Series):
        terms = len(a) if isinstance(a, Series) else len(b)
        a, b = series(a, terms), series(b, terms)
        while a.c != b.c:
            a, b = (a + b) / 2, sqrt(a * b)
        return a
    for _ in range(60):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


def total(term, first, last=None):
    """The sum of the terms; without a last one until they no longer count."""
    if last is not None:
        return sum((term(Q(n)) for n in range(int(first), int(last) + 1)), Q(0))
    result = 0
    for n in count(int(first)):
        this = term(Q(n))
        result = result + this
        if isinstance(this, Series):
            if not any(this.c):
                return result
        elif abs(this) <= 1e-17 * abs(result):
            return result


def double_factorial(n):
    return Q(math.prod(range(int(n), 0, -2)))


def integral(f, a, b):
    """The double exponential rule, which forgives singular ends."""
    a, b = float(a), float(b)
    middle, half, result, step = (a + b) / 2, (b - a) / 2, 0.0, 1 / 64
    for n in range(-400, 401):
        inner = pi / 2 * math.sinh(n * step)
        if abs(inner) > 300:
            continue
        weight = pi / 2 * math.cosh(n * step) / math.cosh(inner) ** 2
        # How far the place is from the nearer end, which a float near that end would not say.
        near = 2 / (1 + math.exp(2 * abs(inner)))
        x = b - half * near if inner > 0 else a + half * near
        if weight * half != 0.0 and a != x != b:
            result += weight * half * step * f(x)
    return result


def slope(f, x):
    """The derivative by differences, good to about ten digits."""
    h = 2.0 ** -9
    return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h)


class Angle:
    """k times a phase that is given by its cosine, a fraction, and where it is needed its sine."""

    def __init__(self, cosine, k=1, sine=Q(0)):
        self.first, self.k, self.first_sine = cosine, k, sine

    def __rmul__(self, k):
        return Angle(self.first, self.k * k, self.first_sine)

    def cosine(self):
        return self.multiple(Q(1), self.first)

    def sine(self):
        return self.multiple(Q(0), self.first_sine)

    def multiple(self, a, b):
        for _ in range(self.k):
            a, b = b, 2 * self.first * b - a
        return a


def by_tangent_of_half(t):
    return Angle((1 - t * t) / (1 + t * t), 1, 2 * t / (1 + t * t))


class Polynomial(dict):
    """A polynomial in letters: the factor of each product of letters."""

    def __add__(self, other):
        result = dict(self)
        for product, factor in polynomial(other).items():
            result[product] = result.get(product, 0) + factor
        return Polynomial({p: f for p, f in result.items() if f != 0})

    def __neg__(self):
        return Polynomial({p: -f for p, f in self.items()})

    def __sub__(self, other):
        return self + -polynomial(other)

    def __rsub__(self, other):
        return polynomial(other) - self

    def __mul__(self, other):
        result = {}
        for a, f in self.items():
            for b, g in polynomial(other).items():
                product = tuple(sorted(a + b))
                result[product] = result.get(product, 0) + f * g
        return Polynomial({p: f for p, f in result.items() if f != 0})

    def __pow__(self, n):
        result = polynomial(1)
        for _ in range(n):
            result = result * self
        return result

    __radd__, __rmul__ = __add__, __mul__

    def put(self, values):
        """Substitutes polynomials for letters."""
        result = Polynomial()
        for product, factor in self.items():
            term = polynomial(factor)
            for letter in product:
                term = term * values.get(letter, Polynomial({(letter,): Q(1)}))
            result = result + term
        return result


def polynomial(x):
    return x if isinstance(x, Polynomial) else Polynomial({(): Q(x)} if x != 0 else {})


def letters(names):
    return [Polynomial({(name,): Q(1)}) for name in names.split()]


class Cosines(dict):
    """A sum of cosines: the factor of cos k tau in each power of epsilon, up to a power."""

    def times(self, other, last, sign=1):
        """The product; of two sums of sines with the sign -1."""
        result = {}
        for (n, j), a in self.items():
            for (m, k), b in other.items():
                if n + m <= last:
                    for harmonic, half in ((abs(j - k), Q(1, 2)), (j + k, Q(sign, 2))):
                        key = (n + m, harmonic)
                        result[key] = result.get(key, 0) + a * b * half
        return Cosines({key: a for key, a in result.items() if a != {}})


class Ansatz:
    """An oscillation whose coefficients are letters, and what the equation of motion asks of them."""

    def __init__(self, force, harmonics, ratio):
        self.force, self.harmonics, self.ratio, self.known = force, harmonics, ratio, {}

    def condition(self, n, k):
        """The factor of cos k tau in the power n of epsilon, with all that is known put in."""
        put = lambda name: polynomial(letters(name)[0]).put(self.known)
        u = Cosines({key: put(name) for key, name in self.harmonics.items() if key[0] <= n and put(name) != {}})
        ratio = Cosines({(m, 0): put(name) for m, name in self.ratio.items() if m < n})
        ratio[(0, 0)] = polynomial(1)
        second = Cosines({(m, j): -j * j * a for (m, j), a in u.items()})
        linear = ratio.times(ratio, n).times(second, n).get((n, k), polynomial(0))
        result = linear + u.get((n, k), polynomial(0))
        slope = ratio.times(Cosines({(m, j): -j * a for (m, j), a in u.items() if j > 0}), n)
        square = slope.times(slope, n, -1)
        for (position, velocity), factor in self.force.items():
            powers = Cosines({(0, 0): polynomial(1)})
            for each in position * [u] + velocity // 2 * [square]:
                powers = powers.times(each, n)
            result = result + polynomial(factor) * powers.get((n, k), polynomial(0))
        return result

    def gives(self, n, k, expected, new=None):
        """True if a condition is this; `new` is the coefficient that it fixes, and may have been told before."""
        told = self.known.pop(new, None)
        assert self.condition(n, k) == polynomial(expected), self.condition(n, k)
        if told is not None:
            self.known[new] = told
        for product in expected:
            if len(expected) == len(product) == 1:
                self.known[product[0]] = polynomial(0)

    def fixes(self, n, k, name, value):
        """True if this coefficient, which is known from now on, satisfies a condition."""
        self.known[name] = polynomial(value)
        assert self.condition(n, k) == {}, self.condition(n, k)


class FewHarmonics:
    """A few harmonics under a force that is cut off: what the factors of the cosines ask of them."""

    def __init__(self, force, harmonics):
        self.force, self.harmonics = force, harmonics
        self.letters = letters(" ".join([f"a_{k}" for k in harmonics] + ["Δ"]))

    def condition(self, k):
        """The factor of a cosine in the equation of motion."""
        u = Cosines({(0, j): a for j, a in zip(self.harmonics, self.letters)})
        result = -k * k * self.letters[-1] ** 2 * u[0, k]
        powers = u
        for place, factor in enumerate(self.force):
            if place > 0:
                powers = powers.times(u, 0)
            result = result + factor * powers.get((0, k), polynomial(0))
        return result

    def told(self, formula):
        return polynomial(formula(*self.letters))

    def asks(self, k, formula):
        proportional(self.condition(k), self.told(formula))

    def at_ratio(self, k):
        """A condition with what the square of the frequency is."""
        result = Polynomial()
        for product, factor in self.condition(k).items():
            rest = Polynomial({tuple(name for name in product if name != "Δ"): factor})
            result = result + (rest * self.squared if "Δ" in product else rest)
        return result

    def has_ratio(self, formula):
        self.squared = self.told(formula)
        assert self.at_ratio(self.harmonics[0]) == {}, self.at_ratio(self.harmonics[0])

    def leaves(self, formula):
        self.left, self.series = self.told(formula), {}
        proportional(self.at_ratio(self.harmonics[1]), self.left)

    def is_at_zero(self, formula):
        first, second = self.letters[:2]
        proportional(self.left.put({next(iter(first))[0]: -second}), self.told(formula))

    def begins(self, k, formula):
        """A harmonic as a series in the amplitude; with both of them nothing may be left to the order given."""
        self.series[f"a_{k}"] = formula(variable(20))
        if len(self.series) == 2:
            known = min(map(len, self.series.values()))
            amplitude = sum(self.series.values(), Q(0))
            assert amplitude.c == variable(known).c, amplitude.c
            rest = series(0, known)
            for product, factor in self.left.items():
                term = series(factor, known)
                for name in product:
                    term = term * self.series[name]
                rest = rest + term
            assert not any(rest.c), rest.c


def proportional(a, b):
    """Polynomials that are the same up to a number."""
    product = next(iter(a))
    assert product in b and {p: f * b[product] for p, f in a.items()} == {p: f * a[product] for p, f in b.items()}, (a, b)


def error_begins(ratio, power, coefficient):
    """The first term of the error of a formula for the period over that of small swings."""
    amplitude = variable(power + 6)
    error = ratio(amplitude) * agm(1, cos(amplitude / 2)) - 1
    assert len(error) > power and error.c[: power + 1] == [Q(0)] * power + [coefficient], error.c


def error_vanishes_at_the_top(ratio):
    """A formula without series at small swings, for large ones."""
    errors = [abs(ratio(pi - rest) * agm(1, math.sin(rest / 2)) - 1) for rest in (1e-1, 1e-2, 1e-3)]
    assert errors[2] < 1e-7 and all(below < above / 50 for above, below in zip(errors, errors[1:])), errors


class Phased(dict):
    """A sum of powers of pi and of a phase times its harmonics: the factor by the power of pi, that of the phase, the harmonic, and
    whether it is a sine."""

    def __add__(self, other):
        result = dict(self)
        for key, factor in phased(other).items():
            result[key] = result.get(key, 0) + factor
        return Phased({key: factor for key, factor in result.items() if factor != 0 and key[2:] != (0, 1)})

    def __neg__(self):
        return Phased({key: -factor for key, factor in self.items()})

    def __sub__(self, other):
        return self + -phased(other)

    def __rsub__(self, other):
        return phased(other) - self

    def __mul__(self, other):
        result = Phased()
        for (e, p, j, s), a in self.items():
            for (f, q, k, r), b in phased(other).items():
                low, sign = abs(j - k), -1 if j < k else 1
                # cos cos and sin sin make cosines, the others sines.
                first = a * b / 2 if s == r else a * b / 2 * (sign if s else -sign)
                second = -a * b / 2 if s and r else a * b / 2
                result = result + Phased({(e + f, p + q, low, s ^ r): first})
                result = result + Phased({(e + f, p + q, j + k, s ^ r): second})
        return result

    def __pow__(self, n):
        result = phased(1)
        for _ in range(n):
            result = result * self
        return result

    def __truediv__(self, other):
        [((e, p, k, s), factor)] = phased(other).items()
        assert (p, k, s) == (0, 0, 0), "the quotient is not a sum"
        return self * Phased({(-e, 0, 0, 0): 1 / Q(factor)})

    def __rtruediv__(self, other):
        return phased(other) / self

    __radd__, __rmul__ = __add__, __mul__

    def wave(self, s):
        """The cosine or the sine of a multiple of the phase."""
        [(key, factor)] = self.items()
        assert key == (0, 1, 0, 0) and factor == int(factor) >= 0
        return Phased({(0, 0, int(factor), s): Q(1)})

    def slope(self):
        result = Phased()
        for (e, p, k, s), a in self.items():
            result = result + Phased({(e, p, k, 1 - s): a * k if s else -a * k})
            if p > 0:
                result = result + Phased({(e, p - 1, k, s): a * p})
        return result

    def integral(self):
        """From zero to the phase, by parts."""
        result, rest = Phased(), self
        while rest:
            part = Phased()
            for (e, p, k, s), a in rest.items():
                if k == 0:
                    part = part + Phased({(e, p + 1, 0, 0): a / (p + 1)})
                else:
                    part = part + Phased({(e, p, k, 1 - s): -a / k if s else a / k})
            result, rest = result + part, rest - part.slope()
        return result - result.at(0)

    def at(self, half_turns):
        """The value at a phase in units of pi."""
        result = Phased()
        for (e, p, k, s), a in self.items():
            if s == 0 and (p == 0 or half_turns > 0):
                result = result + Phased({(e + p, 0, 0, 0): a * half_turns**p * (-1) ** (k * half_turns)})
        return result

    def at_quarter_turn(self):
        """The value where the phase is half of pi."""
        result = Phased()
        for (e, p, k, s), a in self.items():
            wave = (1, 0, -1, 0)[(k - s) % 4]
            result = result + Phased({(e + p, 0, 0, 0): a * Q(1, 2) ** p * wave})
        return result


def phased(x):
    return x if isinstance(x, Phased) else Phased({(0, 0, 0, 0): Q(x)} if x != 0 else {})


PHASE, PI = Phased({(0, 1, 0, 0): Q(1)}), Phased({(1, 0, 0, 0): Q(1)})


class SlowFlow:
    """An oscillation x(A, phase) under a weak force: x'' + omega^2 x and further terms are zero.

    The coefficients of x, of the rate of A and of that of the phase are found by the power of A and that of the small parameter."""

    def __init__(self, omega, terms, kinked, lift):
        self.omega, self.terms, self.kinked, self.lift = omega, terms, kinked, lift
        odd = kinked or all((i + k) % 2 == 1 for _, i, k, _ in terms)
        self.half_turns = 1 if odd else 2
        self.x, self.a, self.w = {(1, 0): cos(PHASE)}, {}, {(0, 0): phased(omega)}

    def counts(self, key, place):
        return key[1] <= place[1] and key[0] + self.lift * key[1] <= place[0] + self.lift * place[1]

    def times(self, f, g, place):
        result = {}
        for (n, j), a in f.items():
            for (m, i), b in g.items():
                key = (n + m, j + i)
                if self.counts(key, place):
                    result[key] = result.get(key, phased(0)) + a * b
        return result

    def rate(self, f, place):
        """The derivative by time, as A and the phase change."""
        by_phase = self.times({key: a.slope() for key, a in f.items()}, self.w, place)
        by_amplitude = self.times({(n - 1, j): n * a for (n, j), a in f.items() if n > 0}, self.a, place)
        return {key: by_phase.get(key, phased(0)) + by_amplitude.get(key, phased(0)) for key in {**by_phase, **by_amplitude}}

    def rest(self, place):
        """The left side of the equation of motion, which should be zero, as far as the motion is known."""
        wide = (place[0] + 1, place[1])
        x, v = self.x, self.rate(self.x, wide)
        result = self.rate(v, place).get(place, phased(0)) + self.omega**2 * x.get(place, phased(0))
        for factor, i, k, j in self.terms:
            product = {(0, j): phased(factor)}
            for f in [x] * i + [v] * k:
                product = self.times(product, f, place)
            result = result + product.get(place, phased(0))
        return result

    def forces(self, n, j, known):
        """The contributions of lower powers to the right side."""
        self.right, self.place = -self.rest((n, j)), (n, j)
        assert self.right == phased(known(PI, PHASE)), self.right

    def projected(self, wave):
        """The part of a wave in what lower powers bring, over 2 omega: what a coefficient has to take away."""
        factor = self.right * wave
        return -factor.integral().at(self.half_turns) / (PI * self.half_turns * self.omega)

    def grows(self, n, j, value):
        value = phased(value(PI, PHASE))
        assert self.place == (n, j) and self.projected(sin(PHASE)) == value, self.projected(sin(PHASE))
        self.a[n, j] = value

    def turns(self, n, j, value):
        value = phased(value(PI, PHASE))
        assert self.place == (n + 1, j) and self.projected(cos(PHASE)) == value, self.projected(cos(PHASE))
        self.w[n, j] = value

    def moves(self, n, j, value):
        """True if the motion satisfies the equation, begins at rest, and goes on as it began."""
        x = self.x[n, j] = phased(value(PI, PHASE))
        assert self.rest((n, j)) == {}, self.rest((n, j))
        v = self.rate(self.x, (n, j)).get((n, j), phased(0))
        sign = (-1) ** self.half_turns
        for y in [x, v]:
            assert y.at(0) == {} and y.at(self.half_turns) == sign * y.at(0), y
        assert self.kinked or all(p == 0 for _, p, _, _ in x)

    def is_as_fast(self, n, j, value):
        v = self.rate(self.x, (n, j)).get((n, j), phased(0))
        assert v == phased(value(PI, PHASE)), v

    def law(self, coefficients, law):
        """True if a sum of powers has these coefficients, with several fractions for the letters and in the place of pi."""
        for choice in range(3):
            p, a, c = Q(7 + choice, 3), Q(5 - choice, 2), Q(3, 11 + choice)
            known = sum(
                (f * p**e * a**n * c**j for (n, j), value in coefficients.items() for (e, _, _, _), f in value.items()), Q(0)
            )
            assert known == law(p, a, c), known

    def amplitude_law(self, law):
        self.law(self.a, law)

    def phase_law(self, law):
        self.law(self.w, law)

    def first_law(self, law):
        self.law({(n, 0): value for (n, j), value in self.a.items() if j == 1}, lambda p, a, c: law(p, a))

    def loss(self, last, law):
        """The mean of what the force takes at the first power of the small parameter, to a power of A."""
        still = SlowFlow(self.omega, [term for term in self.terms if term[3] == 0], self.kinked, 0)
        still.x = {key: x for key, x in self.x.items() if key[1] == 0}
        still.w = {key: w for key, w in self.w.items() if key[1] == 0}
        v = still.rate(still.x, (last + 1, 0))
        mean = {}
        for factor, i, k, j in self.terms:
            if j == 1:
                product = {(0, 0): phased(factor)}
                for f in [still.x] * i + [v] * (k + 1):
                    product = still.times(product, f, (last, 0))
                for key, f in product.items():
                    taken = f.integral().at(self.half_turns) / (PI * self.half_turns)
                    mean[key] = mean.get(key, phased(0)) + taken
        self.law(mean, lambda p, a, c: law(p, a))

    def along(self, coefficients, square, derived=0):
        """Sums over powers of A and the parameter, A^2 being a series; those of A' are over A."""
        terms = len(square)
        result = series(0, terms)
        for (n, j), value in coefficients.items():
            [((e, _, _, _), f)] = value.items()
            assert e == 0 and n % 2 == 0
            m = n // 2
            factor = f if not derived else f * m
            if factor != 0 and j < terms:
                power = square ** (m - derived)
                result = result + variable(terms) ** j * power * factor
        return result

    def cycle_square(self, square):
        """True if A' vanishes where A^2 is this series."""
        terms = len(square(variable(20)))
        self.square = square(variable(terms))
        over_a = {(n - 1, j): value for (n, j), value in self.a.items()}
        # A' begins with the first power, so that its sum is known to one power more.
        rate = self.along({(n, j - 1): value for (n, j), value in over_a.items()}, self.square)
        assert not any(rate.c), rate.c

    def cycle_frequency(self, frequency):
        known, told = self.along(self.w, padded(self.square)), frequency(variable(len(self.square) + 1))
        assert all(a == b for a, b in zip(known.c, told.c)), known.c

    def cycle_exponent(self, exponent):
        over_a = {(n - 1, j): value for (n, j), value in self.a.items()}
        square = padded(self.square)
        known, told = 2 * square * self.along(over_a, square, 1), exponent(variable(len(square)))
        assert all(a == b for a, b in zip(known.c, told.c)), known.c


class LimitCycle:
    """x(t) of a phase that runs evenly, with the frequency and the motion by powers of the excitation. The first harmonic of each power is
    a cosine, whose amplitude the next power fixes."""

    def __init__(self, flow):
        self.omega, self.terms = flow.omega, flow.terms
        self.forced, self.amplitudes, self.w = [phased(0)], [], [phased(flow.omega)]

    def motion(self, n, amplitudes):
        return [f + a * cos(PHASE) for f, a in zip(self.forced[:n], amplitudes)]

    def product(self, f, g, n):
        return [sum((f[i] * g[m - i] for i in range(m + 1) if i < len(f) and m - i < len(g)), phased(0)) for m in range(n + 1)]

    def right(self, n, x):
        """The contributions of these powers of the motion to the right side of the next one."""
        second = [y.slope().slope() for y in x]
        result = -self.product(self.product(self.w, self.w, n), second, n)[n]
        v = self.product(self.w, [y.slope() for y in x], n)
        for factor, i, k, j in self.terms:
            product = [phased(factor)]
            for f in [x] * i + [v] * k:
                product = self.product(product, f, n)
            if j <= n and n - j < len(product):
                result = result - product[n - j]
        return result

    def with_open(self, n, amplitude):
        return self.right(n, self.motion(n, self.amplitudes[: n - 1] + [amplitude]))

    def forces(self, n, known):
        """Asserts the force for as many amplitudes one power below as decide a polynomial in them."""
        for choice in range(12 if n == 1 else 3):
            assert self.with_open(n, Q(choice, 3)) == phased(known(PHASE, Q(choice, 3))), self.with_open(n, Q(choice, 3))

    def asks(self, n, sine):
        for choice in range(12 if n == 1 else 3):
            assert self.with_open(n, Q(choice, 3)).get((0, 0, 1, 1), 0) == sine(Q(choice, 3))

    def is_as_large(self, n, amplitude):
        assert self.with_open(n, Q(amplitude)).get((0, 0, 1, 1), 0) == 0
        self.amplitudes.append(Q(amplitude))

    def is_as_fast(self, n, frequency):
        self.known = self.with_open(n, self.amplitudes[n - 1]) + 2 * self.omega * self.amplitudes[0] * frequency * cos(PHASE)
        assert self.known.get((0, 0, 1, 0), 0) == 0, self.known
        self.w.append(phased(frequency))

    def moves(self, n, motion):
        x = phased(motion(PHASE, Q(0)))
        assert self.omega**2 * (x.slope().slope() + x) == self.known and phased(motion(PHASE, Q(1))) - x == cos(PHASE)
        self.forced.append(x)

    def amplitude(self, told):
        told = told(variable(40))
        assert told.c == self.amplitudes, told.c

    def frequency(self, told):
        told = told(variable(40))
        assert len(told) == len(self.w) and all(phased(a) == b for a, b in zip(told.c, self.w)), told.c


class Quarter:
    """A swing from the turning point A to zero, by powers of A: functions of the phase, and the
    corrections of the frequency. The force has further powers of x, the first of them x squared."""

    def __init__(self, force):
        self.force, self.x, self.d = force, [phased(0), cos(PHASE)], [phased(1)]

    def product(self, f, g, n):
        known = (i for i in range(n + 1) if i < len(f) and n - i < len(g))
        return sum((f[i] * g[n - i] for i in known), phased(0))

    def right(self, n):
        """The right side of x_n'' + x_n, without the correction that this power fixes."""
        result = phased(0)
        for m in range(1, n):
            result = result - self.product(self.d, self.d, m) * self.x[n - m].slope().slope()
        power = self.x
        for factor in self.force:
            power = [self.product(power, self.x, m) for m in range(n + 1)]
            result = result - factor * power[n]
        return result

    def forces(self, n, known):
        self.known, self.begun = phased(known(PI, PHASE)), phased(0)
        assert self.right(n) == self.known, self.right(n)

    def begins(self, n, begun):
        y = self.begun = phased(begun(PI, PHASE))
        assert y.slope().slope() + y == self.known and y.at(0) == y.slope().at(0) == {}, y

    def corrects(self, n, correction):
        self.d.append(phased(correction(PI)))
        end = self.begun.at_quarter_turn()
        assert end + self.d[-1] * PI * Q(1, 2) == {}, end

    def moves(self, n, x):
        self.x.append(phased(x(PI, PHASE)))
        assert self.x[-1] == self.begun + self.d[-1] * PHASE * sin(PHASE), self.x[-1]

    def harmonic(self, k, told):
        told = told(pi, variable(40)).c
        assert len(told) == len(self.x)
        for x, a in zip(self.x, told):
            part = (4 * x * cos(k * PHASE)).integral().at_quarter_turn() / PI
            agree(sum(float(factor) * pi ** e for (e, _, _, _), factor in part.items()), a)


def padded(x):
    """The evaluation with one more coefficient, which must not change it."""
    return Series(x.c + [Q(0)])


def agree(a, b, digits=10):
    """Numbers that are the same; integrals with a singular end and derivatives by differences lose digits."""
    a, b = float(a), float(b)
    assert abs(a - b) <= 10.0 ** -digits * max(abs(a), abs(b)) + 1e-12, (a, b)
    return a


def vanishes(*terms):
    """A sum that is zero, but for the digits that its terms lose."""
    terms = [float(term) for term in terms]
    assert abs(sum(terms)) <= 1e-10 * sum(map(abs, terms)), terms


def below(a, b):
    assert a < b, (a, b)


def rounds_to(value, printed, place):
    assert abs(float(value) - printed) <= 0.5001 * place, (value, printed)


def same_fraction(*sides):
    assert all(exact(side) == exact(sides[0]) for side in sides), sides


def nearly_same_series(terms, *sides):
    """The same in floats."""
    sides = [series(side, terms).c for side in sides]
    assert min(map(len, sides)) >= terms, "too few terms"
    for other in sides[1:]:
        for a, b in zip(sides[0], other):
            agree(a, b)


def same_series(terms, *sides):
    """Asserts that series agree in all coefficients, and have at least this many."""
    sides = [side.c if isinstance(side, Series) else [exact(side)] + [Q(0)] * (terms - 1) for side in sides]
    assert min(map(len, sides)) >= terms, "too few terms"
    for other in sides[1:]:
        assert all(a == b for a, b in zip(sides[0], other)), (sides[0], other)

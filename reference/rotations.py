"""Answers of a driven pendulum that go around: python reference/rotations.py > crates/libration-testing/data/rotations.csv

theta'' + c theta' + sin(theta) = A cos(w t) and its deviations by Taylor series in mpmath floats of 40 digits; Newton's method, with slopes by
central differences, closes the motion up to whole turns. At a period doubling the monodromy matrix has the trace -1 - exp(-c T), at a fold
1 + exp(-c T), as its determinant is exp(-c T) (Liouville). Needs: pip install mpmath. Takes some minutes.
"""
from mpmath import cos, exp, matrix, lu_solve, mp, mpf, nstr, pi, sin

mp.dps = 40
ORDER = 48
STEPS = 40  # a period of the drive


def times(a, b, n):
    return sum(a[k] * b[n - k] for k in range(n + 1))


def moved(c, amplitude, w, start, periods):
    """The state, and its derivatives by both numbers of the start as columns, after a number of drive periods."""
    theta, v = start
    tangents = [[mpf(1), mpf(0)], [mpf(0), mpf(1)]]
    time, h = mpf(0), 2 * pi / w / STEPS
    for _ in range(periods * STEPS):
        x, y, s, k = [theta], [v], [sin(theta)], [cos(theta)]
        drive = [amplitude * cos(w * time)]
        wave = [-amplitude * sin(w * time)]
        columns = [([a], [b]) for a, b in tangents]
        for n in range(ORDER):
            force = drive[n] - c * y[n] - s[n]
            for a, b in columns:
                bend = times(k, a, n)
                a.append(b[n] / (n + 1))
                b.append((-c * b[n] - bend) / (n + 1))
            x.append(y[n] / (n + 1))
            y.append(force / (n + 1))
            slopes = [(j + 1) * x[j + 1] for j in range(n + 1)]
            s.append(times(k, slopes, n) / (n + 1))
            k.append(-times(s, slopes, n) / (n + 1))
            drive.append(w * wave[n] / (n + 1))
            wave.append(-w * drive[n] / (n + 1))
        at = lambda series: sum(term * h**n for n, term in enumerate(series))
        theta, v = at(x), at(y)
        tangents = [[at(a), at(b)] for a, b in columns]
        time += h
    return theta, v, tangents


def missed(kind, values, c, amplitude, turns, periods):
    theta, v, w = values
    duration = 2 * pi * periods / w
    end, speed, (first, second) = moved(c, amplitude, w, (theta, v), periods)
    defect = [end - theta - 2 * pi * turns, speed - v]
    trace = first[0] + second[1]
    wanted = {"period_doubling": -1, "fold": 1}.get(kind)
    if wanted is not None:
        defect.append(trace - wanted * (1 + exp(-c * duration)))
    return defect, trace


def found(kind, c, amplitude, w, start, turns, periods):
    values = [mpf(start[0]), mpf(start[1]), mpf(w)]
    count = 3 if kind != "answer" else 2
    for _ in range(40):
        defect, trace = missed(kind, values, c, amplitude, turns, periods)
        jacobian = matrix(count, count)
        for j in range(count):
            h = mpf(10) ** -13
            beside = [list(values), list(values)]
            beside[0][j] += h
            beside[1][j] -= h
            plus, minus = (missed(kind, it, c, amplitude, turns, periods)[0] for it in beside)
            for i in range(count):
                jacobian[i, j] = (plus[i] - minus[i]) / (2 * h)
        change = lu_solve(jacobian, -matrix(defect))
        for j in range(count):
            values[j] += change[j]
        if max(abs(it) for it in change) < mpf(10) ** -30:
            return values, trace
    raise ArithmeticError("Newton's method has not settled")


# kind, c, A, turns, periods of the drive, w and the state at t = 0 to a few digits
QUESTIONS = [
    ("answer", "0.5", "2", 1, 1, "1", ("0.1724", "2.2254")),
    ("answer", "0.1", "1.2", 1, 1, "1", ("1.2325", "1.2354")),
    ("period_doubling", "0.5", "2", 1, 1, "0.84745", ("-0.24618", "2.49827")),
    ("period_doubling", "0.5", "2", 2, 2, "0.83876", ("0.35018", "2.48959")),
    ("period_doubling", "0.1", "1.2", 1, 1, "0.77907", ("-1.32265", "1.71347")),
    ("fold", "0.1", "1.2", 1, 1, "0.81803", ("-0.26354", "1.69839")),
    ("fold", "0.1", "1.2", 1, 1, "0.788066", ("0.823836", "1.218510")),
]

HEADER = """\
# Rotating solutions of the driven pendulum theta'' + c theta' + sin(theta) = A cos(w t). Source: reference/rotations.py (Taylor shooting in 40
# digits). Licence: MIT OR Apache-2.0. kind: a solution (answer) at w, or a fold or period doubling over w. turns, drive_periods: whole turns in this
# number of drive periods. theta, velocity: the state at t = 0. trace: that of the monodromy matrix. 30 digits.
kind,c,A,turns,drive_periods,w,theta,velocity,trace"""

if __name__ == "__main__":
    print(HEADER)
    for kind, c, amplitude, turns, periods, w, start in QUESTIONS:
        (theta, v, w), trace = found(kind, mpf(c), mpf(amplitude), w, start, turns, periods)
        print(",".join([kind, c, amplitude, str(turns), str(periods), *(nstr(it, 30) for it in (w, theta, v, trace))]), flush=True)

"""Fit driven oscillators to the rows of examples/response_synthetic.csv by the amplitudes and phases of their responses.

    python reference/response_fit.py 7 8 29 30 31 32

The response to a drive is computed (harmonic balance with odd harmonics, Newton's method), not the drive of a response; frequencies are
exact, so that least squares over amplitudes and phases (SciPy's trust-region method) have errors in both. Rows to leave out are given, counted
from one: next to a jump, where responses end, the sum of squares has no derivative. Prints for each model, with phases and without, omega0,
c, kappa and A, their uncertainties, and chi^2. Needs SciPy.
"""
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

ROWS = Path(__file__).parent.parent / "examples" / "response_synthetic.csv"
ODD = np.arange(1, 16, 2)
PHASES = np.arange(64) * (2 * np.pi / 64)
COSINES, SINES = np.cos(np.outer(PHASES, ODD)), np.sin(np.outer(PHASES, ODD))


def force(model, x, parameters):
    """Restoring acceleration and its derivative."""
    square = parameters[0] ** 2
    if model == "pendulum":
        return square * np.sin(x), square * np.cos(x)
    cubic = parameters[2] if model == "duffing" else 0.0
    return square * x + cubic * x**3, square + 3 * cubic * x * x


def response(model, frequency, parameters, start):
    """Coefficients of cos(k w t) and sin(k w t) of the solution next to a start; None if Newton's method does not end."""
    damping, drive = parameters[1], parameters[-1]
    coefficients, n = start.copy(), len(ODD)
    for _ in range(40):
        x = COSINES @ coefficients[:n] + SINES @ coefficients[n:]
        value, slope = force(model, x, parameters)
        basis = np.hstack([COSINES, SINES])
        linear = np.zeros((2 * n, 2 * n))
        orders = ODD * frequency
        linear[:n, :n] = linear[n:, n:] = np.diag(-(orders**2))
        linear[:n, n:], linear[n:, :n] = np.diag(damping * orders), np.diag(-damping * orders)
        project = basis.T * (2 / len(PHASES))
        miss = linear @ coefficients + project @ value
        miss[0] -= drive
        change = np.linalg.solve(linear + project @ (slope[:, None] * basis), miss)
        coefficients -= change
        if np.abs(change).max() < 1e-13:
            return coefficients
    return None


def peak_and_lag(coefficients):
    """Largest displacement, and lag of the fundamental behind the drive."""
    n = len(ODD)
    lag = np.arctan2(coefficients[n], coefficients[0])
    phase = lag
    for _ in range(30):
        angles = ODD * phase
        velocity = ODD @ (-coefficients[:n] * np.sin(angles) + coefficients[n:] * np.cos(angles))
        bend = ODD**2 @ (-coefficients[:n] * np.cos(angles) - coefficients[n:] * np.sin(angles))
        phase -= velocity / bend
    return coefficients[:n] @ np.cos(ODD * phase) + coefficients[n:] @ np.sin(ODD * phase), lag


def fit(model, rows, start, with_phases):
    frequencies, amplitudes, deviations, phases, of_phases = rows.T
    known = []
    for amplitude, phase in zip(amplitudes, phases):
        first = np.zeros(2 * len(ODD))
        first[0], first[len(ODD)] = amplitude * np.cos(phase), amplitude * np.sin(phase)
        known.append(first)

    def residuals(parameters):
        out = []
        for place, row in enumerate(rows):
            solution = response(model, row[0], parameters, known[place])
            if solution is None:
                return np.full(len(rows) * (1 + with_phases), 1e3)
            known[place] = solution
            peak, lag = peak_and_lag(solution)
            out.append((row[1] - peak) / row[2])
            if with_phases:
                out.append((row[3] - lag) / row[4])
        return np.array(out)

    result = least_squares(residuals, start, x_scale=np.abs(start), xtol=1e-13, ftol=1e-14, gtol=1e-13)
    covariance = np.linalg.inv(result.jac.T @ result.jac)
    return result.x, np.sqrt(np.diag(covariance)), 2 * result.cost


def main():
    lines = [line for line in ROWS.read_text().splitlines() if line[0].isdigit()]
    left_out = {int(word) - 1 for word in sys.argv[1:]}
    rows = np.array([[float(cell) for cell in line.split(",")] for place, line in enumerate(lines) if place not in left_out])
    rows[:, 1:] = np.radians(rows[:, 1:])
    starts = [("pendulum", [3.098, 0.2692, 1.3439]), ("duffing", [3.0755, 0.2635, -1.3185, 1.3186])]
    for with_phases in (True, False):
        for model, start in starts:
            values, deviations, chi2 = fit(model, rows, np.array(start), with_phases)
            numbers = " ".join(f"{value:.8f} ({deviation:.3g})" for value, deviation in zip(values, deviations))
            print(f"{model}, {'with' if with_phases else 'without'} phases: {numbers}, chi2 {chi2:.5f}")


main()

"""Fit a table of amplitudes and periods with SciPy, to be compared with `libration fit periods`.

    python reference/fit_periods.py FILE

FILE has the columns amplitude (rad), period (s), sigma of the amplitude, sigma of the period, between commas
or spaces, with or without a header. Prints, for T = T0 R(A) with the exact R, for the constant period and for
T = T0 [1 + beta (R - 1)]:

* `effective`: scipy.optimize.curve_fit with the effective variance, weights renewed until they settle;
* `orthogonal`: scipy.odr, which moves the amplitudes as well: an independent way to the same numbers;
* `unweighted`: curve_fit with all rows alike.
"""

import sys
import warnings

import numpy as np
from scipy.optimize import curve_fit
from scipy.special import ellipkm1

warnings.filterwarnings("ignore", category=DeprecationWarning)
from scipy import odr  # noqa: E402


def ratio(amplitude):
    return 2 / np.pi * ellipkm1(np.cos(amplitude / 2) ** 2)


def exact(a, t0):
    return t0 * ratio(a)


def constant(a, t0):
    return t0 * np.ones_like(a)


def scaled_excess(a, t0, beta):
    return t0 * (1 + beta * (ratio(a) - 1))


def read(path):
    rows = []
    for line in open(path, encoding="utf-8-sig"):
        try:
            rows.append([float(cell) for cell in line.replace(",", " ").split()[:4]])
        except ValueError:
            continue
    amplitude, period, sigma_a, sigma_t = np.array([row for row in rows if row]).T
    return np.abs(amplitude), period, sigma_a, sigma_t


def report(name, method, parameters, covariance, chi2, dof):
    errors = np.sqrt(np.diag(covariance))
    fitted = "  ".join(f"{p:.10g} +- {e:.6g}" for p, e in zip(parameters, errors))
    print(f"{name:14} {method:11} {fitted}  chi2 {chi2:.8g}  dof {dof}  chi2/dof {chi2 / dof:.8g}")


def effective(name, model, start, a, t, sigma_a, sigma_t):
    step = 1e-5
    parameters = np.array(start)
    for _ in range(50):
        slope = (model(a + step, *parameters) - model(np.abs(a - step), *parameters)) / (2 * step)
        sigma = np.hypot(sigma_t, slope * sigma_a)
        parameters, covariance = curve_fit(
            model, a, t, parameters, sigma, absolute_sigma=True, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    residuals = t - model(a, *parameters)
    report(name, "effective", parameters, covariance, np.sum((residuals / sigma) ** 2), len(t) - len(start))
    print(f"{'':26} rms residual {np.sqrt(np.mean(residuals**2)):.8g} s")


def orthogonal(name, model, start, a, t, sigma_a, sigma_t):
    data = odr.RealData(a, t, sx=sigma_a, sy=sigma_t)
    fit = odr.ODR(data, odr.Model(lambda p, x: model(np.abs(x), *p)), beta0=start, maxit=1000, sstol=1e-14, partol=1e-14).run()
    report(name, "orthogonal", fit.beta, fit.cov_beta, fit.sum_square, len(t) - len(start))


def unweighted(name, model, start, a, t):
    parameters, covariance = curve_fit(model, a, t, start, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    errors = np.sqrt(np.diag(covariance))
    fitted = "  ".join(f"{p:.10g} +- {e:.6g}" for p, e in zip(parameters, errors))
    print(f"{name:14} {'unweighted':11} {fitted}")


def main():
    a, t, sigma_a, sigma_t = read(sys.argv[1])
    print(f"{len(t)} rows")
    t0 = np.median(t / ratio(a))
    for name, model, start in [("exact", exact, [t0]), ("constant", constant, [t0]),
                               ("scaled_excess", scaled_excess, [t0, 1.0])]:
        effective(name, model, start, a, t, sigma_a, sigma_t)
        orthogonal(name, model, start, a, t, sigma_a, sigma_t)
        unweighted(name, model, start, a, t)


if __name__ == "__main__":
    main()

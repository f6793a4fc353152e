#!/usr/bin/env python3
"""Rates of amplitudes and phases of coupled oscillators at first order, as averages over one period.

    python reference/coupled_slow_flow.py > crates/libration-testing/data/coupled_slow_flow.csv

With constant amplitudes and phases x_j = A_j*cos(n_j*s + phi_j) and x_j' = -w_j*A_j*sin(n_j*s + phi_j) stand in the small forces f_j, and
A_j' = -<f_j*sin>/w_j, A_j*phi_j' = -<f_j*cos>/w_j + A_j*(difference of the natural frequency - n_j/p * difference of the drive frequency),
where < > is the mean over s. The forces are polynomials in cosines, so the sum over 360 points is the mean; 30 digits (mpmath). No letter is
manipulated. The first three rows are the examples with two coordinates of the package OSCILATE 1.0 (Duffing_11_direct, Duffing_13, quadratic_12).
"""
import csv
import random
import sys

from mpmath import cos, mp, mpf, nstr, pi, sin

mp.dps = 30
POINTS = 360

# Equations; ratios of natural frequencies; resonance of the drive; forces f(x, v, c, k), c being the cosine of the drive and k the parameters.
ROWS = [
    (
        "x'' + w^2*x + eps*(g0*x^3 + g01*x*y^2 + c0*x') = 0; y'' + w^2*y + eps*(g1*y^3 + g01*x^2*y + c1*y') = eps*F*cos(W*t)",
        (1, 1), (1, 1),
        lambda x, v, c, k: [
            -(k["g0"] * x[0]**3 + k["g01"] * x[0] * x[1]**2 + k["c0"] * v[0]),
            -(k["g1"] * x[1]**3 + k["g01"] * x[0]**2 * x[1] + k["c1"] * v[1]) + k["F"] * c,
        ],
    ),
    (
        "x'' + w^2*x + eps*(2*m0*x' + a1*x^3 + a2*x^2*y + a3*x*y^2 + a4*y^3) = eps*F*G0*cos(W*t); "
        "y'' + w1^2*y + eps*(2*m1*y' + a5*x^3 + a6*x^2*y + a7*x*y^2 + a8*y^3) = eps*F*G1*cos(W*t)",
        (1, 3), (3, 1),
        lambda x, v, c, k: [
            -(2 * k["m0"] * v[0] + k["a1"] * x[0]**3 + k["a2"] * x[0]**2 * x[1] + k["a3"] * x[0] * x[1]**2 + k["a4"] * x[1]**3) + k["F"] * k["G0"] * c,
            -(2 * k["m1"] * v[1] + k["a5"] * x[0]**3 + k["a6"] * x[0]**2 * x[1] + k["a7"] * x[0] * x[1]**2 + k["a8"] * x[1]**3) + k["F"] * k["G1"] * c,
        ],
    ),
    (
        "x'' + w^2*x + eps*(2*m0*x' + a0*x*y) = eps*F*G0*cos(W*t); y'' + w1^2*y + eps*(2*m1*y' + a1*x^2) = eps*F*G1*cos(W*t)",
        (1, 2), (2, 1),
        lambda x, v, c, k: [
            -(2 * k["m0"] * v[0] + k["a0"] * x[0] * x[1]) + k["F"] * k["G0"] * c,
            -(2 * k["m1"] * v[1] + k["a1"] * x[0]**2) + k["F"] * k["G1"] * c,
        ],
    ),
    (
        "x'' + w^2*x + eps*(2*m0*x' + a0*x*y) = eps*F*cos(W*t); y'' + w1^2*y + eps*(2*m1*y' + a1*x^2) = 0",
        (1, 2), (1, 1),
        lambda x, v, c, k: [
            -(2 * k["m0"] * v[0] + k["a0"] * x[0] * x[1]) + k["F"] * c,
            -(2 * k["m1"] * v[1] + k["a1"] * x[0]**2),
        ],
    ),
    (
        "x'' + w^2*x = eps*(g*y' + b*y); y'' + w1^2*y = eps*(m*(1 - y^2)*y' - g*x' + b*x)",
        (1, 1), None,
        lambda x, v, c, k: [
            k["g"] * v[1] + k["b"] * x[1],
            k["m"] * (1 - x[1]**2) * v[1] - k["g"] * v[0] + k["b"] * x[0],
        ],
    ),
    (
        "x'' + w^2*x + eps*a*y*z = 0; y'' + w1^2*y + eps*b*x*z = 0; z'' + w2^2*z + eps*c*x*y = eps*F*sin(W*t)",
        (1, 2, 3), (3, 1),
        lambda x, v, c, k: [
            -k["a"] * x[1] * x[2],
            -k["b"] * x[0] * x[2],
            -k["c"] * x[0] * x[1] + k["F"] * c,
        ],
    ),
    (
        "x'' + w^2*x + eps*a*x^2*y = 0; y'' + w^2/9*y + eps*(b*y^3 + a*x^3/3) = eps*F*x*cos(W*t)",
        (3, 1), (4, 3),
        lambda x, v, c, k: [-k["a"] * x[0]**2 * x[1], -(k["b"] * x[1]**3 + k["a"] * x[0]**3 / 3) + k["F"] * x[0] * c],
    ),
    (
        "x'' + w^2*x + eps*(2*m0*x' + a*x*y^2) = 0; y'' + w1^2*y + eps*(2*m1*y' + a*x^2*y + b*x^2*x'*y) = eps*F*cos(W*t)",
        (2, 3), (3, 2),
        lambda x, v, c, k: [
            -(2 * k["m0"] * v[0] + k["a"] * x[0] * x[1]**2),
            -(2 * k["m1"] * v[1] + k["a"] * x[0]**2 * x[1] + k["b"] * x[0]**2 * v[0] * x[1]) + k["F"] * c,
        ],
    ),
]


def names(text):
    word, found = "", set()
    for letter in text + " ":
        if letter.isalnum():
            word += letter
        else:
            if word and word[0].isalpha():
                found.add(word)
            word = ""
    return sorted(found - {"x", "y", "z", "t", "W", "eps", "cos", "sin", "w1", "w2"})


def rates(text, ratios, resonance, force, values, amplitudes, phases, differences, sigma):
    drive = 0 if resonance is None else ratios[0] * resonance[0] / mpf(resonance[1])
    wave = sin if "sin(W" in text else cos
    # With a drive between the harmonics one period of it is not one of the motion: the common denominator is.
    turns = 1 if resonance is None else resonance[1]
    sums = [[mpf(0), mpf(0)] for _ in ratios]
    frequencies = [values["w"] * n / mpf(ratios[0]) for n in ratios]
    for point in range(POINTS * turns):
        s = 2 * pi * point / POINTS
        angles = [n * s + phi for n, phi in zip(ratios, phases)]
        x = [a * cos(angle) for a, angle in zip(amplitudes, angles)]
        v = [-w * a * sin(angle) for w, a, angle in zip(frequencies, amplitudes, angles)]
        for total, f, angle in zip(sums, force(x, v, wave(drive * s), values), angles):
            total[0] += f * sin(angle)
            total[1] += f * cos(angle)
    found = []
    for j, (sine, cosine) in enumerate(sums):
        mean = 1 / (frequencies[j] * POINTS * turns)
        slip = differences[j] - (0 if resonance is None else ratios[j] / drive * sigma)
        found += [-sine * mean, -cosine * mean + amplitudes[j] * slip]
    return found


def main():
    random.seed(20261)
    out = csv.writer(sys.stdout, lineterminator="\n")
    print("# By reference/coupled_slow_flow.py")
    out.writerow(["equation", "ratios", "resonance", "values", "amplitudes", "phases", "differences", "sigma", "rates"])
    for text, ratios, resonance, force in ROWS:
        number = lambda low, high: mpf(random.randrange(int(100 * low), int(100 * high))) / 100  # noqa: E731
        values = {name: number(0.3, 1.5) for name in names(text)}
        amplitudes = [number(0.3, 1.2) for _ in ratios]
        phases = [number(-3, 3) for _ in ratios]
        free = [False] + [f"w{j}^2" in text for j in range(1, len(ratios))]
        differences = [number(-1, 1) if is_free else mpf(0) for is_free in free]
        sigma = mpf(0) if resonance is None else number(-1, 1)
        found = rates(text, ratios, resonance, force, values, amplitudes, phases, differences, sigma)
        listed = lambda numbers: ";".join(nstr(it, 20) for it in numbers)  # noqa: E731
        out.writerow([
            text,
            ":".join(map(str, ratios)),
            "" if resonance is None else f"{resonance[0]}/{resonance[1]}",
            ",".join(f"{name}={nstr(value, 5)}" for name, value in values.items()),
            listed(amplitudes), listed(phases), listed(differences), nstr(sigma, 20), listed(found),
        ])


if __name__ == "__main__":
    main()

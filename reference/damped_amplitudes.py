"""Turning points of damped pendulums in double precision: damped_amplitudes.py > crates/libration-lab/tests/data/damped_amplitudes.csv

theta'' + d sign(theta') + b theta' + c theta'|theta'| + omega0^2 sin theta = 0 from rest, integrated by SciPy's DOP853 from one turning
point to the next, where the velocity is zero; tolerances of 1e-12. The library averages the loss of energy over a cycle instead.
Needs NumPy and SciPy.
"""
import numpy as np
from scipy.integrate import solve_ivp

# omega0 in rad/s, dry in rad/s^2, linear in 1/s, quadratic in 1/rad, release in rad, half swings from row to row, rows.
CASES = [
    (4.43, 0.0, 0.05, 0.0, 0.20, 4, 20),
    (3.13, 0.0, 0.012, 0.0, 0.15, 21, 25),
    (6.2, 0.0, 0.30, 0.0, 0.60, 1, 24),
    (2.5, 0.0, 0.02, 0.0, 1.80, 6, 30),
    (4.43, 0.0, 0.0, 0.015, 0.50, 8, 25),
    (3.13, 0.0, 0.0, 0.08, 1.40, 3, 20),
    (4.43, 0.04, 0.0, 0.0, 0.35, 2, 20),
    (3.5, 0.012, 0.0, 0.0, 1.20, 8, 40),
    (4.43, 0.0, 0.03, 0.02, 0.80, 4, 40),
    (3.5, 0.006, 0.03, 0.0, 0.60, 2, 40),
    (3.13, 0.006, 0.0, 0.02, 1.00, 3, 40),
    (4.43, 0.0, 0.008, 0.0, 2.20, 10, 30),
]


def turning_points(omega0, dry, linear, quadratic, release, number):
    def acceleration(_, state, sign):
        theta, velocity = state
        loss = dry * sign + linear * velocity + quadratic * velocity * abs(velocity)
        return [velocity, -loss - omega0**2 * np.sin(theta)]

    def at_rest(_, state, sign):
        return state[1]

    at_rest.terminal = True
    points, time, theta = [(0.0, release)], 0.0, release
    while len(points) <= number:
        sign = -np.sign(theta)
        at_rest.direction = -sign
        # Away from rest by a short step, in which the acceleration is constant to a part in 1e10.
        start = -np.sign(theta) * abs(omega0**2 * np.sin(abs(theta)) - dry)
        step = 1e-6 / omega0
        state = [theta + 0.5 * start * step**2, start * step]
        found = solve_ivp(acceleration, (0, 60 / omega0), state, "DOP853", args=(sign,), events=at_rest, rtol=1e-12, atol=1e-13)
        time, theta = time + step + found.t_events[0][0], found.y_events[0][0][0]
        points.append((time, theta))
    return points


def main():
    print("# Turning points of damped pendulums, by reference/damped_amplitudes.py. MIT or Apache-2.0.")
    print("# case: number; omega0, dry, linear, quadratic: the equation; swing: swings since the release; time in s; angle in rad")
    print("case,omega0,dry,linear,quadratic,swing,time,angle")
    for case, (omega0, dry, linear, quadratic, release, skip, rows) in enumerate(CASES):
        points = turning_points(omega0, dry, linear, quadratic, release, skip * (rows - 1))
        for number in range(0, len(points), skip):
            time, theta = points[number]
            print(f"{case},{omega0},{dry},{linear},{quadratic},{number / 2:g},{time:.9f},{theta:.12f}")


if __name__ == "__main__":
    main()

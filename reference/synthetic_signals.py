"""Make examples/light_synthetic.csv and examples/acceleration_synthetic.csv: sensors that record continuously.

    python reference/synthetic_signals.py light > examples/light_synthetic.csv
    python reference/synthetic_signals.py acceleration > examples/acceleration_synthetic.csv

theta'' = -w0^2 sin(theta) - c theta' with w0 = 3.2 rad/s and c = 0.02 1/s, by Runge and Kutta with steps of 1 ms.
`light`: released from 0.2 rad, a ball of 40 mm on a pendulum of 0.958 m passes a light sensor of 4 mm below the pivot, which is
read 100 times a second. `acceleration`: a phone as the bob, released from 0.35 rad, its y axis along the string, read 50 times a
second. The seed is fixed; nothing but Python is needed.
"""

import math
import random
import sys

OMEGA0, DAMPING, GRAVITY = 3.2, 0.02, 9.81
LENGTH = GRAVITY / OMEGA0**2
STEP = 0.001


def acceleration(angle, velocity):
    return -(OMEGA0**2) * math.sin(angle) - DAMPING * velocity


def motion(release, duration):
    """Time, angle and velocity in steps of 1 ms."""
    time, angle, velocity = 0.0, release, 0.0
    for _ in range(round(duration / STEP)):
        yield time, angle, velocity
        a = [velocity, acceleration(angle, velocity)]
        b = [velocity + STEP / 2 * a[1], acceleration(angle + STEP / 2 * a[0], velocity + STEP / 2 * a[1])]
        c = [velocity + STEP / 2 * b[1], acceleration(angle + STEP / 2 * b[0], velocity + STEP / 2 * b[1])]
        d = [velocity + STEP * c[1], acceleration(angle + STEP * c[0], velocity + STEP * c[1])]
        angle += STEP / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
        velocity += STEP / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
        time += STEP


def light(rng):
    print("# Synthetic, not measured: the light below a pendulum of 0.958 m with a ball of 40 mm, released from 0.2 rad; g = 9.81 m/s^2.")
    print("# Made by reference/synthetic_signals.py.")
    print("Time (s),Illuminance (lx)")
    radius, half_width = 0.020, 0.002
    for time, angle, _ in list(motion(0.2, 20))[::10]:
        position = LENGTH * angle
        shadow = min(half_width, position + radius) - max(-half_width, position - radius)
        part = max(0.0, shadow) / (2 * half_width)
        print(f"{time:.2f},{312 * (1 - 0.93 * part) + rng.gauss(0, 2):.0f}")


def phone(rng):
    print("# Synthetic, not measured: a phone as the bob of a pendulum of 0.958 m, released from 0.35 rad; g = 9.81 m/s^2.")
    print("# Made by reference/synthetic_signals.py.")
    print("Time (s),Acceleration x (m/s^2),Acceleration y (m/s^2),Acceleration z (m/s^2)")
    for time, angle, velocity in list(motion(0.35, 20))[::20]:
        along = GRAVITY * math.cos(angle) + LENGTH * velocity**2
        across = GRAVITY * math.sin(angle) + LENGTH * acceleration(angle, velocity)
        noisy = [value + rng.gauss(0, 0.02) for value in (across, along, 0.0)]
        print(",".join([f"{time:.2f}", *(f"{value:.3f}" for value in noisy)]))


{"light": light, "acceleration": phone}[sys.argv[1]](random.Random(1656))

"""The request handling of every Python tool of motion.py: the protocol of ../src/requests.rs, and the equations."""
import math
import sys
import time


def serve(version, integrate):
    """Serves `version`, then requests; `integrate(case, tolerance, end, starts)` returns states, steps, seconds, set-up."""
    print(version, flush=True)
    for line in sys.stdin:
        case, tolerance, end, count = line.split()
        starts = [[float(word) for word in sys.stdin.readline().split()] for _ in range(int(count))]
        states, steps, seconds, set_up = integrate(case, float(tolerance), float(end), starts)
        print(seconds, steps, set_up)
        print("\n".join(" ".join(repr(float(value)) for value in state) for state in states), flush=True)


def timed(task, *arguments):
    """The processor time in seconds, and the result."""
    start = time.process_time()
    result = task(*arguments)
    return time.process_time() - start, result


def rates(case, sin=math.sin, cos=math.cos):
    """f(t, state), for numbers or formulas."""

    def pendulum(_, state):
        return [state[1], -sin(state[0])]

    def driven(time, state):
        return [state[1], 1.2 * cos(2 / 3 * time) - sin(state[0]) - state[1] / 2]

    def double(_, state):
        a, b, u, w = state
        sine, cosine = sin(a - b), cos(a - b)
        p = sine * w * w + 2 * sin(a)
        q = sine * u * u - sin(b)
        acceleration = -(p + cosine * q) / (1 + sine * sine)
        return [u, w, acceleration, q - cosine * acceleration]

    return {"pendulum": pendulum, "driven": driven, "double": double}[case]

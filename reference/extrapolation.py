"""Steps of a motion by extrapolation of the modified midpoint rule, in any floats.

W. B. Gragg, R. Bulirsch and J. Stoer; E. Hairer, S. P. Norsett and G. Wanner, Solving Ordinary Differential Equations I, section II.9.
Nothing here knows Taylor series.
"""


def midpoint(f, t, y, length, substeps):
    h = length / substeps
    before, now = y, [a + h * b for a, b in zip(y, f(t, y))]
    for n in range(1, substeps):
        slope = f(t + n * h, now)
        before, now = now, [a + 2 * h * b for a, b in zip(before, slope)]
    slope = f(t + length, now)
    return [(a + b + h * c) / 2 for a, b, c in zip(before, now, slope)]


class Extrapolation:
    """Steps are refined until two columns agree to the tolerance, and halved if the columns do not suffice."""

    def __init__(self, tolerance, columns):
        self.tolerance, self.columns = tolerance, columns

    def step(self, f, t, y, length):
        """The state a step later, or None when it is too long."""
        rows, number = [], type(self.tolerance)
        for k in range(self.columns):
            row = [midpoint(f, t, y, length, 2 * k + 2)]
            for j in range(1, k + 1):
                factor = number(k + 1) ** 2 / number(k + 1 - j) ** 2 - 1
                row.append([a + (a - b) / factor for a, b in zip(row[-1], rows[-1][j - 1])])
            if rows and max(abs(a - b) for a, b in zip(row[-1], row[-2])) < self.tolerance:
                return row[-1]
            rows.append(row)
        return None

    def advance(self, f, t, y, length):
        after = self.step(f, t, y, length)
        if after is not None:
            return after
        half = length / 2
        return self.advance(f, t + half, self.advance(f, t, y, half), half)

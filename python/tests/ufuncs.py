"""The ufuncs, and inputs within their domains."""

import numpy as np

import libration as lb

PENDULUM = [
    lb.period_ratio,
    lb.period_excess,
    lb.period_ratio_near_top,
    lb.period,
    lb.nome,
    lb.state,
    lb.motion,
]
SPECIAL = [getattr(lb.special, name) for name in lb.special.__all__]
ALL = PENDULUM + SPECIAL

_RANGES = {
    "period": [(0, 3.14), (0.1, 10), (1, 20)],
    "state": [(-50, 50), (-3.14, 3.14), (0.1, 10)],
    "motion": [(-50, 50), (-9, 9), (-9, 9), (0.1, 10)],
    "period_ratio": [(-3.14, 3.14)],
    "period_excess": [(-3.14, 3.14)],
    "period_ratio_near_top": [(1e-9, 3.14)],
    "nome": [(-3.14, 3.14)],
    "inverse_nome": [(0, 0.99)],
    "inverse_nome_kp": [(0, 0.99)],
}
_OTHERS = {1: [(0, 1)], 2: [(-20, 20), (0, 1)]}


def inputs(ufunc, shape=1000, seed=0):
    """Random arrays within the domain."""
    random = np.random.default_rng(seed)
    return [
        random.uniform(*limits, shape)
        for limits in _RANGES.get(ufunc.__name__) or _OTHERS[ufunc.nin]
    ]


def outputs(found):
    """The results of a ufunc, as a tuple."""
    return found if isinstance(found, tuple) else (found,)


def same(found, expected):
    """Bit for bit, NaN included."""
    for one, other in zip(outputs(found), outputs(expected), strict=True):
        np.testing.assert_array_equal(np.asarray(one), np.asarray(other), strict=True)

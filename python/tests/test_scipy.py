"""Replacements of SciPy's functions, for 0 ≤ m ≤ 1: the same arguments and results, and SciPy's own
tests.
"""

import mpmath as mp
import numpy as np
import pytest
import scipy.special

from libration import special
from truth import jacobi, ulps

NAMES = ["ellipk", "ellipkm1", "ellipe", "ellipkinc", "ellipeinc", "ellipj"]


@pytest.mark.parametrize("name", NAMES)
def test_same_arguments_and_results(name):
    ours, theirs = getattr(special, name), getattr(scipy.special, name)
    assert (ours.nin, ours.nout) == (theirs.nin, theirs.nout)
    random = np.random.default_rng(3)
    arguments = [random.uniform(-3, 3, 500)][: ours.nin - 1] + [random.uniform(0, 0.9, 500)]
    for one, other in zip(
        np.atleast_2d(ours(*arguments)), np.atleast_2d(theirs(*arguments)), strict=True
    ):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-14)


# What SciPy's own tests ask of these functions (scipy/special/tests/test_basic.py), the values by
# mpmath.
M = 0.68359375000000011
AROUND = [np.nextafter(M, 0), M, np.nextafter(M, 1)]
FACTS = [
    *((special.ellipk, mp.ellipk, (m,)) for m in (0.0, 0.2, 0.5, 1.0)),
    *((special.ellipe, mp.ellipe, (m,)) for m in (0.0, 0.2, 1.0)),
    *(
        (special.ellipkm1, lambda p: mp.pi / 2 / mp.agm(1, mp.sqrt(p)) if p else mp.inf, (p,))
        for p in (0.0, 1e-300, 1e-10, 0.5, 1.0)
    ),
    *(
        (special.ellipkinc, mp.ellipf, (phi, m))
        for phi, m in [
            (np.pi / 2, 0.2),
            (np.radians(38), np.sin(np.radians(20)) ** 2),
            (np.pi / 2, 0.0),
            (0.0, 0.5),
            (0.38974112035318718, 1.0),
        ]
    ),
    *(
        (special.ellipkinc, mp.ellipf, (0.9272952180016123 + shift, m))
        for m in AROUND
        for shift in (0.0, np.pi)
    ),
    *(
        (special.ellipkinc, mp.ellipf, (sign * phi, 1.0))
        for phi in (1e-300, 1e-9, 0.1, 1.0, 1.57, 1.5707963267948)
        for sign in (1, -1)
    ),
    *(
        (special.ellipeinc, mp.ellipe, (phi, m))
        for phi, m in [
            (np.pi / 2, 0.2),
            (np.radians(35), np.sin(np.radians(52)) ** 2),
            (np.pi / 2, 0.0),
            (np.pi / 2, 1.0),
            (0.0, 0.5),
            (0.0, 1.0),
        ]
    ),
    *(
        (special.ellipeinc, mp.ellipe, (0.9272952180016123 + shift, m))
        for m in AROUND
        for shift in (0.0, np.pi)
    ),
]


@pytest.mark.parametrize("ufunc, true, arguments", FACTS)
def test_facts_of_scipys_own_tests(ufunc, true, arguments):
    found, expected = ufunc(*arguments), true(*map(mp.mpf, arguments))
    assert ulps(found, expected) <= 4


@pytest.mark.parametrize(
    "u, m", [(0.2, 0.0), (0.0, 1.0), (0.2, 1.0), (0.2, 1 - 1e-9), (5.0, 1 - 1e-12), (0.1, 0.5)]
)
def test_facts_of_scipys_own_tests_of_jacobi_functions(u, m):
    for found, true in zip(special.ellipj(u, m), jacobi(u, m), strict=True):
        assert ulps(found, true) <= 4


def test_where_scipys_functions_leave_the_circle_ours_do_not():
    # Above m = 1 - 1e-10 SciPy has a series for small u alone.
    u, m = 25.0, 1 - 0.9e-10
    true = [float(x) for x in jacobi(u, m)]
    np.testing.assert_allclose(special.ellipj(u, m), true, rtol=1e-15)
    assert abs(scipy.special.ellipj(u, m)[1] - true[1]) > 0.1


def test_infinite_and_undefined_arguments():
    assert special.ellipk(1.0) == np.inf and special.ellipkm1(0.0) == np.inf
    assert special.ellipkinc([np.pi, -np.pi], 1.0).tolist() == [np.inf, -np.inf]
    with np.errstate(invalid="ignore"):
        for ufunc in (special.ellipk, special.ellipe, special.ellipkm1):
            assert np.isnan(ufunc([-1.0, 2.0, np.nan, np.inf])).all()

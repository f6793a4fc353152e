"""Values against mpmath, within the bounds that the docstrings state."""

import mpmath as mp
import numpy as np
import pytest

import libration as lb
import truth
from libration import special
from truth import ulps

RANDOM = np.random.default_rng(7)
# Random places, and those at which kernels change their way, two numbers around each.
ANGLES = np.concatenate(
    [
        RANDOM.uniform(0, np.pi, 60),
        10.0 ** RANDOM.uniform(-100, 0, 20),
        np.nextafter(np.pi / 2, [0, 2]),
        [np.pi / 2, np.pi],
    ]
)
UNIT = np.concatenate(
    [
        RANDOM.uniform(0, 1, 60),
        10.0 ** RANDOM.uniform(-300, 0, 20),
        1 - 10.0 ** RANDOM.uniform(-15, 0, 20),
        np.nextafter(0.5, [0, 1]),
        [0.0, 0.5, 1.0],
    ]
)
COMPLEMENTS = 10.0 ** np.append(RANDOM.uniform(-25, 0, 30), -25)


def worst(found, truths):
    return max(ulps(x, y) for x, y in zip(np.atleast_1d(found), truths, strict=True))


@pytest.mark.parametrize("ufunc, bound, values, true", [
    (lb.period_ratio, 0.56, ANGLES, truth.ratio),
    (lb.period_excess, 0.9, ANGLES, lambda x: excess(x)),
    (lb.period_ratio_near_top, 0.56, np.append(ANGLES, [1e-300, 2.3e-308]), truth.ratio_near_top),
    (lb.nome, 0.56, ANGLES, lambda x: nome_of_amplitude(x)),
    (special.ellipk, 0.56, UNIT, lambda m: truth.first(mp.sqrt(1 - mp.mpf(m)))),
    (special.ellipe, 0.56, UNIT, lambda m: mp.ellipe(mp.mpf(m))),
    (special.ellipkm1, 0.56, UNIT, lambda p: truth.first(mp.sqrt(mp.mpf(p)))),
    (special.ellipk_kp, 0.56, UNIT, lambda kp: truth.first(mp.mpf(kp))),
    (special.ellipe_kp, 0.56, UNIT, lambda kp: mp.ellipe(1 - mp.mpf(kp) ** 2)),
    (special.ellipnome, 0.56, UNIT[UNIT > 1e-290], lambda m: nome_of_parameter(m)),
    (special.ellipnome_kp, 0.56, UNIT[UNIT != 1], lambda kp: truth.nome(mp.mpf(kp))),
])
def test_functions_of_one_number(ufunc, bound, values, true):
    assert worst(ufunc(values), map(true, values)) <= bound


def excess(amplitude):
    with mp.workdps(280):
        return truth.ratio(amplitude) - 1


def nome_of_amplitude(amplitude):
    with mp.workdps(280):
        return truth.nome(mp.cos(mp.mpf(amplitude) / 2))


def nome_of_parameter(m):
    with mp.workdps(700):
        return truth.nome(mp.sqrt(1 - mp.mpf(m)))


def test_period_in_seconds():
    amplitude = ANGLES
    length = 10.0 ** RANDOM.uniform(-5, 5, len(ANGLES))
    gravity = RANDOM.uniform(1, 25, len(ANGLES))
    assert worst(
        lb.period(amplitude, length, gravity), map(truth.seconds, amplitude, length, gravity)
    ) <= 0.56
    wide = 10.0 ** RANDOM.uniform(-280, 280, 50)
    assert worst(
        lb.period(1.0, wide, 1 / wide), (truth.seconds(1.0, x, 1 / x) for x in wide)
    ) <= 0.56


@pytest.mark.parametrize(
    "ufunc, true", [(special.ellipkinc, mp.ellipf), (special.ellipeinc, mp.ellipe)]
)
def test_incomplete_integrals(ufunc, true):
    quarters = np.pi / 2 * np.arange(-3, 4)
    phi = np.concatenate(
        [
            RANDOM.uniform(-20, 20, 60),
            np.nextafter(quarters, -9),
            quarters,
            np.nextafter(quarters, 9),
        ]
    )
    m = RANDOM.uniform(0, 1, len(phi))
    m[60:] = 1 - 10.0 ** -RANDOM.integers(1, 12, len(phi) - 60)
    assert worst(ufunc(phi, m), (true(mp.mpf(x), mp.mpf(y)) for x, y in zip(phi, m))) <= 0.56
    assert worst(
        ufunc(np.linspace(-1.5, 1.5, 9), 1.0),
        (true(mp.mpf(x), 1) for x in np.linspace(-1.5, 1.5, 9)),
    ) <= 0.56


@pytest.mark.parametrize(
    "ufunc, by_parameter", [(special.ellipkinc_kp, mp.ellipf), (special.ellipeinc_kp, mp.ellipe)]
)
def test_incomplete_integrals_by_the_complementary_modulus(ufunc, by_parameter):
    phi = RANDOM.uniform(-1.5, 1.5, len(COMPLEMENTS))
    with mp.workdps(110):
        truths = [by_parameter(mp.mpf(x), 1 - mp.mpf(y) ** 2) for x, y in zip(phi, COMPLEMENTS)]
    assert worst(ufunc(phi, COMPLEMENTS), truths) <= 0.56


def within_jacobi_bound(found, truths, u):
    for values, u in zip(zip(*found), u):
        for value, true in zip(values, next(truths), strict=True):
            assert ulps(value, true) <= 2.2 + abs(u) * 2.0**-100 / np.spacing(abs(float(true)))


def test_jacobi_functions():
    u = np.concatenate(
        [RANDOM.uniform(-30, 30, 60), 10.0 ** RANDOM.uniform(-20, 0, 20), [0.0, 1e5]]
    )
    m = np.concatenate(
        [
            RANDOM.uniform(0, 1, 40),
            1 - 10.0 ** RANDOM.uniform(-16, 0, 36),
            [0.0, 1.0, 0.5, 0.5, 0.25, 0.75],
        ]
    )
    within_jacobi_bound(special.ellipj(u, m), (truth.jacobi(x, y) for x, y in zip(u, m)), u)


def test_jacobi_functions_by_the_complementary_modulus():
    u = RANDOM.uniform(-60, 60, len(COMPLEMENTS))
    with mp.workdps(110):
        truths = [truth.jacobi(x, 1 - mp.mpf(y) ** 2) for x, y in zip(u, COMPLEMENTS)]
    within_jacobi_bound(special.ellipj_kp(u, COMPLEMENTS), iter(truths), u)


def test_moduli_of_nomes():
    q = np.concatenate([RANDOM.uniform(0, 0.6, 30), 10.0 ** RANDOM.uniform(-100, 0, 10) / 2])
    assert worst(
        special.inverse_nome_kp(q),
        ((mp.jtheta(4, 0, mp.mpf(x)) / mp.jtheta(3, 0, mp.mpf(x))) ** 2 for x in q),
    ) <= 0.56
    assert worst(
        special.inverse_nome(q),
        ((mp.jtheta(2, 0, mp.mpf(x)) / mp.jtheta(3, 0, mp.mpf(x))) ** 4 for x in q),
    ) <= 0.56
    assert special.inverse_nome([0.0, 1.0]).tolist() == [0.0, 1.0]
    assert special.inverse_nome_kp([0.0, 1.0]).tolist() == [1.0, 0.0]


def within_motion_bound(found, truths, t):
    for angle, velocity, (true_angle, true_velocity), t in zip(*found, truths, t, strict=True):
        slack = 4 * 2.0**-53 * abs(t)
        size, speed = abs(float(true_angle)), abs(float(true_velocity))
        assert ulps(angle, true_angle) <= 2.2 + slack * speed / np.spacing(size)
        # |θ''| is at most the squared frequency, which is 9.
        assert ulps(velocity, true_velocity) <= 2.2 + slack * 9 / np.spacing(speed)


def test_states_released_from_rest():
    t = RANDOM.uniform(-50, 50, 60)
    amplitude = np.concatenate(
        [RANDOM.uniform(-np.pi, np.pi, 56), [3.14159, np.pi / 2, 1e-9, -1e-100]]
    )
    truths = [released(x, y, 3) for x, y in zip(t, amplitude)]
    within_motion_bound(lb.state(t, amplitude, 3.0), truths, t)
    within_motion_bound(lb.motion(t, amplitude, 0.0, 3.0), truths, t)


def released(t, amplitude, omega0):
    k, kp = mp.sin(mp.mpf(amplitude) / 2), mp.cos(mp.mpf(amplitude) / 2)
    with mp.workdps(250):
        sn, cn, dn, _ = truth.jacobi(mp.mpf(t) * omega0, k * k)
        return 2 * mp.asin(k * cn / dn), -2 * omega0 * k * kp * sn / dn


def test_motions_of_any_start():
    t, angle = RANDOM.uniform(-20, 20, 80), RANDOM.uniform(-9, 9, 80)
    velocity = RANDOM.uniform(-12, 12, 80)
    within_motion_bound(
        lb.motion(t, angle, velocity, 3.0),
        [truth.motion(*row, 3) for row in zip(t, angle, velocity)],
        t,
    )


def test_motions_released_in_another_turn_swing_about_its_bottom():
    t, angle = RANDOM.uniform(-20, 20, 12), np.array([4.0, -4.0, 7.0, 20.0] * 3)
    within_motion_bound(
        lb.motion(t, angle, 0.0, 3.0), [truth.motion(*row, 0, 3) for row in zip(t, angle)], t
    )


def test_motions_turn_over_where_the_energy_is_enough():
    assert abs(lb.motion(100.0, 0.0, 5.99, 3.0)[0]) < np.pi
    assert lb.motion(100.0, 0.0, 6.01, 3.0)[0] > 10
    angle, velocity = lb.motion(2.0, 0.0, 6.0, 3.0)
    assert ulps(angle, 4 * mp.atan(mp.exp(6)) - mp.pi) <= 2.2
    assert ulps(velocity, 6 / mp.cosh(6)) <= 2.2

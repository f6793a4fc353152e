"""The catalogue of period formulas."""

import pickle

import mpmath as mp
import numpy as np
import pytest

import libration as lb
from truth import ratio, ulps

WRITTEN_OUT = {
    "small_angle": lambda a: mp.mpf(1),
    "bernoulli": lambda a: 1 + a**2 / 16,
    "power_series_2": lambda a: 1 + a**2 / 16 + 11 * a**4 / 3072,
    "kidd_fogg": lambda a: 1 / mp.sqrt(mp.cos(a / 2)),
    "lima_arun": lambda a: mp.log(mp.cos(a / 2)) / (mp.cos(a / 2) - 1),
}


@pytest.mark.parametrize("key", WRITTEN_OUT)
def test_ratios_and_errors_are_those_of_the_formula_written_out(key):
    formula = lb.formulas[key]
    for amplitude in (1e-3, 0.5, 2.0):
        value = WRITTEN_OUT[key](mp.mpf(amplitude))
        assert ulps(formula.ratio(amplitude), value) <= 4
        assert ulps(formula.error(amplitude), value / ratio(amplitude) - 1) <= 1


def test_amplitudes_are_numbers_texts_or_arrays():
    formula = lb.formulas["bernoulli"]
    degrees = np.array([[10.0, 60.0], [90.0, 179.0]])
    found = formula.error(np.radians(degrees))
    assert found.shape == (2, 2)
    for one, many in zip(np.radians(degrees).ravel(), found.ravel()):
        assert formula.error(float(one)) == many
    assert formula.error("60deg") == pytest.approx(found[0, 1], rel=1e-14)
    assert formula.ratio([0.0, 1.0]).tolist() == [1.0, 1.0625]
    assert np.isnan(formula.ratio(3.5)) and np.isinf(lb.formulas["cubic_force"].error(3.0))


def test_the_catalogue_is_a_mapping():
    assert len(lb.formulas) == len(list(lb.formulas)) >= 30
    assert "bernoulli" in lb.formulas
    assert "x" not in lb.formulas
    for key, formula in lb.formulas.items():
        assert formula.key == key and formula.latex in formula._repr_latex_() and formula.source
        assert pickle.loads(pickle.dumps(formula)) == formula
    assert lb.formulas["power_series_40"].error(1.0) == pytest.approx(0, abs=1e-15)
    assert "bernoulli" in repr(lb.formulas)
    assert len({lb.formulas["molina"], lb.formulas["molina"]}) == 1


def test_the_best_formula_is_the_simplest_that_keeps_the_tolerance():
    best = lb.formulas.best(amplitude="90deg", tolerance=1e-3)
    others = lb.formulas.simplest("90deg", 1e-3)
    assert others[0] == best and all(abs(it.error("90deg")) <= 1e-3 for it in others)
    assert all(best.complexity <= it.complexity for it in others)
    simpler = [it for it in lb.formulas.values() if it.complexity < best.complexity]
    assert simpler and all(abs(it.worst_error("90deg")[0]) > 1e-3 for it in simpler)
    with pytest.raises(lb.errors.FormulaError, match="give a larger tolerance"):
        lb.formulas.best("179deg", 1e-30)
    with (
        pytest.raises(lb.errors.FormulaError, match="got 60.0 rad, .*°, and swings stay below pi"),
        pytest.warns(UserWarning, match="for degrees write 60deg"),
    ):
        lb.formulas.best(60, 1e-3)


def test_where_a_tolerance_is_kept():
    formula = lb.formulas["bernoulli"]
    end = formula.holds_to(1e-3)
    assert abs(formula.error(end)) == pytest.approx(1e-3, rel=1e-9)
    error, place = formula.worst_error("90deg")
    assert place == pytest.approx(np.pi / 2) and error == pytest.approx(formula.error("90deg"))


def test_unknown_keys_are_refused_with_the_nearest():
    for kind in (KeyError, ValueError, lb.LibrationError):
        with pytest.raises(
            kind, match="no formula has the key `bernouli`; the nearest are bernoulli"
        ):
            lb.formulas["bernouli"]

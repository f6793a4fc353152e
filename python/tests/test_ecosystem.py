"""Arrays of other packages."""

import numpy as np
import pytest

import libration as lb
from ufuncs import ALL, inputs, outputs, same

SINGLE = [ufunc for ufunc in ALL if ufunc.nout == 1]
SEVERAL = [ufunc for ufunc in ALL if ufunc.nout > 1]


@pytest.mark.parametrize("ufunc", SINGLE)
def test_dask_stays_lazy_and_finds_the_same(ufunc):
    dask = pytest.importorskip("dask.array")
    arguments = inputs(ufunc)
    found = ufunc(*(dask.from_array(x, chunks=300) for x in arguments))
    assert isinstance(found, dask.Array) and found.npartitions == 4
    same(found.compute(), ufunc(*arguments))


@pytest.mark.parametrize("ufunc", SEVERAL)
def test_several_results_go_through_apply_gufunc(ufunc):
    dask = pytest.importorskip("dask.array")
    arguments = inputs(ufunc)
    signature = ",".join(["()"] * ufunc.nin) + "->" + ",".join(["()"] * ufunc.nout)
    found = dask.apply_gufunc(
        ufunc,
        signature,
        *(dask.from_array(x, chunks=300) for x in arguments),
        output_dtypes=[float] * ufunc.nout,
    )
    same(tuple(x.compute() for x in found), ufunc(*arguments))


@pytest.mark.parametrize("ufunc", ALL)
def test_xarray_keeps_its_coordinates(ufunc):
    xarray = pytest.importorskip("xarray")
    arguments = inputs(ufunc, 50)
    given = [xarray.DataArray(x, dims="i", coords={"i": np.arange(50)}) for x in arguments]
    found = outputs(xarray.apply_ufunc(ufunc, *given, output_core_dims=[[]] * ufunc.nout))
    direct = outputs(ufunc(*given))
    for one, other, expected in zip(found, direct, outputs(ufunc(*arguments)), strict=True):
        assert one.identical(other) and one.coords["i"].size == 50
        same(other.values, expected)


def test_xarray_with_chunks_stays_lazy():
    xarray = pytest.importorskip("xarray")
    given = xarray.DataArray(np.linspace(0, 3, 100), dims="amplitude").chunk(25)
    found = lb.period_ratio(given)
    assert found.chunks == ((25,) * 4,)
    same(found.values, lb.period_ratio(np.linspace(0, 3, 100)))


@pytest.mark.parametrize("ufunc", SINGLE)
def test_pandas_keeps_its_index(ufunc):
    pandas = pytest.importorskip("pandas")
    arguments = inputs(ufunc, 5)
    found = ufunc(*(pandas.Series(x, index=list("abcde")) for x in arguments))
    assert list(found.index) == list("abcde")
    same(found.to_numpy(), ufunc(*arguments))


def test_pint_goes_through_a_wrapper():
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    period = units.wraps("s", ("radian", "m", "m/s^2"))(lambda a, l, g: lb.period(a, l, g))
    found = period(
        units.Quantity([60.0], "degree"), units.Quantity(99.4, "cm"), units.Quantity(9.81, "m/s^2")
    )
    assert found.units == units.second
    same(found.magnitude, lb.period(np.radians([60.0]), 0.994, 9.81))
    with pytest.raises(TypeError):
        lb.period_ratio(units.Quantity(60.0, "degree"))

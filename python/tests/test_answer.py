"""Answers as objects: frozen mappings that pickle, copy, compare, print, and are drawn."""

import copy
import json
import pickle
from collections.abc import Mapping

import numpy as np
import pytest

import libration as lb
from interruption import interrupted_after
from libration import questions


@pytest.fixture
def decay():
    return lb.decay("60deg", linear=0.1, cycles=2)


def test_they_are_mappings_over_the_json(decay):
    assert isinstance(decay, Mapping) and list(decay)[:2] == ["schema", "length_m"]
    assert dict(decay) == decay.to_dict()
    assert json.loads(json.dumps(decay.to_dict())) == decay.to_dict()
    changed = decay.to_dict()
    changed["turning_points"].clear()
    assert len(decay.turning_points) == 5


def test_they_do_not_change(decay):
    for thing in (decay, decay.damping[0], decay.turning_points):
        with pytest.raises(AttributeError, match="cannot be changed"):
            thing.length_m = 2
        with pytest.raises((AttributeError, TypeError)):
            del thing.length_m
        with pytest.raises(TypeError):
            hash(thing)


def test_they_pickle_copy_and_compare(decay):
    fit = lb.lab.fit_periods(
        {"amplitude (deg)": [10, 30, 50, 70], "period (s)": [2.0075, 2.0399, 2.1033, 2.2054]},
        length="1 m ± 1cm",
    )
    paper = lb.paper("cote")
    for thing in (decay, fit, paper, decay.damping[0], decay.turning_points):
        for other in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
            assert other == thing and type(other) is type(thing)
    assert decay != lb.decay("60deg", linear=0.2, cycles=2) and decay != dict(decay)
    assert str(pickle.loads(pickle.dumps(fit)).g) == str(fit.g)


def test_they_print_well(decay):
    assert repr(decay).startswith("Answer(schema=2, length_m=1.0")
    assert "turning_points=[…5]" in repr(decay)
    assert repr(decay.turning_points).startswith("<5 rows of cycle, time_s")
    page = decay._repr_html_()
    assert "<td>length_m</td><td>1</td><td>m</td>" in page and "<th>amplitude_rad</th>" in page
    hostile = lb.Answer({"title": "<script>"}, decay._asked)._repr_html_()
    assert "<script>" not in hostile and "&lt;script&gt;" in hostile
    assert "schema" in dir(decay) and "time_s" in dir(decay.turning_points)


def test_html_tables_of_many_rows_are_short():
    answer = questions.motion("60deg", times="0:100:0.1")
    assert answer._repr_html_().count("<tr>") < 40
    assert "1001 rows, of which the first 12 are shown" in answer._repr_html_()


def test_the_picture_of_the_command_is_there_too(decay, tmp_path):
    picture = decay.picture(size="column")
    assert picture.svg.startswith("<svg")
    assert picture._repr_svg_() == picture.svg
    assert "bytes of SVG" in repr(picture)
    picture.save(tmp_path / "decay.svg")
    assert (tmp_path / "decay.svg").read_text() == picture.svg
    picture.save(tmp_path / "decay.pdf")
    assert (tmp_path / "decay.pdf").read_bytes().startswith(b"%PDF-")


def test_the_picture_of_the_command_is_laid_out_for_a_journal(decay):
    usual = decay.picture().svg
    assert 'class="title"' in usual and "degrees<" in usual
    laid_out = decay.picture(no_title=True, curve_labels=True, angles="radians").svg
    assert 'class="title"' not in laid_out and "rad<" in laid_out


def test_series_are_drawn():
    pytest.importorskip("matplotlib").use("agg")
    series = lb.expand("pendulum", order=9)
    ax = series.plot(amplitudes=np.linspace(0, 2, 11))
    assert [line.get_label() for line in ax.lines] == ["to A^2", "to A^4", "to A^6", "to A^8"]
    assert ax.lines[0].get_ydata()[-1] == 1 - 4 / 16
    with pytest.raises(lb.errors.ExpansionError, match="symbols"):
        lb.expand("x'' + x + a*x^3 = 0", order=3).plot()


def test_ctrl_c_leaves_what_is_done():
    caught = interrupted_after(
        0.5,
        lambda: lb.section(
            "driven_pendulum",
            set={"A": 1.5, "c": 0.5},
            initial={"theta": 0.2},
            points=1_000_000,
            skip=1,
        ),
    )
    assert caught.partial["complete"] is False and 0 < len(caught.partial.points) < 1_000_000


def test_progress_is_told_in_words():
    told = []

    def tell(how_far):
        told.append(how_far)
        if len(told) == 2:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        lb.section(
            "driven_pendulum",
            set={"A": 1.5, "c": 0.5},
            initial={"theta": 0.2},
            points=10_000_000,
            skip=1,
            progress=tell,
        )
    assert len(told) == 2 and all("point" in it for it in told)


def test_columns_of_lists_go_to_pandas_and_xarray():
    pytest.importorskip("pandas")
    xarray = pytest.importorskip("xarray")
    modes = lb.modes("double_pendulum")
    assert modes.to_pandas()["shape"].tolist()[0].tolist() == modes["modes"][0]["shape"]
    assert isinstance(modes.to_xarray(), xarray.Dataset)
    assert modes.to_xarray()["shape"].dims == ("row", "shape_1")


def test_a_missing_field_names_those_that_exist():
    with pytest.raises(KeyError, match="no field `nothing`: there are schema, length_m"):
        lb.questions.period("60deg")["nothing"]

"""The names of arguments, as `inspect.signature` shows them."""

import inspect
import re

import numpy as np
import pytest
import scipy.special

import libration as lb
from libration import _ufuncs
from test_scipy import NAMES
from ufuncs import ALL

is_told = pytest.mark.skipif(
    not hasattr(np.sin, "__dict__"), reason="ufuncs of this NumPy take no attributes"
)


@is_told
@pytest.mark.parametrize("name", NAMES)
def test_arguments_have_the_names_of_scipy(name):
    theirs = re.search(rf"{name}\((.*?), out=None\)", getattr(scipy.special, name).__doc__)[1]
    parameters = inspect.signature(getattr(lb.special, name)).parameters.values()
    ours = [it.name for it in parameters if it.kind is it.POSITIONAL_ONLY]
    assert ours == theirs.split(", ")


@is_told
@pytest.mark.parametrize("ufunc", ALL)
def test_signatures_of_ufuncs_are_those_of_calls(ufunc):
    parameters = inspect.signature(ufunc).parameters
    named = [it.name for it in parameters.values() if it.kind is it.POSITIONAL_ONLY]
    assert named == _ufuncs.arguments(ufunc) and len(named) == ufunc.nin
    options = {name: it.default for name, it in parameters.items() if name not in named}
    options |= {"dtype": float}
    del options["signature"]
    values = [0.5] * ufunc.nin
    assert np.array_equal(ufunc(*values, **options), ufunc(*values))


def public():
    """The functions and the methods that the package offers."""
    for module in (lb, lb.special, lb.lab, lb.figure, lb.questions):
        for item in (getattr(module, name) for name in module.__all__):
            methods = vars(item).values() if inspect.isclass(item) else []
            own = [item] if inspect.isfunction(item) else []
            yield from (it for it in [*own, *methods] if is_public(it))


def is_public(item):
    return inspect.isfunction(item) and not re.match("_[^_]", item.__name__)


# What takes any number of amplitudes or of names of variables.
MANY = {"Pendulum.to_dict", "Simulation.plot", "Polynomial.__call__", "Series.__call__"}
# What takes the parameters of another function of the package.
OF_ANOTHER = {"read": lb.questions.inspect, "spectrum": lb.questions.inspect, "sweep": None}


def test_arguments_are_named():
    kinds = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
    found = {
        it.__qualname__
        for it in public()
        if any(own.kind in kinds for own in inspect.signature(it).parameters.values())
    }
    assert found == MANY | OF_ANOTHER.keys()
    for name, other in OF_ANOTHER.items():
        function = getattr(lb.lab, name, None) or getattr(lb, name)
        of = "libration.questions" + (f".{other.__name__}" if other else "")
        assert f"`{of}`" in function.__doc__ or "as for `read`" in function.__doc__

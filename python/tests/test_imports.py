"""Imports of the package: no cycle among its modules, none of which is imported before its use."""

import ast
import inspect
import subprocess
import sys
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import libration as lb
from libration import questions

PACKAGE = Path(lb.__file__).parent
PATHS = {it.relative_to(PACKAGE.parent).with_suffix(""): it for it in PACKAGE.rglob("*.py")}
MODULES = {".".join(it.parts).removesuffix(".__init__"): path for it, path in PATHS.items()}
OTHERS = {"pandas", "matplotlib", "scipy", "xarray", "sympy", "uncertainties", "dask", "zarr"}
# What is not at hand everywhere and takes long to import.
LATER = {("libration.pendulum", "libration.swing")}


def is_for_checkers(node):
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def imports(node, in_functions):
    """The import statements below a node that run with the module, or in its functions."""
    for it in node.orelse if is_for_checkers(node) else ast.iter_child_nodes(node):
        is_function = isinstance(it, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
        if isinstance(it, (ast.Import, ast.ImportFrom)):
            yield from [] if in_functions else [it]
        elif is_function and in_functions:
            yield from imports(it, False)
        elif not is_function:
            yield from imports(it, in_functions)


def imported(name, statement):
    """The modules of the package that an import statement of a module of this name imports."""
    if isinstance(statement, ast.Import):
        return {it.name for it in statement.names} & MODULES.keys()
    package = name if MODULES[name].name == "__init__.py" else name.rpartition(".")[0]
    parts = package.split(".")
    above = parts[: len(parts) + 1 - statement.level] if statement.level else []
    source = ".".join([*above, *([statement.module] if statement.module else [])])
    if source not in MODULES:
        return set()
    found = {f"{source}.{it.name}" for it in statement.names} & MODULES.keys()
    return found if len(found) == len(statement.names) else found | {source} - {"libration"}


def graph(in_functions=False):
    """The modules that each module of the package imports."""
    trees = {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in MODULES.items()}
    return {
        name: set().union(*(imported(name, it) for it in imports(tree, in_functions)))
        for name, tree in trees.items()
    }


def test_modules_import_each_other_in_no_cycle():
    found = graph()
    assert found["libration.expansion"] >= {"libration._ask", "libration.questions"}
    assert found["libration.lab"] >= {"libration.fit"}
    try:
        TopologicalSorter(found).prepare()
    except CycleError as error:
        pytest.fail(" → ".join(error.args[1][::-1]))


def test_functions_import_what_other_packages_have():
    found = {(name, other) for name, others in graph(in_functions=True).items() for other in others}
    assert found == LATER


def modules_after(code):
    """The modules of a new process that has run a line of code."""
    line = f"{code}; import sys; print(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", line], capture_output=True, text=True, check=True)
    return set(found.stdout.split())


def test_the_package_imports_its_modules_when_they_are_used():
    found = modules_after("import libration")
    assert "libration._native" in found
    assert not [it for it in found if it.startswith("libration.questions")]
    assert not found & OTHERS
    found = modules_after("import libration; libration.decay")
    questions_there = {it for it in found if it.startswith("libration.questions.")}
    assert questions_there == {"libration.questions._decay"}
    assert not found & OTHERS


def names_for_checkers(path):
    """The names that a type checker finds in each module."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    found = [it for node in tree.body if is_for_checkers(node) for it in node.body]
    return {name.name: it.module for it in found for name in it.names}


@pytest.mark.parametrize("module", [lb, questions])
def test_type_checkers_find_the_names_that_there_are(module):
    for name, source in names_for_checkers(Path(module.__file__)).items():
        item = getattr(module, name)
        home = sys.modules[f"{module.__name__}.{source}" if source else f"{module.__name__}.{name}"]
        assert item is (getattr(home, name) if source else home)
    assert set(names_for_checkers(Path(module.__file__))) <= set(module.__all__)
    assert set(module.__all__) <= set(dir(module))
    assert set(dict(inspect.getmembers(module))) >= set(module.__all__)


def test_a_star_brings_all_names():
    names = {}
    exec("from libration import *", names)
    assert set(lb.__all__) <= names.keys() and names["decay"] is lb.decay is questions.decay


@pytest.mark.parametrize(
    "name",
    sorted(
        it for it in MODULES if it.count(".") == 1 and "._" not in it and not it.endswith("swing")
    ),
)
def test_modules_are_attributes_of_the_package(name):
    found = subprocess.run(
        [sys.executable, "-c", f"import libration; print({name}.__name__)"],
        capture_output=True,
        text=True,
    )
    assert found.stdout.strip() == name, found.stderr


def test_a_name_that_is_not_there_is_an_attribute_error():
    with pytest.raises(AttributeError, match="'libration' has no attribute 'expnd'") as caught:
        lb.expnd
    assert (caught.value.name, caught.value.obj) == ("expnd", lb)
    with pytest.raises(ImportError, match="cannot import name 'expnd' from 'libration'"):
        from libration import expnd  # noqa: F401

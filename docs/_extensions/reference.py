"""The reference has every public name of the package, or the build warns of it; signatures say what a reader may give."""

import inspect
import re
import sys

import numpy as np
from sphinx.util import logging

import libration
from libration._ufuncs import arguments

LOG = logging.getLogger(__name__)


def setup(app):
    app.connect("autodoc-process-signature", signature, priority=100)  # before numpydoc
    app.connect("autodoc-process-docstring", keep_formulas, priority=100)  # before numpydoc
    app.connect("autodoc-process-docstring", begin_with_type, priority=900)  # after it
    app.connect("env-check-consistency", warn_of_missing_names)
    return {"parallel_read_safe": True}


def signature(app, what, name, obj, options, given, answer):
    """Ufuncs with their own arguments, and classes that a function makes without any."""
    if isinstance(obj, np.ufunc):
        return f"({', '.join(arguments(obj))}, /, **kwargs)", None
    if what == "class" and "\nParameters\n" not in inspect.getdoc(obj):
        return "", None
    return None


def keep_formulas(app, what, name, obj, options, lines):
    """Bars, stars and backslashes belong to formulas and are no markup."""
    is_example = False
    for i, line in enumerate(lines):
        is_example = bool(line.strip()) and (is_example or line.lstrip().startswith(">>>"))
        if not is_example:
            parts = line.split("``")
            parts[::2] = [re.sub(r"[|\\]|(?<!\*)\*(?!\*)", r"\\\g<0>", part) for part in parts[::2]]
            lines[i] = "``".join(parts)


def begin_with_type(app, what, name, obj, options, lines):
    """Fields and properties begin with their type."""
    kind, _, member = name.rpartition(".")
    module, _, kind = kind.rpartition(".")
    of = getattr(sys.modules.get(module), kind, None)
    if not lines or not inspect.isclass(of) or what not in ("attribute", "property"):
        return
    getter = getattr(vars(of).get(member), "fget", None)
    types = inspect.get_annotations(getter or of)
    annotation = types.get("return" if getter else member)
    if annotation is not None:
        lines[0] = f"*{short(annotation)}* – {lines[0]}"


def short(annotation):
    """A type as people write it: without modules, and without what NumPy says of shapes."""
    text = annotation if isinstance(annotation, str) else inspect.formatannotation(annotation)
    return re.sub(r"(\w+\.)+", "", re.sub(r"ndarray\[.*?\]\]", "ndarray", text)).replace("NoneType", "None").replace("'", "")


def warn_of_missing_names(app, env):
    listed = {entry[0] for entry in env.get_domain("py").get_objects()}
    for name in sorted(set(public_names(libration)) - listed):
        LOG.warning("%s has no entry in the pages of docs/reference", name, type="reference")


def public_names(module):
    """The objects of a module under names that can be documented: of objects that an outer module offers too, the outer name alone."""
    for name in set(module.__all__) - {"__version__"}:
        item = getattr(module, name)
        full = f"{module.__name__}.{name}"
        if inspect.ismodule(item):
            yield from public_names(item)
        elif module is libration or getattr(libration, name, None) is not item:
            yield full
            if inspect.isclass(item):
                yield from (f"{full}.{member}" for member in [*vars(item), *inspect.get_annotations(item)] if not member.startswith("_"))

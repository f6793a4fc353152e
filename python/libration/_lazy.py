"""Names of a package whose modules are imported at their first use (PEP 562)."""

import sys
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from typing import Any


def lazily(
    package: str, names: Mapping[str, Iterable[str]]
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """The `__getattr__` and the `__dir__` of a package, from the names in each of its modules.

    Modules themselves are found too, and each name is looked up once.
    """
    module_of = {name: module for module, own in names.items() for name in own}
    known = vars(sys.modules[package])

    def find(name: str) -> Any:
        if name in module_of:
            known[name] = getattr(import_module(f"{package}.{module_of[name]}"), name)
            return known[name]
        if name in names:
            return import_module(f"{package}.{name}")
        message = f"module {package!r} has no attribute {name!r}"
        raise AttributeError(message, name=name, obj=sys.modules[package])

    def listed() -> list[str]:
        return sorted({*known, *module_of, *names})

    return find, listed

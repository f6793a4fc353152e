"""Names of symbols and functions of SymPy, as formulas of the package have them."""

import re
from typing import Any

from .errors import UsageError

# As `letters.rs` of libration-numbers has them.
_GREEK = dict(
    zip(
        "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΣΦΨΩϵϑµϕ",
        (
            "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma "
            "tau upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Sigma Phi Psi Omega "
            "epsilon theta mu phi"
        ).split(),
    )
)
_COMMANDS = {"varepsilon": "epsilon", "vartheta": "theta", "varphi": "phi"}
FUNCTIONS = tuple("sqrt sin cos tan asin acos atan sinh cosh tanh exp ln abs sign".split())
"""The functions of formulas."""
_TAKEN = {*FUNCTIONS, "arcsin", "arccos", "arctan", "log", "sgn", "pi"}
_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_BRACES = r"_\{[A-Za-z0-9]+\}"
_WORD = rf"[A-Za-z](?:{_BRACES}|[A-Za-z0-9_₀-₉])*"
# After a Greek letter other letters are separate names, except in an index.
_LETTER = (
    rf"(?:\\[A-Za-z]+|[{''.join(_GREEK)}])(?:{_BRACES}|[0-9₀-₉])*"
    rf"(?:_(?:{_BRACES}|[A-Za-z0-9_₀-₉])*)?"
)
_NAME = re.compile(rf"(?:{_WORD}|{_LETTER})(?:\[[0-9]+\])?")


def name_in_formulas(given: Any, name: str) -> str:
    """The name of a symbol or function as formulas print it: ``omega0`` for ``ω₀``.

    Raises
    ------
    UsageError
        A name that formulas read as something else, such as ``pi``, ``k+1`` or ``a b``.
    """
    found = _read(name)
    if found is not None and found not in _TAKEN:
        return found
    if found is not None:
        reason = "is a number in formulas" if found == "pi" else "is a function in formulas"
    elif name.endswith("'"):
        reason = "is read as a derivative, which is x(t).diff(t) of a function"
    else:
        reason = "is not one name in formulas, a letter of Latin or Greek with letters, digits or _"
    raise UsageError(
        f"`{given}` of SymPy {reason}: give it another name, such as {_similar(name)}"
    )


def _read(name: str) -> str | None:
    """The name as formulas print it; None for what is not one name."""
    if not _NAME.fullmatch(name):
        return None
    command = re.match(r"\\([A-Za-z]+)", name)
    if command:
        letter, rest = _COMMANDS.get(command[1], command[1]), name[command.end() :]
        if letter not in _GREEK.values():
            return None
    elif name[0] in _GREEK:
        letter, rest = _GREEK[name[0]], name[1:]
    else:
        letter, rest = "", name
    rest = re.sub(r"\[([0-9]+)\]", r"\1", rest.translate(_DIGITS))
    return letter + re.sub(r"_\{(\w+)\}", r"_\1", rest)


def _similar(name: str) -> str:
    words = re.findall(r"[A-Za-z0-9]+", "".join(_GREEK.get(it, it) for it in name))
    found = "_".join(words)
    if not found[:1].isalpha():
        return "k"
    return f"{found}_1" if found in _TAKEN or found == name.rstrip("'") else found

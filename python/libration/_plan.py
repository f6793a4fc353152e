"""The plan of a sweep: its command, the numbers kept, and its chunks in a store.

A chunk can be computed on any machine.
"""

import json
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from . import _native, _zarr
from ._zarr import Variable
from .errors import NoAnswer


@dataclass(frozen=True)
class Plan:
    """The command of a sweep and the numbers kept: enough to compute any of its chunks anywhere."""

    text: str
    """The plan as the library writes it."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "_fields", json.loads(self.text))

    def __getitem__(self, name: str) -> Any:
        return self.__dict__["_fields"][name]

    @property
    def pieces(self) -> tuple[int, ...]:
        """Number of chunks along each axis."""
        return tuple(-(-length // own) for length, own in zip(self["shape"], self["chunk_shape"]))

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return int(np.prod(self.pieces))

    def place(self, number: int) -> tuple[int, ...]:
        """The index of a chunk along each axis."""
        return tuple(int(it) for it in np.unravel_index(number, self.pieces))

    def block(self, number: int) -> tuple[int, ...]:
        """Number of values of a chunk along each axis."""
        cut = zip(self.place(number), self["chunk_shape"], self["shape"])
        return tuple(min(own, length - place * own) for place, own, length in cut)

    def is_done(self, store: Path, number: int) -> bool:
        """True if a chunk is in the store: its status is written last."""
        return (store / self.answers()[-1].file(self.place(number))).exists()

    def answers(self) -> list[Variable]:
        """The variables that each chunk has a part of."""
        names = tuple(axis["name"] for axis in self["axes"])
        shape, chunk = tuple(self["shape"]), tuple(self["chunk_shape"])
        variables = []
        for field in self["fields"]:
            entries = () if field["length"] is None else (field["length"],)
            further = (f"{field['name']}_number",) if entries else ()
            about = {"units": field["unit"], "long_name": field["meaning"], "path": field["path"]}
            about = {name: text for name, text in about.items() if text}
            lengths = (shape + entries, chunk + entries)
            variables.append(Variable(field["name"], names + further, *lengths, "float64", about))
        flags = {
            "long_name": "outcome of the point",
            "flag_values": [-1, 0, 1, 2],
            "flag_meanings": "not_asked_yet answer no_answer not_understood",
        }
        why = {"long_name": "reason why there is no result"}
        variables.append(Variable("message", names, shape, chunk, "string", why))
        variables.append(Variable("status", names, shape, chunk, "int8", flags))
        return variables

    def coordinates(self) -> list[tuple[Variable, Any]]:
        """The axes with their values."""
        coordinates = []
        for axis in self["axes"]:
            values = axis["values"] if axis["numbers"] is None else axis["numbers"]
            kind = "string" if axis["numbers"] is None else "float64"
            about = {"units": axis["unit"]} if axis["unit"] else {}
            name, length = axis["name"], (len(values),)
            coordinates.append((Variable(name, (name,), length, length, kind, about), values))
        return coordinates

    def about(self) -> dict[str, Any]:
        """Provenance of the results."""
        question = shlex.join(["libration", *self["question"]])
        own = {name: self[name] for name in ("version", "format")}
        return {"question": question, **own, "source": "libration sweep"}


def begin(plan: Plan, store: Path) -> None:
    """Writes the beginning of a store; a store that holds something else is refused."""
    files = _zarr.group([*(it for it, _ in plan.coordinates()), *plan.answers()], plan.about())
    for variable, values in plan.coordinates():
        files = {variable.file([0]): variable.encoded(values), **files}
    is_begun = any((store / path).exists() for path in ("zarr.json", next(iter(files))))
    if not is_begun and any(place.is_file() for place in store.rglob("*")):
        raise NoAnswer(f"{store} contains something other than a sweep: give a new directory")
    for path, content in files.items():
        place = store / path
        if not place.exists():
            _zarr.write(store, path, content)
        elif place.read_bytes() != content:
            difference = _difference(store, plan)
            raise NoAnswer(f"{store} holds another sweep: {difference}; give another directory")


def _difference(store: Path, plan: Plan) -> str:
    try:
        about = json.loads((store / "zarr.json").read_bytes())["attributes"]
    except (OSError, ValueError, KeyError):
        return "its metadata cannot be read"
    for name, own in plan.about().items():
        if about.get(name) != own:
            return f"its {name} is {about.get(name)!r}, not {own!r}"
    return "its axes, its chunks or what it keeps are different"


def answer_chunk(plan: Plan, store: Path, number: int, go_on: Any = None) -> int:
    """Computes a chunk and writes it; returns its number of points."""
    numbers, status, messages = _native.sweep_chunk(plan.text, number, go_on)
    block, place = plan.block(number), plan.place(number)
    variables, column = plan.answers(), 0
    for variable, field in zip(variables, plan["fields"]):
        count = field["length"] or 1
        further = variable.shape[len(block) :]
        values = numbers[:, column : column + count].reshape(block + further)
        _zarr.write(store, variable.file(place + (0,) * len(further)), variable.encoded(values))
        column += count
    for variable, values in zip(variables[-2:], (np.array(messages, dtype=object), status)):
        _zarr.write(store, variable.file(place), variable.encoded(values.reshape(block)))
    return len(messages)

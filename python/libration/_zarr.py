"""Stores of Zarr (format 3) on a disk, whose bytes follow from what they hold: written here, read
by zarr and xarray.

Chunks are not compressed, so that no version of a compressor shows in them. A file is written
elsewhere, brought to the disk, and renamed into its place: it is there and whole, or it is not.
"""

import json
import os
import struct
import uuid
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Variable(NamedTuple):
    """An array of a store: its dimensions and chunks."""

    name: str
    dimensions: tuple[str, ...]
    shape: tuple[int, ...]
    chunk: tuple[int, ...]
    kind: str
    """"float64", "int8" or "string"."""
    attributes: Mapping[str, Any]

    @property
    def fill(self) -> Any:
        """The value of elements that are not written."""
        return {"float64": np.nan, "int8": -1, "string": ""}[self.kind]

    def metadata(self) -> dict[str, Any]:
        """The file ``zarr.json`` of the array."""
        codecs = {
            "float64": {"name": "bytes", "configuration": {"endian": "little"}},
            "int8": {"name": "bytes"},
            "string": {"name": "vlen-utf8"},
        }
        return {
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.shape,
            "data_type": self.kind,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": self.chunk}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": "/"}},
            "fill_value": "NaN" if self.kind == "float64" else self.fill,
            "codecs": [codecs[self.kind]],
            "attributes": dict(self.attributes),
            "dimension_names": self.dimensions,
            "storage_transformers": [],
        }

    def file(self, place: Sequence[int]) -> str:
        """The path of a chunk in the store."""
        return "/".join([self.name, "c", *map(str, place)])

    def encoded(self, values: "NDArray[Any] | Sequence[str]") -> bytes:
        """The bytes of a chunk; one at the end of the array is filled up."""
        block = np.full(self.chunk, self.fill, dtype=object if self.kind == "string" else self.kind)
        values = np.asarray(values, dtype=block.dtype)
        block[tuple(slice(length) for length in values.shape)] = values
        if self.kind != "string":
            return block.astype(block.dtype.newbyteorder("<")).tobytes()
        texts = [text.encode() for text in block.ravel()]
        counted = [struct.pack("<I", len(text)) + text for text in texts]
        return struct.pack("<I", len(texts)) + b"".join(counted)


def group(variables: Iterable[Variable], attributes: Mapping[str, Any]) -> dict[str, bytes]:
    """The files of metadata by their paths; that of the group is the last."""
    metadata = {variable.name: variable.metadata() for variable in variables}
    whole = {
        "zarr_format": 3,
        "node_type": "group",
        "attributes": dict(attributes),
        "consolidated_metadata": {"kind": "inline", "must_understand": False, "metadata": metadata},
    }
    files = {f"{name}/zarr.json": _json(own) for name, own in metadata.items()}
    return {**files, "zarr.json": _json(whole)}


def _json(value: Any) -> bytes:
    text = json.dumps(value, sort_keys=True, indent=1, ensure_ascii=False, allow_nan=False)
    return f"{text}\n".encode()


def write(store: Path, path: str, content: bytes) -> None:
    """Writes a file of a store, which is on the disk when this returns."""
    place = store / path
    unfinished = workshop(store)
    unfinished.mkdir(parents=True, exist_ok=True)
    place.parent.mkdir(parents=True, exist_ok=True)
    draft = unfinished / f"{uuid.uuid4().hex}.part"
    try:
        with open(draft, "xb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(draft, place)
    except BaseException:
        draft.unlink(missing_ok=True)
        raise


def workshop(store: Path) -> Path:
    """The directory of unfinished files next to the store, which never contains half a file."""
    return store.with_name(f".{store.name}.unfinished")


def clear(store: Path) -> None:
    """Removes the unfinished files of killed processes."""
    unfinished = workshop(store)
    for draft in unfinished.glob("*.part"):
        draft.unlink(missing_ok=True)
    try:
        unfinished.rmdir()
    except OSError:
        pass  # It is not there, or another process writes in it.

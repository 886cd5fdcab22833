"""What is given to a function, as the input of the command line that says the same."""

from __future__ import annotations

import contextlib
import json
import re
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Union

from ._sbeh import InputError, Material

Tables = Mapping[str, Any]
MaterialLike = Union[Material, Mapping[str, Any], None]


def _value(value: Any) -> str:
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, Path)):
        return json.dumps(str(value), ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_value(one)}" for key, one in value.items()) + " }"
    if hasattr(value, "__iter__"):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    raise TypeError(f"{value!r} cannot stand in an input")


def toml(tables: Tables) -> str:
    """Plain values, then tables; what is None is left out."""
    there = {key: value for key, value in tables.items() if value is not None}
    plain = [f"{key} = {_value(value)}" for key, value in there.items() if not isinstance(value, Mapping)]
    for name, table in there.items():
        if isinstance(table, Mapping):
            plain += ["", f"[{name}]"]
            plain += [f"{key} = {_value(value)}" for key, value in table.items() if value is not None]
    return "\n".join(plain) + "\n"


@contextlib.contextmanager
def input_file(function: str, tables: Tables) -> Iterator[Path]:
    """A file with the tables; what is said of it is said of the function."""
    with tempfile.TemporaryDirectory(prefix="sbeh-") as folder:
        path = Path(folder) / f"{function}.toml"
        path.write_text(toml(tables), encoding="utf-8")
        try:
            yield path
        except InputError as error:
            raise InputError(re.sub(rf"{re.escape(str(path))}(:\d+)?", f"{function}()", str(error))) from None


def material_table(material: MaterialLike, *, without_L: bool = False) -> dict[str, Any] | None:
    """The table [material]; where L is said elsewhere, without it."""
    if material is None:
        return None
    if not isinstance(material, Material):
        return dict(material)
    table = material.to_dict()
    if without_L:
        if material.L2 != 0 or material.L3 != 0:
            raise InputError("material: L2 and L3 must be 0, since L is that of the one-constant approximation")
        for name in ("L1", "L2", "L3"):
            del table[name]
    return table


class ResultsFolder:
    """A folder of results: the user's, or one that goes with the last reference to it."""

    def __init__(self, path: str | Path | None) -> None:
        if path is not None:
            self.path = Path(path)
        else:
            self._temporary = tempfile.TemporaryDirectory(prefix="sbeh-")
            self.path = Path(self._temporary.name) / "results"

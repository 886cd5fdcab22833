"""Results in physical units."""

from __future__ import annotations

import contextlib
import io
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import _sbeh
from .inputs import input_file
from .tables import read_table

if TYPE_CHECKING:
    import pandas

Units = Union[Mapping[str, Any], str, Path, None]


@contextlib.contextmanager
def _units_file(units: Units) -> Iterator[Path | None]:
    if units is None or isinstance(units, (str, Path)):
        yield None if units is None else Path(units)
    else:
        with input_file("units", {"units": units}) as path:
            yield path


class InUnits:
    """What every folder of results can do."""

    @property
    def folder(self) -> Path:
        raise NotImplementedError

    def physical(self, table: str, units: Units = None) -> pandas.DataFrame:
        """A table of the folder by its file's name, such as "scan.csv", in physical units, which end the names of the
        columns: `energy_kT`, `H_pole_per_um`, `time_s`. What has none is a pure number.

        units: {"radius_um": 10, "bending_rigidity_kT": 20, "surface_viscosity": 5e-10}, with `temperature` (K, 300), or
        `bending_rigidity_J`, or `friction` (Pa s/m) instead of the viscosity; or a file with a table [units]; without,
        those that were given when it was computed. Raises InputError, OutputError.
        """
        with _units_file(units) as path:
            return read_table(io.StringIO(_sbeh.physical_table(self.folder, table, path)))

    def describe_units(self, units: Units = None) -> list[str]:
        """A line for each unit with its formula: what the number 1 of a length, an energy, a time is."""
        with _units_file(units) as path:
            return _sbeh.describe_units(self.folder, path)

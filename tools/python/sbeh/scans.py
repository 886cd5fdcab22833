"""Scans: stationary shapes over reduced volume and elastic constant."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import _sbeh
from .inputs import MaterialLike, ResultsFolder, input_file, material_table
from .states import Profile
from .tables import read_table
from .units import InUnits

if TYPE_CHECKING:
    import pandas

Grid = Union[float, Sequence[float], dict[str, Any]]


class Scan(InUnits):
    """The folder of a scan, read when it is asked for."""

    def __init__(self, folder: ResultsFolder) -> None:
        self._folder = folder

    @property
    def folder(self) -> Path:
        return self._folder.path

    @cached_property
    def table(self) -> pandas.DataFrame:
        """A row per point: `model`, `reduced_volume`, `L`, `branch`, `status`, `energy`, ..."""
        return read_table(self.folder / "scan.csv")

    @cached_property
    def folds(self) -> pandas.DataFrame:
        """The folds in which the branches of SBEH end as L grows."""
        return read_table(self.folder / "folds.csv")

    @cached_property
    def lowest(self) -> pandas.DataFrame:
        """Which branch is lowest at every point, or that it is not found."""
        return read_table(self.folder / "lowest.csv")

    @cached_property
    def equal_energy(self) -> pandas.DataFrame:
        """Where two branches have equal energy."""
        return read_table(self.folder / "equal_energy.csv")

    @cached_property
    def stability_lines(self) -> pandas.DataFrame:
        """Where an eigenvalue of a mode cos m phi changes its sign."""
        return read_table(self.folder / "stability_lines.csv")

    def profile(self, *, reduced_volume: float, L: float, branch: str = "oblate", model: str = "SBEH") -> Profile:
        """The shape of a point. Raises OutputError where the scan has none."""
        return Profile.read(self.folder / "points" / _sbeh.point_file(model, branch, reduced_volume, L))

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {status}" for status, count in self.table["status"].value_counts().items())
        return f"<Scan {self.folder}: {counts}>"


def scan(reduced_volume: Grid, L: Grid, *, models: Sequence[str] = ("SBEH", "SSH"),
         branches: Sequence[str] = ("oblate",), method: str = "newton", modes: int = 4, beyond_fold: bool = False,
         end_time: float | None = None, material: MaterialLike = None, numerics: dict[str, Any] | None = None,
         units: dict[str, Any] | None = None, folder: str | Path | None = None, threads: int = 0) -> Scan:
    """Stationary shapes over all combinations of reduced volume and L, models and branches.

    reduced_volume, L: a number, a list, an array, or {"from": 0.6, "to": 0.95, "count": 50} with
    "spacing": "log" if wanted; material: all but L; units: the vesicle, see `Scan.physical`; folder: where the results
    lie, which is gone on with if it holds the same scan, without one they go with the scan; threads: 0: all cores. Warns
    where points failed. Raises InputError, OutputError, KeyboardInterrupt.
    """
    results = ResultsFolder(folder)
    table = {"reduced_volume": reduced_volume, "L": L, "models": models, "branches": branches, "method": method,
             "modes": modes, "beyond_fold": beyond_fold, "end_time": end_time}
    with input_file("scan", {"scan": table, "material": material_table(material, without_L=True),
                             "numerics": numerics, "units": units}) as path:
        failed = _sbeh.scan(path, results.path, threads)
    if failed:
        warnings.warn(f"{failed}; all reasons are in the column stop_reason", stacklevel=2)
    return Scan(results)


def read_scan(folder: str | Path) -> Scan:
    """The folder of a scan of the command line. Raises OutputError where there is none."""
    if not (Path(folder) / "scan.csv").exists():
        raise _sbeh.OutputError(f"{folder}: holds no scan: there is no scan.csv")
    return Scan(ResultsFolder(folder))

"""Rest states in 3D by Newton's method, with an axis or without."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _sbeh
from .inputs import MaterialLike, ResultsFolder, input_file, material_table
from .surfaces import Frame, read_frame
from .tables import read_table
from .units import InUnits

if TYPE_CHECKING:
    import pandas


class RestStates(InUnits):
    """The folder of rest states, read when it is asked for."""

    def __init__(self, folder: ResultsFolder, within: ResultsFolder | None = None) -> None:
        self._folder = folder
        self._within = within  # which lasts as long as this

    @property
    def folder(self) -> Path:
        return self._folder.path

    @cached_property
    def table(self) -> pandas.DataFrame:
        """A row of states.csv for each: `number`, `status`, `energy` and its error, `negative_directions` (0: a minimum),
        `class`, `eigenvalue_1`, ..."""
        return read_table(self.folder / "states.csv")

    @cached_property
    def passes(self) -> pandas.DataFrame:
        """With `passes` a row of passes.csv for each state with one negative direction: `kind`, `end_1`, `barrier_1`, ..."""
        return read_table(self.folder / "passes.csv")

    def frame(self, number: int) -> Frame:
        """The surface of the state of that number."""
        return read_frame(self.folder / f"frames/state_{number:04d}.vtu")

    def mode_file(self, number: int, k: int) -> Path:
        """Its k-th mode, from 1, for ParaView or meshio: the fields `displacement`, (nodes, 3), and `order_change`."""
        return self.folder / f"modes/state_{number:04d}_mode_{k}.vtu"


def rest_states(*, branch: str | None = None, scan: str | Path | None = None, frame: str | Path | None = None,
                mesh: str | Path | None = None, reduced_volume: Any = None, L: Any = None, model: str | None = None,
                perturbation: Any = None, triangles: int | None = None, eigenpairs: int = 6, rates: int = 0,
                passes: bool = False, follow: Mapping[str, Any] | None = None, search: Mapping[str, Any] | None = None,
                material: MaterialLike = None, numerics: Mapping[str, Any] | None = None,
                units: Mapping[str, Any] | None = None, folder: str | Path | None = None) -> RestStates:
    """Minima and saddles in 3D, as `sbeh states`; `follow` and `search`: its tables [follow], such as
    {"parameter": "reduced_volume", "to": 0.7}, and [search], such as {"most_states": 5}.

    From the axisymmetric state of a `branch` or of a `scan`, from a `frame` or a `mesh`. With `passes` on from each with one
    negative direction to the states between which it lies. Warns of states that are not found or not resolved; `status`
    and `stop_reason` of the table say why. Raises InputError, OutputError.
    """
    results = ResultsFolder(folder)
    table = {"model": model, "branch": branch, "scan": scan, "frame": frame, "mesh": mesh,
             "reduced_volume": reduced_volume, "L": L, "perturbation": perturbation, "triangles": triangles,
             "eigenpairs": eigenpairs, "rates": rates, "passes": passes or None}
    with input_file("rest_states", {"states": table, "follow": follow, "search": search,
                                    "material": material_table(material, without_L=True), "numerics": numerics,
                                    "units": units}) as path:
        _sbeh.rest_states(path, results.path)
    return warned(RestStates(results))


def warned(states: RestStates) -> RestStates:
    """The same, with a warning for each that is not to be trusted."""
    for row in states.table.itertuples():
        if row.status != "stationary":
            warnings.warn(f"state {row.number} {row.status}: {row.stop_reason}", stacklevel=3)
    return states

"""Stationary states, one at a time, and their modes."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _sbeh
from .inputs import MaterialLike, ResultsFolder, input_file, material_table
from .tables import read_table
from .units import InUnits

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class Profile:
    """The generating curve of an axisymmetric surface, from the north pole to the south pole.

    Arrays of one value per node (3 per element and one): `arc_length`, `r` >= 0, `z`, `order`, `mean_curvature`
    (trace, -2 on the unit sphere); lengths in radii of the sphere of equal area.
    """

    arc_length: np.ndarray
    r: np.ndarray
    z: np.ndarray
    order: np.ndarray
    mean_curvature: np.ndarray

    @classmethod
    def read(cls, path: str | Path) -> Profile:
        """A table of a profile. Raises OutputError."""
        table = read_table(Path(path))
        return cls(*(table[name].to_numpy() for name in cls.__dataclass_fields__))


def _number(text: str) -> Any:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text if text else None


@dataclass(frozen=True)
class State(Profile):
    """A stationary state: its profile, and the row that a scan's table has of it."""

    row: dict[str, Any]
    tension: float
    pressure: float

    @property
    def energy(self) -> float:
        """Total energy."""
        return self.row["energy"]

    @property
    def status(self) -> str:
        """`stationary`; or why there is no state, see `stop_reason`."""
        return self.row["status"]

    @property
    def stop_reason(self) -> str:
        return self.row["stop_reason"]

    def __repr__(self) -> str:
        where = ", ".join(str(self.row[key]) for key in ("model", "branch"))
        return (f"<State {where}, V_r = {self.row['reduced_volume']}, L = {self.row['L']}: {self.status}, "
                f"energy {self.energy}>")


def _material_with(material: MaterialLike, L: float) -> _sbeh.Material:
    table = material_table(material, without_L=True) or {}
    return _sbeh.Material(**table, L=L)


def stationary(branch: str, *, reduced_volume: float, L: float, model: str = "SBEH", material: MaterialLike = None,
               elements: int = 48, grading: float = 0.5, modes: int = 4) -> State:
    """The state of rest of a branch, as a row of a scan has it.

    branch: "oblate", "prolate", "stomatocyte"; model: "SBEH" or "SSH"; 0 < reduced_volume <= 1; material: all but L,
    a `Material` or its parameters by name; modes: stability in 3D by cos m phi up to this m, 0: none. Warns where
    the state asked for is not there or not resolved; `status` and `stop_reason` say why.
    """
    found = _sbeh.stationary(branch, reduced_volume, _material_with(material, L), model, elements, grading, modes)
    row = {key: _number(text) for key, text in found.row.items()}
    if row["status"] != "stationary":
        warnings.warn(f"{row['status']}: {row['stop_reason']}", stacklevel=2)
    return State(found.arc_length, found.r, found.z, found.order, found.mean_curvature, row, found.tension,
                 found.pressure)


class Modes(InUnits):
    """The modes of a stationary state: see `modes`."""

    def __init__(self, folder: ResultsFolder, rigid_residual: float) -> None:
        self._folder = folder
        self.rigid_residual = rigid_residual
        """Largest absolute eigenvalue of a rigid motion, which is 0 of the exact state: the error at least."""

    @property
    def folder(self) -> Path:
        return self._folder.path

    @cached_property
    def table(self) -> pandas.DataFrame:
        """`m`, `parity`, `number`, `eigenvalue` (> 0: stable), `rate` (< 0: stable), their estimated errors."""
        return read_table(self.folder / "modes.csv")

    @cached_property
    def fluctuations(self) -> pandas.DataFrame:
        """Mean square amplitudes kT/eigenvalue; where `fluctuations` was given."""
        return read_table(self.folder / "fluctuations.csv")

    @cached_property
    def contour(self) -> pandas.DataFrame:
        """The spectrum of the widest circle's contour; where `fluctuations` was given."""
        return read_table(self.folder / "contour.csv")


def modes(branch: str | None = None, *, reduced_volume: float, L: float, model: str = "SBEH",
          scan: str | Path | None = None, material: MaterialLike = None, numerics: dict[str, Any] | None = None,
          largest_m: int = 5, number: int = 1, fluctuations: float | str | None = None,
          units: dict[str, Any] | None = None, folder: str | Path | None = None) -> Modes:
    """Second derivatives of the energy of one state in all directions u(s) cos m phi, and their rates in the flow.

    The state is followed along its branch, or taken from the folder of a `scan`. `number`: modes of each m and
    parity; `fluctuations`: k_B T, with `units` "1 kT". Files of the modes lie in `folder`/modes. Raises InputError, and
    RuntimeError where there is no such state.
    """
    results = ResultsFolder(folder)
    table = {"scan": scan, "model": model, "branch": branch, "reduced_volume": reduced_volume, "L": L,
             "largest_m": largest_m, "number": number, "fluctuations": fluctuations}
    with input_file("modes", {"modes": table, "material": material_table(material, without_L=True),
                              "numerics": numerics, "units": units}) as path:
        return Modes(results, _sbeh.modes(path, results.path))

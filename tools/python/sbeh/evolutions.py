"""Evolutions in time: with an axis and in 3D."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _sbeh
from .inputs import MaterialLike, ResultsFolder, input_file, material_table
from .rest_states import RestStates, warned
from .states import Profile
from .surfaces import Frame, read_frame
from .tables import read_series, read_table
from .units import InUnits

if TYPE_CHECKING:
    import pandas

Table = Mapping[str, Any]


def _warn_of(end: dict[str, Any]) -> None:
    """Of what shows that a result is not to be trusted."""
    if not end["ended_well"]:
        warnings.warn(f"{end['stop']} at t = {end['time']:.6g}{'; ' if end['fault'] else ''}{end['fault']}",
                      stacklevel=3)
    if end["rises_too_far"]:
        warnings.warn(f"the energy, which can only fall, rises by {end['energy_rises']:.2g} in sum", stacklevel=3)
    if end.get("unresolved_from") is not None:
        warnings.warn(f"unresolved from t = {end['unresolved_from']:.6g}: what comes later is not to be trusted",
                      stacklevel=3)


class Evolution(InUnits):
    """The folder of an axisymmetric evolution, read when it is asked for."""

    def __init__(self, folder: ResultsFolder, end: dict[str, Any] | None = None) -> None:
        self._folder = folder
        self.end = end
        """How it ended: `stop`, `time`, `steps`, `energy`, ...; None of one that was read."""

    @property
    def folder(self) -> Path:
        return self._folder.path

    @cached_property
    def series(self) -> pandas.DataFrame:
        """The history, see `read_series`."""
        return read_series(self.folder)

    @cached_property
    def profiles(self) -> list[tuple[float, Profile]]:
        """Times and shapes."""
        table = read_table(self.folder / "profiles.csv")
        return [(row.time, Profile.read(self.folder / row.file)) for row in table.itertuples()]

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.folder}: {self.end['stop'] if self.end else 'read'}>"


class Run3d(Evolution):
    """The folder of a 3D run, read when it is asked for."""

    @cached_property
    def frame_files(self) -> list[tuple[float, Path]]:
        """Times and files of the frames, for ParaView too."""
        table = read_table(self.folder / "frames.csv")
        return [(row.time, self.folder / row.file) for row in table.itertuples()]

    def frame(self, index: int) -> Frame:
        """One of the frames; -1: the last."""
        return read_frame(self.frame_files[index][1])

    @property
    def rest(self) -> RestStates | None:
        """What `finish = "newton"` has led to; None where it did not."""
        folder = self.folder / "rest"
        return RestStates(ResultsFolder(folder), self._folder) if (folder / "states.csv").exists() else None


def relax(start: Table, time: Table, *, model: str | None = None, material: MaterialLike = None,
          numerics: Table | None = None, units: Table | None = None,
          folder: str | Path | None = None) -> Evolution:
    """One axisymmetric evolution, as `sbeh relax`.

    start, time: the tables of its input, such as {"shape": "ellipsoid", "reduced_volume": 0.7} and {"end": 10}, with
    units ({"radius_um": 10, ...}, see `physical`) {"end": "2 s"} too. Warns where it does not end at rest or at its end,
    and where its energy rises. Raises InputError, OutputError.
    """
    results = ResultsFolder(folder)
    with input_file("relax", {"model": model, "start": start, "time": time, "material": material_table(material),
                              "numerics": numerics, "units": units}) as path:
        end = _sbeh.relax(path, results.path)
    _warn_of(end)
    return Evolution(results, end)


def run(surface: Table, time: Table, *, model: str | None = None, material: MaterialLike = None,
        numerics: Table | None = None, units: Table | None = None, folder: str | Path | None = None,
        resume: bool = False) -> Run3d:
    """One 3D evolution into a folder, as `sbeh run`; `resume` goes on with what is there.

    surface, time: the tables of its input, such as {"shape": "ellipsoid", "reduced_volume": 0.8, "triangles": 320} and
    {"end": 1}. Warns as `relax` does, and where the triangles do not resolve the surface.
    """
    results = ResultsFolder(folder)
    with input_file("run", {"model": model, "surface": surface, "time": time, "material": material_table(material),
                            "numerics": numerics, "units": units}) as path:
        end = _sbeh.run(path, results.path, resume)
    _warn_of(end)
    done = Run3d(results, end)
    if done.rest is not None:
        warned(done.rest)
    return done


def read_evolution(folder: str | Path) -> Evolution:
    """The folder of `sbeh relax`."""
    return Evolution(ResultsFolder(folder))


def read_run(folder: str | Path) -> Run3d:
    """The folder of `sbeh run`."""
    return Run3d(ResultsFolder(folder))


class Run:
    """A 3D run in memory, stepped by the caller.

    run = Run({"shape": "ellipsoid", "reduced_volume": 0.8, "triangles": 320}, model="SBEH", material={"L": 0.05})
    run.advance(until=0.1, after_step=lambda run: print(run.time))
    """

    def __init__(self, surface: Table, *, model: str | None = None, material: MaterialLike = None,
                 numerics: Table | None = None) -> None:
        tables = {"model": model, "surface": surface, "time": {"end": 1}, "material": material_table(material),
                  "numerics": numerics}
        with input_file("Run", tables) as path:
            self._run = _sbeh.Run(path)
        for remark in self._run.remarks:
            warnings.warn(remark, stacklevel=2)

    def advance(self, until: float, *, steps: int | None = None, stop_at_rest: bool = True,
                after_step: Callable[[Run], bool | None] | None = None) -> str:
        """Goes on until a time, or for so many steps; `after_step` ends it by returning False.

        Returns why it ended: "end time reached", "at rest", ...; "" where the steps were done or after_step
        said so. The time steps are chosen by the tolerance of `numerics`; gone on with later, the
        numbers are the same to the bit.
        """
        see = None if after_step is None else functools.partial(after_step, self)
        return self._run.advance(until, steps, stop_at_rest, see)

    @property
    def time(self) -> float:
        return self._run.time

    @property
    def points(self) -> np.ndarray:
        """(nodes, 3)"""
        return self._run.points

    @property
    def triangles(self) -> np.ndarray:
        """(triangles, 10), P3, in the order of VTK"""
        return self._run.triangles

    @property
    def order(self) -> np.ndarray:
        """(nodes,)"""
        return self._run.order

    @property
    def velocity(self) -> np.ndarray:
        """(nodes, 3), of the last step; before the first (0, 3)"""
        return self._run.velocity

    @property
    def mean_curvature(self) -> np.ndarray:
        """(nodes,), the trace, -2 on the unit sphere"""
        return self._run.mean_curvature

    def measures(self) -> dict[str, float]:
        """Energy and its parts, dissipation, area, volume, order, and `resolution`: above 1 the triangles do not resolve
        the surface."""
        return self._run.measures()

    def frame(self) -> Frame:
        """The present moment, its arrays its own."""
        fields = {"order": self.order, "mean_curvature": self.mean_curvature}
        if len(self.velocity):
            fields["velocity"] = self.velocity
        return Frame(self.points, self.triangles, fields, time=self.time, model=self._run.model,
                     material=self._run.material)

    def write_frame(self, path: str | Path) -> None:
        """As a frame of `sbeh run`, for ParaView and to go on from. Raises OutputError."""
        self._run.write_frame(Path(path))

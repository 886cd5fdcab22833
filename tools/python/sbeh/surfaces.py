"""Curved surfaces in 3D: meshes of shapes, frames of runs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from . import _sbeh


@dataclass(frozen=True)
class Mesh:
    """A closed surface of curved Lagrange triangles of order 1, 2 or 3.

    points: (nodes, 3); triangles: (triangles, 3, 6 or 10), indices of nodes in the order of VTK, corners
    counter-clockwise seen from outside; fields: by name, (nodes,) or (nodes, components).
    """

    points: np.ndarray
    triangles: np.ndarray
    fields: dict[str, np.ndarray] = field(default_factory=dict)
    quality: dict[str, float] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    @property
    def mesh_order(self) -> int:
        """Of the triangles: 1, 2 or 3."""
        return {3: 1, 6: 2, 10: 3}[self.triangles.shape[1]]

    def plain_triangles(self) -> np.ndarray:
        """(mesh_order^2 triangles, 3): the small plain triangles between the nodes."""
        small = _sbeh.small_triangles(self.mesh_order)
        return self.triangles[:, small].reshape(-1, 3)

    def write(self, path: str | Path) -> None:
        """.vtu (curved, with fields), or .obj, .off, .ply, .stl (plain). Raises InputError, OutputError."""
        fields = {name: values.reshape(len(values), -1) for name, values in self.fields.items()}
        _sbeh.write_mesh(Path(path), self.points, self.triangles, fields)

    def to_meshio(self) -> Any:
        """A meshio.Mesh with cells `triangle`, `triangle6` or `VTK_LAGRANGE_TRIANGLE`."""
        import meshio

        kind = {1: "triangle", 2: "triangle6", 3: "VTK_LAGRANGE_TRIANGLE"}[self.mesh_order]
        return meshio.Mesh(self.points, [(kind, self.triangles)], point_data=self.fields)

    def to_vtk(self) -> Any:
        """A vtkUnstructuredGrid of Lagrange triangles, with the fields as point data."""
        import vtk
        from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

        grid, points, cells = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkCellArray()
        points.SetData(numpy_to_vtk(self.points, deep=True))
        size = self.triangles.shape[1]
        rows = np.column_stack([np.full(len(self.triangles), size), self.triangles]).astype(np.int64)
        cells.SetCells(len(rows), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
        grid.SetPoints(points)
        grid.SetCells(vtk.VTK_LAGRANGE_TRIANGLE, cells)
        for name, values in self.fields.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        return grid


@dataclass(frozen=True)
class Frame(Mesh):
    """A moment of a 3D run: fields `order`, `mean_curvature` (trace, -2 on the unit sphere), `normal`, `velocity`."""

    time: float = 0.0
    model: str | None = None
    material: _sbeh.Material | None = None


def mesh(shape: str, *, axes: Sequence[float] | None = None, prolate: bool = False,
         modes: Sequence[tuple[int, int, float]] = (), path: str | Path | None = None, repair: bool = False,
         triangles: int | None = None, order: int | None = None, grading: float = 0, area: float | None = None,
         reduced_volume: float | None = None) -> Mesh:
    """A curved mesh of a shape, as `sbeh mesh` makes it.

    shape: "sphere"; "ellipsoid" (axes, or reduced_volume and prolate); "harmonic" (modes: (l, m, amplitude) of
    r = 1 + sum of a Y_lm, real and orthonormal); "revolve" (path: a profile); "file" (path, repair). triangles:
    about so many (1280); order: 1, 2, 3 (3); area: scale to this one; reduced_volume: exactly this one. Raises
    InputError.
    """
    shapes = ("sphere", "ellipsoid", "harmonic", "revolve", "file")
    if shape not in shapes:
        raise _sbeh.InputError(f"mesh(): shape = {shape!r}: must be one of {', '.join(shapes)}")
    if shape in ("revolve", "file") and path is None:
        raise _sbeh.InputError(f"mesh(): path: is missing, the file of shape = {shape!r}")
    made = _sbeh.mesh(shape, {
        "axes": axes, "prolate": prolate, "modes": [tuple(one) for one in modes], "path": path, "repair": repair,
        "triangles": triangles, "order": order, "grading": grading, "area": area, "reduced_volume": reduced_volume})
    return Mesh(**made)


def read_frame(path: str | Path) -> Frame:
    """A frame of a 3D run (.vtu), numbers to the bit. Raises InputError."""
    return Frame(**_sbeh.read_frame(Path(path)))

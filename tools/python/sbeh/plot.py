"""Pictures with matplotlib. Each function draws into `ax`, or new axes, and returns them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

from .scans import Scan
from .states import Profile
from .surfaces import Mesh

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

COLOURS = "viridis"  # read by the colour-blind, and in grey
_NO_RESULT = "0.85"


def _axes(ax: Axes | None, **properties: Any) -> Axes:
    if ax is None:
        ax = plt.figure(figsize=(4.2, 3.4), layout="constrained").add_subplot(**properties)
    return ax


def _edges(values: np.ndarray) -> np.ndarray:
    """The borders of cells around ascending values."""
    if len(values) == 1:
        return np.array([values[0] * 0.95, values[0] * 1.05])
    middle = (values[1:] + values[:-1]) / 2
    return np.concatenate([[2 * values[0] - middle[0]], middle, [2 * values[-1] - middle[-1]]])


def diagram(scan: Scan, quantity: str = "energy", *, model: str = "SBEH", branch: str = "oblate",
            ax: Axes | None = None) -> Axes:
    """A column of the scan's table over L and V_r; grey where there is no stationary state. With the fold, dots on
    states that are no minima in 3D."""
    ax = _axes(ax)
    table = scan.table[(scan.table["model"] == model) & (scan.table["branch"] == branch)]
    if table.empty:
        raise ValueError(f"the scan has no {model} {branch}")
    found = table[table["status"] == "stationary"]
    values = found.pivot(index="reduced_volume", columns="L", values=quantity)
    values = values.reindex(index=sorted(table["reduced_volume"].unique()), columns=sorted(table["L"].unique()))
    ax.set_facecolor(_NO_RESULT)
    image = ax.pcolormesh(_edges(values.columns.to_numpy()), _edges(values.index.to_numpy()),
                          np.ma.masked_invalid(values.to_numpy(dtype=float)), cmap=COLOURS)
    ax.figure.colorbar(image, ax=ax, label=quantity.replace("_", " "))
    limits = ax.axis()
    if model == "SBEH":
        folds = scan.folds[scan.folds["branch"] == branch]
        ax.plot(folds["L"], folds["reduced_volume"], color="black", lw=1.2, label="fold")
    if "negative_directions_3d" in found:
        saddles = found[found["negative_directions_3d"] > 0]
        ax.plot(saddles["L"], saddles["reduced_volume"], ".", color="white", ms=3, label="no minimum in 3D")
    ax.axis(limits)
    if ax.lines:
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.22), ncols=2, facecolor="0.8", fontsize="small")
    ax.set(xlabel="L", ylabel="reduced volume $V_r$", title=f"{model} {branch}")
    return ax


def profile(shape: Profile, *, field: str = "order", ax: Axes | None = None, limits: tuple[float, float] | None = None,
            colourbar: bool = True) -> Axes:
    """The meridian with its mirror image, coloured by `order` or `mean_curvature`."""
    ax = _axes(ax)
    values = getattr(shape, field)
    if limits is None:  # what is equal but for rounding has one colour
        spread = max(float(np.ptp(values)), 1e-6)
        limits = (float(values.mean()) - spread, float(values.mean()) + spread) if spread == 1e-6 else (
            float(values.min()), float(values.max()))
    for side in (1, -1):
        points = np.column_stack([side * shape.r, shape.z])
        line = LineCollection(np.stack([points[:-1], points[1:]], axis=1), cmap=COLOURS, lw=2.5, capstyle="round")
        line.set_array((values[1:] + values[:-1]) / 2)
        line.set_clim(*limits)
        ax.add_collection(line)
    ax.set(aspect="equal", xlabel="r", ylabel="z")
    ax.autoscale_view()
    ax.margins(0.05)
    if colourbar:
        wide = 2 * shape.r.max() > np.ptp(shape.z)
        ax.figure.colorbar(line, ax=ax, label=field.replace("_", " "), shrink=0.8, pad=0.03,
                           orientation="horizontal" if wide else "vertical")
    return ax


def series(table: pandas.DataFrame, columns: Iterable[str] = ("energy",), *, ax: Axes | None = None) -> Axes:
    """Columns of a history over the time, which is logarithmic; the start is left out."""
    ax = _axes(ax)
    later = table[table["time"] > 0]
    for column, style in zip(columns, ("-", "--", ":", "-.") * 4):
        ax.plot(later["time"], later[column], style, label=column.replace("_", " "))
    ax.set(xlabel="time", xscale="log")
    if len(ax.lines) > 1:
        ax.legend()
    else:
        ax.set_ylabel(ax.lines[0].get_label())
    return ax


def surface(mesh: Mesh, field: str | None = "order", *, ax: Any = None, elevation: float = 20, azimuth: float = -60) -> Any:
    """A surface in 3D, its curved triangles as small plain ones, coloured by a field and shaded."""
    from matplotlib.colors import LightSource, Normalize
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    ax = _axes(ax, projection="3d", proj_type="ortho")
    triangles = mesh.plain_triangles()
    corners = mesh.points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = LightSource(azdeg=azimuth + 200, altdeg=50).shade_normals(
        normals / np.linalg.norm(normals, axis=1, keepdims=True), fraction=0.6)
    if field is None:
        colours = np.tile([0.75, 0.78, 0.82, 1.0], (len(triangles), 1))
    else:
        values = mesh.fields[field]
        low, high = float(values.min()), float(values.max())
        scale = plt.cm.ScalarMappable(Normalize(low, high if high - low > 1e-6 else low + 1e-6), COLOURS)
        colours = scale.to_rgba(values[triangles].mean(axis=1))
        ax.figure.colorbar(scale, ax=ax, label=field.replace("_", " "), shrink=0.7)
    colours[:, :3] *= (0.35 + 0.65 * light)[:, None]
    ax.add_collection3d(Poly3DCollection(corners, facecolors=colours, edgecolors=colours, linewidths=0.2))
    half = np.abs(mesh.points).max()
    ax.set(xlim=(-half, half), ylim=(-half, half), zlim=(-half, half))
    ax.set_box_aspect((1, 1, 1), zoom=1.4)
    ax.view_init(elevation, azimuth)
    ax.set_axis_off()
    return ax

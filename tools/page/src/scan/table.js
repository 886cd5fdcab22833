// The points of a scan, its grid, and what a point has.
import { Units } from "../data.js";
import { with_normals } from "../modes/revolved_mode.js";
import { label_of_mode, name_of_mode } from "../modes/table.js";
import { PackedFields } from "../packed_fields.js";

const resting = new Set(["stationary", "limit"]);
const keys = new Set(["model", "reduced_volume", "L", "branch", "stop_reason"]);
const most_classes = 8;

export const number_of = (text) => (text === undefined || text === "" ? NaN : Number(text));
const ascending = (values) => [...new Set(values)].sort((a, b) => a - b);

export function read_scan(parts) {
  const rows = parts.table("scan.csv");
  const profiles = new PackedFields(parts, "profiles"), shapes = new PackedFields(parts, "mode_shapes");
  const modes = modes_by_row(parts, shapes);
  const points = rows.map((row, index) => ({
    row,
    index,
    V: Number(row.reduced_volume),
    L: Number(row.L),
    model: row.model,
    branch: row.branch,
    rests: resting.has(row.status),
    profile: () => profiles.get(index),
    modes: modes.get(index) ?? [],
  }));
  return {
    points,
    folder: parts.get("folder"),
    units: new Units(parts),
    columns: rows.columns,
    V: ascending(points.map((p) => p.V)),
    L: ascending(points.map((p) => p.L)),
    models: [...new Set(points.map((p) => p.model))],
    branches: [...new Set(points.map((p) => p.branch))],
    quantities: quantities_of(rows),
    lowest: parts.table("lowest.csv"),
    folds: parts.table("folds.csv"),
    equal_energies: parts.table("equal_energy.csv"),
    stability_lines: parts.table("stability_lines.csv"),
  };
}

// What sbeh modes has left of the points, by their rows.
function modes_by_row(parts, shapes) {
  const modes = new Map();
  for (const { row: index, ...row } of parts.table("point_modes.csv")) {
    const name = name_of_mode(row), key = `${index}/${name}`;
    const mode = { name, label: label_of_mode(row), row, has_shape: shapes.has(key), shape: () => with_normals(shapes.get(key)) };
    modes.set(Number(index), [...(modes.get(Number(index)) ?? []), mode]);
  }
  return modes;
}

// Columns that can be drawn: numbers, or classes where there are few.
export function quantities_of(rows, left_out = keys) {
  const quantities = [];
  for (const name of rows.columns) {
    if (left_out.has(name)) continue;
    const texts = [...new Set(rows.map((row) => row[name]))].filter((text) => text !== "" && text !== "nan");
    if (texts.length === 0) continue;
    const numeric = texts.every((text) => Number.isFinite(Number(text)));
    const few = texts.length <= most_classes && texts.every((text) => Number.isInteger(Number(text)));
    if (numeric && !few) quantities.push({ name, classes: null });
    else quantities.push({ name, classes: numeric ? texts.sort((a, b) => a - b) : texts.sort() });
  }
  return quantities;
}

export const lowest_branch = "lowest";

// The points of a model and branch by their place on the grid; of the lowest branch, those that lowest.csv names.
export function map_of(scan, model, branch) {
  const place = (V, L) => `${V} ${L}`;
  const named = new Map(
    scan.lowest.filter((row) => row.model === model).map((row) => [place(Number(row.reduced_volume), Number(row.L)), row.branch]),
  );
  const wanted = (p) => (branch === lowest_branch ? named.get(place(p.V, p.L)) : branch) === p.branch;
  const points = scan.points.filter((p) => p.model === model && wanted(p));
  const by_place = new Map(points.map((p) => [place(p.V, p.L), p]));
  return { points, at: (V, L) => by_place.get(place(V, L)) };
}

// The next point of the map in a direction, over gaps.
export function neighbour(scan, map, point, [across, up]) {
  let i = scan.V.indexOf(point.V) + across, j = scan.L.indexOf(point.L) + up;
  for (; scan.V[i] !== undefined && scan.L[j] !== undefined; i += across, j += up) {
    const found = map.at(scan.V[i], scan.L[j]);
    if (found) return found;
  }
  return null;
}

export const same_place = (scan, point, model, branch) =>
  scan.points.find((p) => p.model === model && p.branch === branch && p.V === point.V && p.L === point.L);

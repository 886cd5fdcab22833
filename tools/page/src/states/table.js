// Rest states in 3D, the paths on which they lie, their shapes and modes.
import { Units } from "../data.js";
import { at_rest } from "../modes/table.js";
import { PackedFields } from "../packed_fields.js";
import { Film } from "../run/film.js";
import { number_of, quantities_of } from "../scan/table.js";

// Of the material; columns of [follow] in one of them.
const of_material = [
  ["H0", "spontaneous curvature H0"],
  ["k0", "residual stiffness k0"],
  ...[1, 2, 3, 4].map((power) => [`potential_${power}`, `the potential's coefficient of β^${power}`]),
];
const keys = new Set([
  ...["number", "model", "branch", "path", "point", "from", "reduced_volume", "L", "triangles", "stop_reason"],
  ...of_material.map(([name]) => name),
]);
const parameters = [["reduced_volume", "reduced volume V_r"], ["L", "elastic constant L"], ...of_material, ["number", "number"]];

export function read_states(parts) {
  const rows = parts.table("states.csv"), film = new Film(parts), shapes = new PackedFields(parts, "mode_shapes");
  const frames = new Map(film.frames.map((frame) => [frame.number, frame]));
  const points = rows.map((row, index) => ({
    row,
    index,
    rests: row.status === "stationary",
    followed: of_material.map(([name]) => name).find((name) => row[name] !== undefined),
    frame: frames.get(row.number) ?? null,
    modes: modes_of(row, shapes),
  }));
  const varies = ([name]) => name === "number" || new Set(rows.map((row) => row[name])).size > 1;
  return {
    points,
    film,
    units: new Units(parts),
    columns: rows.columns,
    parameters: parameters.filter(varies),
    quantities: quantities_of(rows, keys),
    follows: rows.columns.includes("path"),
    paths: paths_of(points),
  };
}

// The state at rest and its eigenpairs.
function modes_of(row, shapes) {
  const modes = [{ ...at_rest }];
  for (let k = 1; row[`eigenvalue_${k}`]; ++k) {
    const key = `${row.number}/${k}`;
    const numbers = { eigenpair: String(k), eigenvalue: row[`eigenvalue_${k}`] };
    modes.push({ name: String(k), label: `eigenpair ${k}`, row: numbers, has_shape: shapes.has(key), shape: () => shapes.get(key) });
  }
  return modes;
}

export const is_minimum = ({ row }) => row.negative_directions === "0";

// The name of what lies on no path: ends of passes.
export const no_path = "";

// Of each its states, and all that its line goes through: what leaves another path begins at the state where it leaves.
function paths_of(points) {
  const by_number = new Map(points.map((point) => [point.row.number, point]));
  const paths = new Map();
  for (const point of points) {
    const { path: name = no_path } = point.row;
    const start = name === no_path ? null : (by_number.get(point.row.from) ?? null);
    if (!paths.has(name)) paths.set(name, { name, points: [], start });
    paths.get(name).points.push(point);
    point.path = paths.get(name);
  }
  return [...paths.values()];
}

// The pieces of a path's line. Branchings and folds are of neither side: a piece is what its other end is.
export function pieces_of({ points, start }) {
  const line = start ? [start, ...points] : points;
  return line.slice(1).map((end, k) => {
    const begin = line[k], is_step = end.row.point === "step" || begin === start;
    return { begin, end, is_minimum: is_minimum(is_step ? end : begin) };
  });
}

export const numeric = (point, name) => number_of(point.row[name]);

// The lines of a diagram: pieces between neighbours on the grid, and dots where nothing can be joined.
import { bisectRight } from "d3";
import { lowest_branch } from "./table.js";

const place_of = (row) => [Number(row.reduced_volume), Number(row.L)];
const known = ([V, L], row) => row.reduced_volume !== "" && row.L !== "" && Number.isFinite(V) && Number.isFinite(L);

function polyline(rows, axis) {
  const points = rows.map(place_of).sort((a, b) => a[axis] - b[axis]);
  return points.slice(1).map((point, k) => [points[k], point]);
}

// The place of a value on the lines of the grid, which are counted; whole on a line.
function count(values, value) {
  const exact = values.indexOf(value);
  if (exact >= 0) return exact;
  const below = bisectRight(values, value) - 1;
  if (below < 0 || below + 1 >= values.length) return NaN;
  return below + (value - values[below]) / (values[below + 1] - values[below]);
}

// Two crossings are joined where they are the only ones on the border of a cell, on different sides of it.
function joined(points, V, L) {
  const cells = new Map();
  points.forEach((point) => {
    const place = [count(V, point[0]), count(L, point[1])];
    for (let i = Math.ceil(place[0]) - 1; i <= Math.floor(place[0]); ++i)
      for (let j = Math.ceil(place[1]) - 1; j <= Math.floor(place[1]); ++j)
        cells.set(`${i} ${j}`, [...(cells.get(`${i} ${j}`) ?? []), { point, place }]);
  });
  const on_one_side = (a, b) => [0, 1].some((k) => Number.isInteger(a.place[k]) && a.place[k] === b.place[k]);
  return [...cells.values()]
    .filter((cell) => cell.length === 2 && !on_one_side(...cell))
    .map((cell) => cell.map(({ point }) => point));
}

function grouped(rows, key) {
  const groups = new Map();
  for (const row of rows) groups.set(key(row), [...(groups.get(key(row)) ?? []), row]);
  return groups;
}

// { name, style, points, pieces, label } of each line of the model's states on the branch.
export function lines_of(scan, model, branch) {
  const here = (name) => branch === lowest_branch || name === branch;
  const of_free_order = model === "SBEH" || !scan.models.includes("SBEH");
  const lines = [];
  if (model === "SBEH")
    for (const [of, rows] of grouped(scan.folds.filter((row) => here(row.branch)), (row) => row.branch))
      lines.push({ name: `fold of the ${of}`, style: "fold", points: rows.map(place_of), pieces: polyline(rows, 0) });
  if (of_free_order)
    for (const [pair, rows] of grouped(
      scan.equal_energies.filter((row) => here(row.first) || here(row.second)),
      (row) => `${row.first} and ${row.second}`,
    ))
      lines.push({ name: `equal energy: ${pair}`, style: "equal", points: rows.map(place_of), pieces: polyline(rows, 1) });
  const stability = scan.stability_lines.filter((row) => row.model === model && here(row.branch) && known(place_of(row), row));
  for (const [, rows] of grouped(stability, (row) => `${row.branch} ${row.m} ${row.parity}`)) {
    const { branch: of, m, parity } = rows[0];
    const points = rows.map(place_of);
    const parity_text = parity === "none" ? "" : `, ${parity}`;
    lines.push({
      name: `stability of the ${of}: m = ${m}${parity_text}`,
      style: "stability",
      points,
      pieces: joined(points, scan.V, scan.L),
      label: `m = ${m}`,
    });
  }
  return lines;
}

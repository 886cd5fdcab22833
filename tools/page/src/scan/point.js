// One point of a scan: its neighbours, its shape, its modes and all its numbers.
import { colour_bytes } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { choice, element, svg } from "../dom.js";
import { revolved } from "../surface/revolved.js";
import { SurfaceView } from "../surface/view.js";
import { neighbour, same_place } from "./table.js";

const steps = [
  ["V_r −", [-1, 0]],
  ["V_r +", [1, 0]],
  ["L −", [0, -1]],
  ["L +", [0, 1]],
];
const least_width = 1e-9; // of the range of a colour: less is rounding

export const name_of = (point) => `${point.model} ${point.branch}, V_r = ${point.row.reduced_volume}, L = ${point.row.L}`;

function range_of(values) {
  const known = values.filter(Number.isFinite);
  if (!known.length) return [0, 0];
  const low = Math.min(...known), high = Math.max(...known);
  return high - low <= least_width * Math.max(Math.abs(low), Math.abs(high)) ? [low, low] : [low, high];
}

// `element` and, to be placed elsewhere, `numbers`.
export class PointPanel {
  // on: { choose(point) }; colours() tells which map is chosen.
  constructor(scan, colours, on) {
    this.scan = scan;
    this.colours = colours;
    this.on = on;
    this.open = false;
    this.heading = element("h3");
    this.remark = element("p", { class: "note" });
    this.near = element("div", { class: "near", role: "group", "aria-label": "neighbours" });
    this.profile = element("div", { class: "profile" });
    this.view = new SurfaceView("the shape");
    this.bar = element("div");
    this.numbers = element("div", { class: "numbers-of" });
    this.shape = element("div", { class: "shape" }, this.profile, this.view.element);
    this.element = element("div", { class: "point" }, this.heading, this.remark, this.near, this.controls(), this.shape, this.bar);
  }

  controls() {
    const field = choice("colour by", [["order", "order β"], ["H", "mean curvature H"]], "order", (chosen) => {
      this.field = chosen;
      this.draw_shape();
    });
    const open = element("input", {
      type: "checkbox",
      onchange: () => {
        this.open = open.checked;
        this.draw_shape();
      },
    });
    this.field_select = field.querySelector("select");
    return element("div", { class: "controls" }, field, element("label", { class: "choice" }, open, "cut open"));
  }

  show(point, map) {
    this.point = point;
    this.profile_of_point = point.profile();
    this.heading.textContent = name_of(point);
    const { status, stop_reason: reason } = point.row;
    this.remark.textContent =
      (status === "stationary" ? status : `${status}: ${reason || "no reason is given"}`) +
      (this.profile_of_point ? "" : "; its profile is not in the folder");
    this.near.replaceChildren(...this.neighbours(map));
    this.draw_shape();
    this.numbers.replaceChildren(this.modes(point), numbers_table(this.scan, point.row));
  }

  // Their numbers, and how to see their shapes.
  modes({ row }) {
    const table = modes_table(row, this.scan.units);
    if (!table || row.status !== "stationary") return table;
    const command = `sbeh modes --scan ${this.scan.folder} --model ${row.model} --branch ${row.branch} --reduced-volume ${row.reduced_volume} --L ${row.L} -o NEW_FOLDER`;
    table.append(element("p", { class: "note" }, "To see them on the surface: ", element("code", {}, command), ", and the report of that."));
    return table;
  }

  neighbours(map) {
    const button = (text, to) =>
      element("button", { type: "button", disabled: !to, onclick: () => this.on.choose(to) }, text);
    const { model, branch } = this.point;
    const others = [
      ...this.scan.models.filter((other) => other !== model).map((other) => [other, same_place(this.scan, this.point, other, branch)]),
      ...this.scan.branches.filter((other) => other !== branch).map((other) => [other, same_place(this.scan, this.point, model, other)]),
    ];
    return [
      ...steps.map(([text, direction]) => button(text, neighbour(this.scan, map, this.point, direction))),
      ...others.filter(([, point]) => point).map(([text, point]) => button(text, point)),
    ];
  }

  draw_shape() {
    if (!this.point) return;
    const profile = this.profile_of_point;
    this.shape.hidden = this.bar.hidden = !profile;
    if (!profile) return;
    const uniform = range_of([...profile.order]);
    const field = this.field ?? (uniform[0] === uniform[1] ? "H" : "order");
    this.field_select.value = field;
    const range = range_of([...profile[field]]);
    const bytes = colour_bytes(this.colours(), range, profile[field]);
    this.profile.replaceChildren(profile_drawing(profile, bytes));
    const surface = revolved(profile, { open: this.open });
    this.view.show(surface, colour_bytes(this.colours(), range, surface.at((node) => profile[field][node])));
    this.bar.replaceChildren(field_bar(this.scan.units, field, this.colours(), range));
  }
}

const field_bar = (units, field, colours, range) =>
  field === "order" ? colour_bar("order β", colours, range) : colour_bar(units.titled("H", "mean curvature H"), colours, units.shown("H", range));

// The cross section, both halves, each piece in its colour.
function profile_drawing({ r, z }, bytes) {
  const nodes = r.length, middle = 0.5 * (Math.min(...z) + Math.max(...z));
  const reach = 1.08 * Math.max(...r, 0.5 * (Math.max(...z) - Math.min(...z)));
  const drawing = svg("svg", { viewBox: `${-reach} ${-reach} ${2 * reach} ${2 * reach}`, role: "img", "aria-label": "cross section" });
  drawing.append(svg("path", { class: "middle", d: `M0 ${-reach}V${reach}` }));
  for (const side of [1, -1])
    for (let i = 0; i + 1 < nodes; ++i) {
      const at = (k) => `${side * r[k]} ${middle - z[k]}`;
      const stroke = `rgb(${bytes[3 * i]},${bytes[3 * i + 1]},${bytes[3 * i + 2]})`;
      drawing.append(svg("path", { d: `M${at(i)}L${at(i + 1)}`, stroke, "stroke-width": 0.045 * reach, "stroke-linecap": "round" }));
    }
  return drawing;
}

const cells = (tag, texts) => texts.map((text) => element(tag, {}, text));

// Eigenvalues and rates by m, those that the scan has.
function modes_table(row, units) {
  const columns = [
    ["eigenvalue_m", "least second derivative of the energy"],
    ["rate_m", "largest rate"],
  ].filter(([name]) => row[`${name}0`]);
  if (!columns.length) return "";
  const known = Object.keys(row).flatMap((name) => name.match(/^eigenvalue_m(\d+)$/)?.[1] ?? []).filter((m) => row[`eigenvalue_m${m}`]);
  const line = (m) =>
    element("tr", { class: Number(row[`eigenvalue_m${m}`]) < 0 ? "unstable" : "" }, ...cells("td", [m, ...columns.map(([name]) => row[name + m])]));
  return element(
    "div",
    { class: "modes" },
    element("h4", {}, "Modes u(s) cos mφ"),
    element(
      "table",
      {},
      element("thead", {}, element("tr", {}, ...cells("th", ["m", ...columns.map(([name, title]) => units.titled(`${name}0`, title))]))),
      element("tbody", {}, ...known.map(line)),
    ),
  );
}

function numbers_table({ columns, units }, row) {
  const line = (column) => element("tr", { "data-column": column }, element("th", { scope: "row" }, units.titled(column)), element("td", {}, row[column]));
  return element(
    "details",
    { open: true },
    element("summary", {}, units.there ? "All numbers of scan.csv, in physical units" : "All numbers, as in scan.csv"),
    element("table", { class: "numbers" }, element("tbody", {}, ...columns.map(line))),
  );
}

// One point of a scan: its neighbours, its shape, its modes and all its numbers.
import { colour_bytes } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { choice, element, svg } from "../dom.js";
import { Amplitude } from "../modes/amplitude.js";
import { displaced, displacement_by, fields_of, reach_of } from "../modes/revolved_mode.js";
import { at_rest, modes_table } from "../modes/table.js";
import { numbers_table } from "../numbers.js";
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
    this.mode = at_rest;
    this.heading = element("h3");
    this.remark = element("p", { class: "note" });
    this.near = element("div", { class: "near", role: "group", "aria-label": "neighbours" });
    this.profile = element("div", { class: "profile" });
    this.view = new SurfaceView("the shape");
    this.bar = element("div");
    this.numbers = element("div", { class: "numbers-of" });
    this.shape = element("div", { class: "shape" }, this.profile, this.view.element);
    this.amplitude = new Amplitude((amplitude) => this.draw_shape(amplitude));
    this.element = element(
      "div",
      { class: "point" },
      this.heading,
      this.remark,
      this.near,
      this.controls(),
      this.shape,
      this.bar,
      this.amplitude.element,
    );
  }

  controls() {
    const field = choice("colour by", [["order", "order β"], ["H", "mean curvature H"], ["u", "displacement"]], "order", (chosen) => {
      if (this.mode === at_rest) this.field = chosen;
      else this.mode_field = chosen;
      this.amplitude.tell();
    });
    const open = element("input", {
      type: "checkbox",
      onchange: () => {
        this.open = open.checked;
        this.amplitude.tell();
      },
    });
    this.field_select = field.querySelector("select");
    return element("div", { class: "controls" }, field, element("label", { class: "choice" }, open, "cut open"));
  }

  show(point, map) {
    const mode = point === this.point ? this.mode : at_rest;
    this.point = point;
    this.profile_of_point = point.profile();
    this.heading.textContent = name_of(point);
    const { status, stop_reason: reason } = point.row;
    this.remark.textContent =
      (status === "stationary" ? status : `${status}: ${reason || "no reason is given"}`) +
      (this.profile_of_point ? "" : "; its profile is not in the folder");
    this.near.replaceChildren(...this.neighbours(map));
    this.numbers.replaceChildren(this.modes(point), numbers_table(this.scan.columns, this.scan.units, point.row, "scan.csv"));
    this.choose_mode(mode);
  }

  // Their numbers; their shapes, or how to have these.
  modes({ row, modes }) {
    const { units, folder } = this.scan;
    const parts = [
      numbers_of_modes(row, units),
      modes.length ? element("div", { class: "wide" }, modes_table([at_rest, ...modes], Object.keys(modes[0].row), units, (mode) => this.choose_mode(mode))) : null,
      !modes.length && row.status === "stationary" ? how_to_have_modes(folder, row) : null,
    ].filter((part) => part);
    return parts.length ? element("div", { class: "modes" }, element("h4", {}, "Modes u(s) cos mφ"), ...parts) : "";
  }
  choose_mode(mode) {
    this.mode = mode;
    if (mode.radio) mode.radio.checked = true;
    const is_at_rest = mode === at_rest;
    this.amplitude.element.hidden = is_at_rest;
    for (const option of this.field_select.options) option.disabled = option.value === (is_at_rest ? "u" : "H");
    if (is_at_rest) this.amplitude.stop();
    else this.amplitude.tell();
  }

  neighbours(map) {
    const button = (text, to) =>
      element("button", { type: "button", disabled: !to, title: to ? undefined : "There is no point.", onclick: () => this.on.choose(to) }, text);
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

  draw_shape(amplitude) {
    const shown = this.profile_of_point && (this.mode === at_rest ? this.at_rest() : this.displaced(amplitude));
    this.shape.hidden = this.bar.hidden = !shown;
    if (!shown) return;
    const { rest, surface, value, range, bar, halves, room } = shown;
    const bytes = (values) => colour_bytes(this.colours(), range, values);
    this.field_select.value = shown.field;
    this.profile.replaceChildren(profile_drawing(rest, halves, room, bytes));
    this.view.show(surface, bytes(surface.at(value)), room);
    this.bar.replaceChildren(bar);
  }
  at_rest() {
    const profile = this.profile_of_point, uniform = range_of([...profile.order]);
    const field = this.field ?? (uniform[0] === uniform[1] ? "H" : "order");
    const range = range_of([...profile[field]]);
    const half = { ...profile, values: profile[field] };
    return {
      field,
      range,
      surface: revolved(profile, { open: this.open }),
      value: (node) => profile[field][node],
      bar: field_bar(this.scan.units, field, this.colours(), range),
      rest: profile,
      halves: [half, half],
      room: null,
    };
  }
  displaced(amplitude) {
    const { shape, row } = this.mode, mode = shape(), m = Number(row.m);
    const field = this.mode_field ?? "u", { title, value, range } = fields_of(mode, m, amplitude)[field];
    const by = displacement_by(mode, m, amplitude);
    const half = (phi) => ({
      r: mode.r.map((r, i) => r + by(i, phi)[0]),
      z: mode.z.map((z, i) => z + by(i, phi)[1]),
      values: mode.r.map((_, i) => value(i, phi)),
    });
    return {
      field,
      range,
      value,
      surface: displaced(mode, m, amplitude, { open: this.open }),
      bar: colour_bar(title, this.colours(), range),
      rest: mode,
      halves: [half(0), half(Math.PI)],
      room: reach_of(mode),
    };
  }
}

const field_bar = (units, field, colours, range) =>
  field === "order" ? colour_bar("order β", colours, range) : colour_bar(units.titled("H", "mean curvature H"), colours, units.shown("H", range));

// The cross section, both halves, each piece in its colour; with `room` for it when displaced, that at rest below it.
function profile_drawing(rest, halves, room, bytes) {
  const height = Math.max(...rest.z) - Math.min(...rest.z), middle = 0.5 * (Math.min(...rest.z) + Math.max(...rest.z));
  const reach = room ?? 1.08 * Math.max(...rest.r, 0.5 * height);
  const drawing = svg("svg", { viewBox: `${-reach} ${-reach} ${2 * reach} ${2 * reach}`, role: "img", "aria-label": "cross section" });
  drawing.append(svg("path", { class: "middle", d: `M0 ${-reach}V${reach}` }));
  for (const [{ r, z, values }, side] of [[halves[0], 1], [halves[1], -1]]) {
    const colours = bytes(values), at = (curve, node) => `${side * curve.r[node]} ${middle - curve.z[node]}`;
    if (room) drawing.append(svg("path", { class: "rest", d: `M${Array.from(rest.r, (_, node) => at(rest, node)).join("L")}` }));
    for (let i = 0; i + 1 < r.length; ++i) {
      const stroke = `rgb(${colours[3 * i]},${colours[3 * i + 1]},${colours[3 * i + 2]})`;
      const d = `M${at({ r, z }, i)}L${at({ r, z }, i + 1)}`;
      drawing.append(svg("path", { d, stroke, "stroke-width": 0.045 * reach, "stroke-linecap": "round" }));
    }
  }
  return drawing;
}

const cells = (tag, texts) => texts.map((text) => element(tag, {}, text));

// Eigenvalues and rates by m, those that the scan has.
function numbers_of_modes(row, units) {
  const columns = [
    ["eigenvalue_m", "least second derivative of the energy"],
    ["rate_m", "largest rate"],
  ].filter(([name]) => row[`${name}0`]);
  if (!columns.length) return null;
  const known = Object.keys(row).flatMap((name) => name.match(/^eigenvalue_m(\d+)$/)?.[1] ?? []).filter((m) => row[`eigenvalue_m${m}`]);
  const line = (m) =>
    element("tr", { class: Number(row[`eigenvalue_m${m}`]) < 0 ? "unstable" : "" }, ...cells("td", [m, ...columns.map(([name]) => row[name + m])]));
  return element(
    "table",
    {},
    element("thead", {}, element("tr", {}, ...cells("th", ["m", ...columns.map(([name, title]) => units.titled(`${name}0`, title))]))),
    element("tbody", {}, ...known.map(line)),
  );
}

function how_to_have_modes(folder, { model, branch, reduced_volume: V, L }) {
  const of = `--model ${model} --branch ${branch} --reduced-volume ${V} --L ${L}`;
  const command = `sbeh modes --scan ${folder} ${of} -o ${folder}/modes/${model}_${branch}_v${V}_L${L}`;
  return element("p", { class: "note" }, "To have their shapes here: ", element("code", {}, command), ", then make this report again.");
}

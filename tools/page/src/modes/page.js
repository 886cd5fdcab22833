// The live page of the modes of a state: one of them, with an amplitude, on the surface.
import { csvParse } from "d3";
import { colour_bytes, colour_map_choices } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { Units } from "../data.js";
import { choice, element } from "../dom.js";
import { revolved } from "../surface/revolved.js";
import { SurfaceView } from "../surface/view.js";

const largest = 0.3, usual = 0.15; // amplitudes
const steps = 60; // of a swing
const frame_milliseconds = 40;

// A mode file's columns as numbers, with the outward normals (−t_z, t_r).
function read_mode(text) {
  const rows = csvParse(text, (row) => Object.fromEntries(Object.entries(row).map(([name, value]) => [name, Number(value)])));
  const column = (name) => rows.map((row) => row[name]);
  const [r, z] = [column("r"), column("z")], last = rows.length - 1;
  const normals = rows.map((_, i) => {
    if (i === 0 || i === last) return [0, i === 0 ? 1 : -1];
    const t = [r[i + 1] - r[i - 1], z[i + 1] - z[i - 1]], size = Math.hypot(...t);
    return [-t[1] / size, t[0] / size];
  });
  return { r, z, order: column("order"), u: column("displacement"), b: column("order_change"), normals };
}

const name_of = ({ m, parity, number }) => `m${m}_${parity}_${number}`;

export class ModesPage {
  constructor(parts) {
    this.units = new Units(parts);
    this.modes = parts
      .table("modes.csv")
      .map((row) => ({ row, part: `modes/${name_of(row)}.csv` }))
      .filter(({ part }) => parts.has(part))
      .map(({ row, part }) => ({ row, ...read_mode(parts.get(part)) }));
    if (!this.modes.length) throw new Error("the files of the modes are not in the folder");
    this.choices = { field: "u", colours: "viridis" };
    this.view = new SurfaceView("the state, displaced by the mode");
    this.bar = element("div");
    this.said = element("output", { class: "said", "aria-live": "polite" });
    this.slider = element("input", {
      type: "range",
      min: String(-largest),
      max: String(largest),
      step: "0.01",
      value: String(usual),
      "aria-label": "amplitude",
      oninput: () => this.draw(),
    });
    this.swing_button = element("button", { type: "button", onclick: () => this.swing() }, "Swing");
    this.amplitude = element("output", { class: "time" });
    this.element = element(
      "div",
      { class: "explore-run explore-modes" },
      this.controls(),
      element("div", { class: "two" }, element("div", {}, this.view.element, this.bar), this.table()),
      element("div", { class: "slide" }, this.swing_button, this.slider, this.amplitude),
      this.said,
    );
    this.choose(this.modes.reduce((least, mode) => (Number(mode.row.eigenvalue) < Number(least.row.eigenvalue) ? mode : least)));
  }

  controls() {
    const select = (key, label, options) =>
      choice(label, options, this.choices[key], (value) => {
        this.choices[key] = value;
        this.draw();
      });
    return element(
      "div",
      { class: "controls" },
      select("field", "colour by", [["u", "displacement"], ["order", "order β"]]),
      select("colours", "colours", colour_map_choices),
    );
  }

  // The numbers of modes.csv, a mode to be chosen in each row.
  table() {
    const columns = Object.keys(this.modes[0].row);
    const line = (mode) => {
      const { row } = mode;
      mode.radio = element("input", { type: "radio", name: "mode", "aria-label": `m = ${row.m}, ${row.parity}, ${row.number}`, onchange: () => this.choose(mode) });
      return element(
        "tr",
        { "data-mode": name_of(row), class: Number(row.eigenvalue) < 0 ? "unstable" : "", onclick: () => this.choose(mode) },
        element("td", {}, mode.radio),
        ...columns.map((column) => element("td", {}, row[column])),
      );
    };
    return element(
      "div",
      { class: "modes wide" },
      element(
        "table",
        {},
        element("thead", {}, element("tr", {}, element("th"), ...columns.map((column) => element("th", {}, this.units.titled(column))))),
        element("tbody", {}, ...this.modes.map(line)),
      ),
    );
  }

  choose(mode) {
    this.mode = mode;
    mode.radio.checked = true;
    const { m, parity, number, eigenvalue, rate } = mode.row;
    this.said.textContent = `m = ${m}, ${parity}, ${number}: λ = ${this.units.after("eigenvalue", eigenvalue)}` + (rate ? `, rate ${this.units.after("rate", rate)}` : "");
    this.draw();
  }

  draw(amplitude = Number(this.slider.value)) {
    const { mode } = this, m = Number(mode.row.m);
    const { field, colours } = this.choices;
    const surface = revolved(mode, {
      displaced: (i, phi) => mode.normals[i].map((n) => amplitude * mode.u[i] * Math.cos(m * phi) * n),
    });
    const value = (i, phi) =>
      field === "u" ? amplitude * mode.u[i] * Math.cos(m * phi) : mode.order[i] + amplitude * mode.b[i] * Math.cos(m * phi);
    const values = surface.at((i, phi) => value(i, phi));
    const range = field === "u" ? symmetric(largest, mode.u) : order_range(mode);
    this.view.show(surface, colour_bytes(colours, range, values));
    this.bar.replaceChildren(colour_bar(field === "u" ? "displacement along the normal" : "order β", colours, range));
    this.amplitude.textContent = `amplitude ${amplitude.toFixed(2)}`;
  }

  swing() {
    if (this.swinging) {
      clearInterval(this.swinging);
      this.swinging = null;
      this.swing_button.textContent = "Swing";
      return this.draw();
    }
    this.swing_button.textContent = "Stop";
    let k = 0;
    this.swinging = setInterval(() => this.draw(Number(this.slider.value) * Math.cos((2 * Math.PI * ++k) / steps)), frame_milliseconds);
  }
}

function symmetric(amplitude, values) {
  const most = amplitude * Math.max(...values.map(Math.abs));
  return [-most, most];
}

// What the order has with the largest amplitude.
function order_range({ order, b }) {
  const reach = order.flatMap((value, i) => [value - largest * Math.abs(b[i]), value + largest * Math.abs(b[i])]);
  return [Math.min(...reach), Math.max(...reach)];
}

// The live page of the modes of a state: one of them, with an amplitude, on the surface.
import { csvParse } from "d3";
import { colour_bytes, colour_map_choices } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { Units } from "../data.js";
import { choice, element } from "../dom.js";
import { SurfaceView } from "../surface/view.js";
import { Amplitude } from "./amplitude.js";
import { displaced, fields_of, reach_of, with_normals } from "./revolved_mode.js";
import { label_of_mode, modes_table, name_of_mode } from "./table.js";

function read_mode(text) {
  const rows = csvParse(text, (row) => Object.fromEntries(Object.entries(row).map(([name, value]) => [name, Number(value)])));
  const column = (name) => rows.map((row) => row[name]);
  return with_normals({ r: column("r"), z: column("z"), order: column("order"), u: column("displacement"), b: column("order_change") });
}

export class ModesPage {
  constructor(parts) {
    this.units = new Units(parts);
    this.modes = parts
      .table("modes.csv")
      .map((row) => ({ name: name_of_mode(row), label: label_of_mode(row), row, has_shape: true }))
      .filter(({ name }) => parts.has(`modes/${name}.csv`))
      .map((mode) => ({ ...mode, ...read_mode(parts.get(`modes/${mode.name}.csv`)) }));
    if (!this.modes.length) throw new Error("the files of the modes are not in the folder");
    this.choices = { field: "u", colours: "viridis" };
    this.view = new SurfaceView("the state, displaced by the mode");
    this.bar = element("div");
    this.said = element("output", { class: "said", "aria-live": "polite" });
    this.amplitude = new Amplitude((amplitude) => this.draw(amplitude));
    const table = element("div", { class: "modes wide" }, modes_table(this.modes, Object.keys(this.modes[0].row), this.units, (mode) => this.choose(mode)));
    this.element = element(
      "div",
      { class: "explore-run explore-modes" },
      this.controls(),
      element("div", { class: "two" }, element("div", {}, this.view.element, this.bar), table),
      this.amplitude.element,
      this.said,
    );
    this.choose(this.modes.reduce((least, mode) => (Number(mode.row.eigenvalue) < Number(least.row.eigenvalue) ? mode : least)));
  }

  controls() {
    const select = (key, label, options) =>
      choice(label, options, this.choices[key], (value) => {
        this.choices[key] = value;
        this.amplitude.tell();
      });
    return element(
      "div",
      { class: "controls" },
      select("field", "colour by", [["u", "displacement"], ["order", "order β"]]),
      select("colours", "colours", colour_map_choices),
    );
  }

  choose(mode) {
    this.mode = mode;
    mode.radio.checked = true;
    const { eigenvalue, rate } = mode.row;
    this.said.textContent = `${mode.label}: λ = ${this.units.after("eigenvalue", eigenvalue)}` + (rate ? `, rate ${this.units.after("rate", rate)}` : "");
    this.amplitude.tell();
  }

  draw(amplitude) {
    const { field, colours } = this.choices, m = Number(this.mode.row.m);
    const surface = displaced(this.mode, m, amplitude);
    const { title, value, range } = fields_of(this.mode, m, amplitude)[field];
    this.view.show(surface, colour_bytes(colours, range, surface.at(value)), reach_of(this.mode));
    this.bar.replaceChildren(colour_bar(title, colours, range));
  }
}

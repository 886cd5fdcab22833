// One rest state: its neighbours, its shape, displaced by its modes, and all its numbers.
import { element } from "../dom.js";
import { Amplitude, displacements, orders } from "../modes/amplitude.js";
import { modes_table } from "../modes/table.js";
import { number_lines, numbers_table } from "../numbers.js";
import { FilmView } from "../surface/film_view.js";
import { normals_of } from "../surface/normals.js";
import { radius_of } from "../surface/view.js";

const fields = [
  ["order", "order β", 0],
  ["H", "mean curvature H", 0.01],
  ["u", "displacement", 0],
]; // and the part of the nodes whose values may lie beyond the colours
const told = ["energy", "energy_error", "class", "negative_directions", "residual"];

export function name_of({ row, followed }, units) {
  const other = followed ? `, ${followed} = ${units.after(followed, row[followed])}` : "";
  return `state ${row.number}: ${row.model} ${row.branch}, V_r = ${row.reduced_volume}, L = ${row.L}${other}`;
}

// `element` and, to be placed elsewhere, `eigenpairs` and `numbers`.
export class StatePanel {
  // on: { choose(point) }
  constructor(states, on) {
    this.states = states;
    this.on = on;
    this.heading = element("h3");
    this.remark = element("p", { class: "note" });
    this.near = element("div", { class: "near", role: "group", "aria-label": "neighbours" });
    this.amplitude = new Amplitude((amplitude) => this.draw(amplitude));
    this.view = new FilmView(states.film, {
      label: "the shape",
      fields,
      all: "all states",
      one: "this state",
      units: states.units,
      on_choice: () => this.amplitude.tell(),
    });
    this.rest_field = this.view.choices.field;
    this.told = element("table", { class: "numbers" });
    this.eigenpairs = element("div", { class: "modes" });
    this.numbers = element("div", { class: "numbers-of" });
    this.element = element(
      "div",
      { class: "point" },
      this.heading,
      this.remark,
      this.near,
      this.view.controls,
      this.view.element,
      this.amplitude.element,
      this.told,
    );
  }

  show(point, neighbours) {
    this.point = point;
    const { columns, units } = this.states, { row, modes, frame } = point;
    this.heading.textContent = name_of(point, units);
    this.remark.textContent = remark_on(point);
    this.near.replaceChildren(...neighbours.map(([text, to]) => element("button", { type: "button", disabled: !to, title: to ? undefined : "There is no state.", onclick: () => this.on.choose(to) }, text)));
    this.told.replaceChildren(element("tbody", {}, ...number_lines(told, units, row)));
    this.eigenpairs.replaceChildren(...this.table_of(modes));
    this.numbers.replaceChildren(numbers_table(columns, units, row, "states.csv"));
    this.view.element.hidden = this.view.controls.hidden = !frame;
    this.choose(modes.find((mode) => frame && mode.has_shape && mode.name === this.mode?.name) ?? modes[0]);
  }
  table_of(modes) {
    if (modes.length === 1) return [];
    const { units } = this.states;
    const titled = { titled: (name) => units.titled(name === "eigenvalue" ? "eigenvalue_1" : name, name) };
    const table = modes_table(modes, ["eigenpair", "eigenvalue"], titled, (mode) => this.choose(mode));
    return [element("h4", {}, "Lowest eigenpairs of the second variation"), table];
  }

  choose(mode) {
    const was_at_rest = !this.mode?.row, is_at_rest = !mode.row;
    this.mode = mode;
    if (mode.radio) mode.radio.checked = true;
    this.amplitude.element.hidden = is_at_rest;
    for (const option of this.view.select("field").options) option.disabled = option.value === (is_at_rest ? "u" : "H");
    if (is_at_rest && this.amplitude.swinging) this.amplitude.stop();
    if (was_at_rest === is_at_rest) return this.amplitude.tell();
    if (!is_at_rest) this.rest_field = this.view.choices.field;
    this.view.choose("field", is_at_rest ? this.rest_field : "u");
  }

  draw(amplitude) {
    const { frame } = this.point;
    if (frame) this.view.show(frame, this.mode.row ? this.displaced(frame, amplitude) : null);
  }
  displaced(frame, amplitude) {
    const { surface, normals, reach, order, u, b, ends } = this.unpacked_mode(frame);
    const positions = surface.positions.map((x, k) => x + amplitude * u[Math.floor(k / 3)] * normals[k]);
    return {
      surface: { ...surface, positions },
      reach,
      fields: {
        u: { values: u.map((value) => amplitude * value), ends: ends.u },
        order: { values: order.map((value, i) => value + amplitude * b[i]), ends: ends.order },
      },
    };
  }
  // What no amplitude changes, kept while the mode is shown.
  unpacked_mode(frame) {
    if (this.unpacked?.mode === this.mode) return this.unpacked;
    const { film } = this.states, { u, b } = this.mode.shape();
    const surface = film.surface(frame), order = film.values(frame, "order");
    const ends = { u: displacements(u), order: orders(order, b) };
    const reach = radius_of(surface.positions) + ends.u[1];
    return (this.unpacked = { mode: this.mode, surface, normals: normals_of(surface), reach, order, u, b, ends });
  }
}

function remark_on({ row, frame }) {
  const status = row.status === "stationary" ? row.status : `${row.status}: ${row.stop_reason || "no reason is given"}`;
  const place = { first: "first", fold: "a fold", branching: "others leave here", joins: "joins states with an axis", last: "last" }[row.point];
  if (row.point === "end") return `${status}; an end of the pass ${row.from}${frame ? "" : "; its shape is not in this page"}`;
  const path = row.path ? `; path ${row.path}${place ? `: ${place}` : ""}` : "";
  return status + path + (frame ? "" : "; its shape is not in this page");
}

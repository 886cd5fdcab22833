// The live page of rest states in 3D.
import { choice, element } from "../dom.js";
import { Tip } from "../tip.js";
import { BranchDiagram } from "./diagram.js";
import { name_of, StatePanel } from "./panel.js";
import { numeric, read_states } from "./table.js";

export class StatesPage {
  constructor(parts) {
    this.states = read_states(parts);
    const { points, parameters, quantities } = this.states;
    if (!points.length) throw new Error("states.csv has no rows");
    this.choices = {
      quantity: (quantities.find(({ name }) => name === "energy") ?? quantities[0]).name,
      parameter: parameters[0][0],
    };
    this.diagram = new BranchDiagram(this.states, {
      hover: (point, event) => this.hover(point, event),
      choose: (point) => this.choose(point),
      step: (direction) => this.choose(this.next(this.chosen, direction)),
      enter: () => this.panel.view.view.canvas.focus(),
    });
    this.panel = new StatePanel(this.states, { choose: (point) => this.choose(point) });
    this.tip = new Tip(this.diagram.element);
    this.legend = element("div");
    this.said = element("output", { class: "said", "aria-live": "polite" });
    this.element = element(
      "div",
      { class: "explore-scan explore-states" },
      this.controls(),
      element("div", { class: "two" }, element("div", {}, this.diagram.element, this.legend, this.said, this.panel.eigenpairs), this.panel.element),
      this.panel.numbers,
    );
    this.update();
    this.choose(points.find((point) => point.rests && point.frame) ?? points[0]);
  }

  controls() {
    const select = (key, label, options) => {
      const made = choice(label, options, this.choices[key], (value) => {
        this.choices[key] = value;
        this.update();
      });
      made.querySelector("select").name = key;
      return made;
    };
    return element(
      "div",
      { class: "controls" },
      select("quantity", "quantity", this.states.quantities.map(({ name }) => [name, name])),
      select("parameter", "over", this.states.parameters),
    );
  }
  update() {
    const { quantity, parameter } = this.choices;
    this.quantity = this.states.quantities.find(({ name }) => name === quantity);
    this.diagram.show({ quantity: this.quantity, parameter: this.states.parameters.find(([name]) => name === parameter) }, this.chosen);
    this.legend.replaceChildren(...this.diagram.legend());
    if (this.chosen) this.said.textContent = this.told(this.chosen);
  }

  // To the sides along the path, to its end that lies there; up and down to other paths, to what lies next on these.
  next(point, [across, up]) {
    const { paths } = this.states, { points } = point.path;
    const of = (one) => numeric(one, this.choices.parameter);
    if (across) return points[points.indexOf(point) + (of(points.at(-1)) >= of(points[0]) ? across : -across)];
    const other = paths[paths.indexOf(point.path) + up];
    return other?.points.reduce((a, b) => (Math.abs(of(b) - of(point)) < Math.abs(of(a) - of(point)) ? b : a));
  }
  neighbours(point) {
    const { points, start } = point.path, k = points.indexOf(point);
    const leaving = this.states.paths.filter((path) => path.start === point);
    return [
      ["previous", points[k - 1]],
      ["next", points[k + 1]],
      ...(start ? [[`where it leaves: ${start.row.number}`, start]] : []),
      ...leaving.map((path) => [`path ${path.name} leaves`, path.points[0]]),
    ];
  }

  choose(point) {
    if (!point) return;
    this.chosen = point;
    this.diagram.choose(point);
    this.panel.show(point, this.neighbours(point));
    this.said.textContent = this.told(point);
  }
  told(point) {
    const value = point.row[this.quantity.name];
    return `${name_of(point, this.states.units)}: ${this.quantity.name} = ${value === "" ? "not known" : this.states.units.after(this.quantity.name, value)}`;
  }
  hover(point, event) {
    if (!point) return this.tip.hide();
    const { row } = point;
    const lines = [name_of(point, this.states.units), row.path ? `path ${row.path}, ${row.point}; ${row.status}` : row.status];
    for (const name of new Set([this.quantity.name, "energy", "class", "negative_directions"]))
      if (row[name]) lines.push(`${name} = ${this.states.units.after(name, row[name])}`);
    this.tip.show(event, lines);
  }
}

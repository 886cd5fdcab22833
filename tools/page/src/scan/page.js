// The live page of a scan.
import { class_colours, colour_map_choices, colour_scale, not_known } from "../colours.js";
import { colour_bar, colour_list } from "../colour_bar.js";
import { choice, element } from "../dom.js";
import { Tip } from "../tip.js";
import { Curves } from "./curves.js";
import { Diagram } from "./diagram.js";
import { lines_of } from "./lines.js";
import { name_of, PointPanel } from "./point.js";
import { lowest_branch, map_of, neighbour, number_of, read_scan } from "./table.js";

function colouring(quantity, map, colours, title) {
  const text = (point) => point.row[quantity.name];
  if (quantity.classes) {
    const colour = (value) => class_colours[quantity.classes.indexOf(value)] ?? not_known;
    const present = quantity.classes.filter((value) => map.points.some((p) => p.rests && text(p) === value));
    return {
      colour_of: (point) => colour(text(point)),
      legend: colour_list(title, present.map((value) => [colour(value), value])),
    };
  }
  const values = map.points.filter((p) => p.rests).map((p) => number_of(text(p))).filter(Number.isFinite);
  const range = values.length ? [Math.min(...values), Math.max(...values)] : [0, 0];
  const scale = colour_scale(colours, range);
  return { colour_of: (point) => scale(number_of(text(point))), legend: colour_bar(title, colours, range) };
}

export class ScanPage {
  constructor(parts) {
    this.scan = read_scan(parts);
    const { models, branches, quantities, lowest } = this.scan;
    this.choices = {
      model: models[0],
      branch: branches[0],
      quantity: quantities.find((q) => q.name === "energy")?.name ?? quantities[0].name,
      colours: "viridis",
    };
    this.branches = branches.length > 1 && lowest.length ? [...branches, lowest_branch] : branches;
    this.is_plane = this.scan.V.length > 1 && this.scan.L.length > 1;
    this.diagram = new (this.is_plane ? Diagram : Curves)(this.scan, {
      hover: (point, event) => this.hover(point, event),
      choose: (point) => this.go_to(point),
      step: (direction) => this.step(direction),
      enter: () => this.panel.view.canvas.focus(),
    });
    this.panel = new PointPanel(this.scan, () => this.choices.colours, { choose: (point) => this.go_to(point) });
    this.tip = new Tip(this.diagram.element);
    this.legend = element("div");
    this.said = element("output", { class: "said", "aria-live": "polite" });
    this.element = element(
      "div",
      { class: "explore-scan" },
      this.controls(),
      element("div", { class: "two" }, element("div", {}, this.diagram.element, this.legend, this.said), this.panel.element),
      this.panel.numbers,
    );
    this.update();
    this.choose(this.first_point());
  }

  controls() {
    const named = (names) => names.map((name) => [name, name]);
    const select = (key, label, options) => {
      const made = choice(label, options, this.choices[key], (value) => this.change(key, value));
      made.querySelector("select").name = key;
      return made;
    };
    this.form = element(
      "div",
      { class: "controls" },
      select("quantity", "quantity", named(this.scan.quantities.map((q) => q.name))),
      select("model", "model", named(this.scan.models)),
      select("branch", "branch", named(this.branches)),
      select("colours", "colours", colour_map_choices),
    );
    return this.form;
  }

  change(key, value) {
    this.choices[key] = value;
    this.form.querySelector(`[name=${key}]`).value = value;
    this.update();
    const here = this.map.at(this.chosen?.V, this.chosen?.L);
    this.choose(here ?? this.first_point());
  }

  update() {
    const { model, branch, quantity, colours } = this.choices;
    this.map = map_of(this.scan, model, branch);
    this.quantity = this.scan.quantities.find((q) => q.name === quantity);
    const lines = lines_of(this.scan, model, branch);
    const { colour_of, legend } = colouring(this.quantity, this.map, colours, this.scan.units.titled(quantity));
    const title = `${quantity} of ${model} ${branch}`;
    this.diagram.show({ model, map: this.map, quantity: this.quantity, colour_of, lines, title }, this.chosen);
    this.legend.replaceChildren(this.is_plane ? legend : this.diagram.legend(), this.signs(lines));
  }

  // What else is in the diagram.
  signs(lines) {
    const sign = (name, text) => element("span", {}, element("i", { class: `sign ${name}` }), text);
    const points = this.is_plane ? this.map.points : this.scan.points.filter((p) => p.model === this.choices.model);
    return element(
      "div",
      { class: "classes" },
      ...lines.map((line) => sign(line.style, line.name)),
      points.some((p) => p.rests && number_of(p.row.negative_directions_3d) > 0) ? sign("unstable", "no minimum in 3D") : null,
      points.some((p) => p.row.status === "limit") ? sign("limit", "a neck has closed") : null,
      points.some((p) => !p.rests) ? sign("grey", "unresolved or failed") : null,
    );
  }

  first_point() {
    const { points } = this.map;
    return points.find((p) => p.rests && p.profile()) ?? points[0];
  }
  step(direction) {
    const next = this.chosen && neighbour(this.scan, this.map, this.chosen, direction);
    if (next) this.choose(next);
  }
  // A point that may be of another map.
  go_to(point) {
    this.chosen = point;
    if (point.model !== this.choices.model) this.change("model", point.model);
    if (point.branch !== this.choices.branch && this.map.at(point.V, point.L) !== point) this.change("branch", point.branch);
    this.choose(point);
  }
  choose(point) {
    if (!point) return;
    this.chosen = point;
    this.diagram.choose(point);
    this.panel.show(point, this.map);
    this.said.textContent = this.told(point);
  }

  told(point) {
    const value = point.row[this.quantity.name];
    return `${name_of(point)}: ${this.quantity.name} = ${value === "" ? "not known" : this.scan.units.after(this.quantity.name, value)}`;
  }
  hover(point, event) {
    if (!point) return this.tip.hide();
    const { row } = point;
    const lines = [`V_r = ${row.reduced_volume}, L = ${row.L}`, `${point.model} ${point.branch}, ${row.status}`];
    for (const name of new Set([this.quantity.name, "energy", "order_min", "class"]))
      if (row[name]) lines.push(`${name} = ${this.scan.units.after(name, row[name])}`);
    this.tip.show(event, lines);
  }
}

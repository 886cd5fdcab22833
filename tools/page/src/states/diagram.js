// The branch diagram of rest states: a quantity over a parameter, paths as lines, and the chosen state.
import { axisBottom, axisLeft, select, symbol, symbolCircle, symbolDiamond, symbolSquare, symbolTriangle } from "d3";
import { class_colours, not_known } from "../colours.js";
import { colour_list } from "../colour_bar.js";
import { element, svg } from "../dom.js";
import { axis_titles, height_for, margin, scale_of, short } from "../scan/axis.js";
import { drawing_for, label_of, nearest_point, ring_at } from "../scan/drawing.js";
import { is_minimum, no_path, numeric, pieces_of } from "./table.js";

// What a state is on its path, by its mark.
const marks = {
  branching: [symbolSquare, 60, "others leave"],
  fold: [symbolDiamond, 70, "fold"],
  joins: [symbolTriangle, 55, "joins states with an axis"],
};
const mark_of = ({ row }) => symbol(...(marks[row.point] ?? [symbolCircle, 50]).slice(0, 2))();
const of_neither_side = new Set(["branching", "fold"]);

export class BranchDiagram {
  constructor(states, on) {
    this.states = states;
    this.drawing = drawing_for(on, (x, y) => (this.x ? nearest_point(states.points, (point) => this.place(point), x, y) : null));
    this.element = element("div", { class: "diagram branches" }, this.drawing);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  // shown: { parameter, quantity }
  show(shown, chosen) {
    this.shown = shown;
    this.chosen = chosen;
    this.drawing.setAttribute("aria-label", label_of(`${shown.quantity.name} over ${shown.parameter[1]}`));
    this.draw();
  }
  choose(point) {
    this.chosen = point;
    this.draw_chosen();
  }
  colour(path) {
    return class_colours[this.states.paths.indexOf(path) % class_colours.length];
  }

  draw() {
    const width = this.element.clientWidth;
    if (!this.shown || !width) return;
    const height = height_for(width), bottom = height - margin.bottom;
    const { parameter, quantity } = this.shown, { points, paths } = this.states;
    const texts = (name) => points.map((point) => point.row[name]);
    this.x = scale_of({ classes: null }, texts(parameter[0]), [margin.left, width - margin.right]);
    this.y = scale_of(quantity, texts(quantity.name), [bottom, margin.top + 6]);
    this.bottom = bottom;
    this.drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const across = svg("g", { class: "axis", transform: `translate(0 ${bottom})` });
    const up = svg("g", { class: "axis", transform: `translate(${margin.left} 0)` });
    const ticks = this.x.ticks(Math.min(8, Math.floor(width / 70))).filter((value) => parameter[0] !== "number" || Number.isInteger(value));
    select(across).call(axisBottom(this.x).tickValues(ticks).tickFormat(short));
    select(up).call(quantity.classes ? axisLeft(this.y) : axisLeft(this.y).ticks(6).tickFormat(short));
    const { units } = this.states, titles = axis_titles(width, height, units.titled(...parameter), units.titled(quantity.name));
    this.ring = svg("g", { class: "chosen" });
    const lines = this.states.follows ? paths.filter(({ name }) => name !== no_path).map((path) => this.line(path)) : [];
    this.drawing.replaceChildren(...lines, ...paths.map((path) => this.marks(path)), across, up, ...titles, this.ring);
    this.draw_chosen();
  }

  // What has no value lies on the axis.
  place(point) {
    const { parameter, quantity } = this.shown;
    const y = this.y(quantity.classes ? point.row[quantity.name] : numeric(point, quantity.name));
    return [this.x(numeric(point, parameter[0])), Number.isFinite(y) ? y : this.bottom];
  }
  line(path) {
    const pieces = pieces_of(path).filter(({ begin, end }) => [begin, end].every((point) => this.place(point)[1] < this.bottom));
    const drawn = ({ begin, end, is_minimum: solid }) =>
      svg("path", { class: solid ? "minima" : "saddles", d: `M${this.place(begin)}L${this.place(end)}`, stroke: this.colour(path) });
    return svg("g", { class: "curve" }, ...pieces.map(drawn));
  }
  marks(path) {
    const colour = this.colour(path);
    const fill = (point) => {
      if (!point.rests) return not_known;
      return of_neither_side.has(point.row.point) || is_minimum(point) ? colour : "#fff";
    };
    const mark = (point) =>
      svg("path", {
        class: "mark",
        d: mark_of(point),
        transform: `translate(${this.place(point)})`,
        fill: fill(point),
        stroke: point.rests ? colour : "#83898f",
        "data-number": point.row.number,
      });
    return svg("g", { class: "curve" }, ...path.points.map(mark));
  }
  draw_chosen() {
    if (this.ring) this.ring.replaceChildren(...(this.chosen ? ring_at(this.place(this.chosen)) : []));
  }

  // The paths by their last class, and what else is in the diagram.
  legend() {
    const { paths, points, follows, units } = this.states;
    const sign = (name, text) => element("span", {}, element("i", { class: `sign ${name}` }), text);
    const drawn = ([kind, [shape, size, text]]) =>
      element("span", {}, svg("svg", { class: "mark", viewBox: "-7 -7 14 14" }, svg("path", { d: symbol(shape, size)() })), text);
    const title = (path) => {
      if (!follows) return "states";
      if (path.name === no_path) return "ends of passes";
      return `path ${path.name}: ${path.points.findLast(({ rests }) => rests)?.row.class ?? "no state"}`;
    };
    const pieces = follows ? paths.filter(({ name }) => name !== no_path).flatMap(pieces_of) : [];
    return [
      colour_list(units.titled(this.shown.quantity.name), paths.map((path) => [this.colour(path), title(path)])),
      element(
        "div",
        { class: "classes" },
        pieces.some((piece) => piece.is_minimum) ? sign("minima", "minima") : null,
        pieces.some((piece) => !piece.is_minimum) ? sign("equal", "saddles") : null,
        points.some((point) => point.rests && !is_minimum(point)) ? sign("unstable", "the energy falls in some direction") : null,
        ...Object.entries(marks).filter(([kind]) => points.some(({ row }) => row.point === kind)).map(drawn),
        points.some((point) => !point.rests) ? sign("plain", "unresolved or failed") : null,
      ),
    ];
  }
}

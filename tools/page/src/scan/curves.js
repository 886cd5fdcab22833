// The diagram of a scan over one parameter: a quantity of all branches of a model as curves, and the chosen point.
import { axisBottom, axisLeft, line, select } from "d3";
import { class_colours } from "../colours.js";
import { colour_list } from "../colour_bar.js";
import { element, svg } from "../dom.js";
import { Axis, axis_titles, height_for, margin, scale_of, short } from "./axis.js";
import { drawing_for, label_of, nearest_point, ring_at } from "./drawing.js";
import { number_of } from "./table.js";

export class Curves {
  constructor(scan, on) {
    this.scan = scan;
    this.over_volume = scan.V.length > 1 || scan.L.length === 1;
    this.x = new Axis(this.over_volume ? scan.V : scan.L);
    this.drawing = drawing_for(on, (x, y) => this.nearest(x, y));
    this.element = element("div", { class: "diagram" }, this.drawing);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  // shown: { model, map, quantity, lines, title }
  show(shown, chosen) {
    this.shown = shown;
    this.chosen = chosen;
    this.drawing.setAttribute("aria-label", label_of(`${shown.title} over ${this.over_volume ? "reduced volume" : "L"}`));
    this.draw();
  }
  choose(point) {
    this.chosen = point;
    this.draw_chosen();
  }
  legend() {
    const { model } = this.shown;
    return colour_list(`${this.scan.units.titled(this.shown.quantity.name)} of ${model}`, this.scan.branches.map((branch) => [this.colour(branch), branch]));
  }
  colour(branch) {
    return class_colours[this.scan.branches.indexOf(branch) % class_colours.length];
  }

  draw() {
    const width = this.element.clientWidth;
    if (!this.shown || !width) return;
    const height = height_for(width), bottom = height - margin.bottom;
    const { quantity, model } = this.shown;
    this.points = this.scan.points.filter((p) => p.model === model).sort((a, b) => a.V - b.V || a.L - b.L);
    this.x.fit(margin.left, width - margin.right);
    const texts = this.points.filter((p) => p.rests).map((p) => p.row[quantity.name]);
    this.y = scale_of(quantity, texts, [bottom, margin.top + 6]);
    this.bottom = bottom;
    this.drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const across = svg("g", { class: "axis", transform: `translate(0 ${bottom})` });
    const up = svg("g", { class: "axis", transform: `translate(${margin.left} 0)` });
    select(across).call(this.x.ticks(axisBottom));
    select(up).call(quantity.classes ? axisLeft(this.y) : axisLeft(this.y).ticks(6).tickFormat(short));
    const titles = axis_titles(width, height, this.over_volume ? "reduced volume V_r" : "elastic constant L", this.scan.units.titled(quantity.name));
    this.ring = svg("g", { class: "chosen" });
    this.drawing.replaceChildren(this.lines(), ...this.scan.branches.map((branch) => this.curve(branch)), across, up, ...titles, this.ring);
    this.draw_chosen();
  }

  value(point) {
    const { name, classes } = this.shown.quantity;
    return classes ? point.row[name] : number_of(point.row[name]);
  }
  // Where it is drawn: what has no value of its own lies on the axis.
  place(point) {
    const y = point.rests ? this.y(this.value(point)) : NaN;
    return [this.x.scale(this.over_volume ? point.V : point.L), Number.isFinite(y) ? y : this.bottom];
  }
  curve(branch) {
    const points = this.points.filter((p) => p.branch === branch);
    const stroke = this.colour(branch);
    const drawn = line((p) => this.place(p)[0], (p) => this.place(p)[1]).defined((p) => p.rests && this.place(p)[1] < this.bottom);
    const curve = svg("g", { class: "curve" }, svg("path", { d: drawn(points), stroke }));
    for (const point of points) {
      const [cx, cy] = this.place(point);
      const unstable = number_of(point.row.negative_directions_3d) > 0;
      const fill = !point.rests ? "#a9aeb3" : unstable ? "#fff" : stroke;
      curve.append(svg("circle", { cx, cy, r: 4, fill, stroke: point.rests ? stroke : "#83898f", "data-row": point.index }));
    }
    return curve;
  }
  // Where the scan's lines pass its only value of the other parameter, upright.
  lines() {
    const lines = svg("g", { class: "lines" });
    const [low, high] = [this.x.borders[0], this.x.borders.at(-1)];
    const [along, other] = this.over_volume ? [0, 1] : [1, 0];
    const only = this.over_volume ? this.scan.L[0] : this.scan.V[0];
    for (const { style, points, label } of this.shown.lines)
      for (const point of points) {
        const value = point[along];
        if (point[other] !== only || value < low || value > high) continue;
        const x = this.x.scale(value);
        lines.append(svg("path", { class: style, d: `M${x} ${margin.top}V${this.bottom}` }));
        if (label) lines.append(svg("text", { x: x + 4, y: margin.top + 12 }, label));
      }
    return lines;
  }
  draw_chosen() {
    if (!this.ring) return;
    this.ring.replaceChildren();
    if (!this.chosen || this.chosen.model !== this.shown.model) return;
    this.ring.append(...ring_at(this.place(this.chosen)));
  }
  nearest(x, y) {
    return this.points ? nearest_point(this.points, (point) => this.place(point), x, y) : null;
  }
}

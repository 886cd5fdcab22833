// The diagram of a scan over reduced volume and L: cells in the colours of a quantity, lines, and the chosen point.
import { axisBottom, axisLeft, select } from "d3";
import { not_known } from "../colours.js";
import { element, svg } from "../dom.js";
import { Axis, axis_titles, height_for, margin } from "./axis.js";
import { drawing_for, label_of } from "./drawing.js";
import { number_of } from "./table.js";

const most_dots = 16; // of a line that are drawn large

export class Diagram {
  constructor(scan, on) {
    this.x = new Axis(scan.V);
    this.y = new Axis(scan.L);
    this.drawing = drawing_for(on, (x, y) => this.shown?.map.at(this.x.at(x), this.y.at(y)) ?? null);
    this.element = element("div", { class: "diagram" }, this.drawing);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  // shown: { map, colour_of(point), lines, title }
  show(shown, chosen) {
    this.shown = shown;
    this.chosen = chosen;
    this.drawing.setAttribute("aria-label", label_of(`${shown.title} over reduced volume and L`));
    this.draw();
  }
  choose(point) {
    this.chosen = point;
    this.draw_chosen();
  }

  draw() {
    const width = this.element.clientWidth;
    if (!this.shown || !width) return;
    const height = height_for(width);
    this.x.fit(margin.left, width - margin.right);
    this.y.fit(height - margin.bottom, margin.top);
    this.drawing.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.drawing.replaceChildren(hatching(), this.cells(), this.marks(), this.lines(), ...this.axes(width, height));
    this.ring = svg("g", { class: "chosen" });
    this.drawing.append(this.ring);
    this.draw_chosen();
  }

  place({ V, L }) {
    const [x, width] = this.x.cell(V), [y, height] = this.y.cell(L);
    return { x, y, width, height };
  }
  cells() {
    const cells = svg("g", { class: "cells" });
    for (const point of this.shown.map.points) {
      const fill = point.rests ? this.shown.colour_of(point) : "url(#hatching)";
      cells.append(svg("rect", { ...this.place(point), fill, "data-row": point.index }));
    }
    return cells;
  }
  // Dots on states that are no minima in 3D, rings on limits.
  marks() {
    const marks = svg("g", { class: "marks" });
    for (const point of this.shown.map.points) {
      const kind = point.row.status === "limit" ? "limit" : number_of(point.row.negative_directions_3d) > 0 ? "unstable" : null;
      if (!kind || !point.rests) continue;
      const { x, y, width, height } = this.place(point);
      const r = Math.min(Math.max(Math.min(width, height) / 6, 1.1), 4);
      marks.append(svg("circle", { class: kind, cx: x + width / 2, cy: y + height / 2, r }));
    }
    return marks;
  }
  lines() {
    const lines = svg("g", { class: "lines" });
    const at = ([V, L]) => [this.x.scale(V), this.y.scale(L)];
    const inside = (p) => p[0] >= this.x.borders[0] && p[0] <= this.x.borders.at(-1) && p[1] >= this.y.borders[0] && p[1] <= this.y.borders.at(-1);
    for (const { style, points, pieces, label } of this.shown.lines) {
      const path = pieces.filter((piece) => piece.every(inside)).map(([a, b]) => `M${at(a)}L${at(b)}`).join("");
      lines.append(svg("path", { class: "halo", d: path }), svg("path", { class: style, d: path }));
      const seen = points.filter(inside);
      const r = seen.length > most_dots ? 0.9 : 2.2;
      for (const [x, y] of seen.map(at)) lines.append(svg("circle", { class: style, cx: x, cy: y, r }));
      if (!label || !seen.length) continue;
      const [x, y] = at(seen[Math.floor(seen.length / 2)]);
      lines.append(svg("text", { x: x + 6, y: y - 6 }, label));
    }
    return lines;
  }
  axes(width, height) {
    const across = svg("g", { class: "axis", transform: `translate(0 ${height - margin.bottom})` });
    const up = svg("g", { class: "axis", transform: `translate(${margin.left} 0)` });
    select(across).call(this.x.ticks(axisBottom));
    select(up).call(this.y.ticks(axisLeft));
    return [across, up, ...axis_titles(width, height, "reduced volume V_r", "elastic constant L")];
  }
  draw_chosen() {
    if (!this.ring) return;
    this.ring.replaceChildren();
    if (!this.chosen) return;
    const { x, y, width, height } = this.place(this.chosen);
    for (const name of ["outer", "inner"]) this.ring.append(svg("rect", { class: name, x, y, width, height }));
  }
}

function hatching() {
  return svg(
    "defs",
    {},
    svg(
      "pattern",
      { id: "hatching", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
      svg("rect", { width: 6, height: 6, fill: not_known }),
      svg("rect", { width: 2, height: 6, fill: "#83898f" }),
    ),
  );
}

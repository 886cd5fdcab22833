// The diagram of a scan over reduced volume and L: cells in the colours of a quantity, lines, and the chosen point.
import { axisBottom, axisLeft, bisectRight, scaleLinear, scaleLog, select } from "d3";
import { not_known } from "../colours.js";
import { element, svg } from "../dom.js";
import { number_of } from "./table.js";

const margin = { left: 58, right: 14, top: 10, bottom: 46 };
const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const most_named_ticks = 8;
const most_dots = 16; // of a line that are drawn large

// Logarithmic where the values are more evenly spread so.
function is_logarithmic(values) {
  if (values.length < 3 || values[0] <= 0) return false;
  const unevenness = (v) => {
    const steps = v.slice(1).map((x, k) => x - v[k]);
    return Math.max(...steps) / Math.min(...steps);
  };
  return unevenness(values.map(Math.log)) < 0.9 * unevenness(values);
}

// Borders between the cells of the values, halfway.
function borders(values, logarithmic) {
  const to = logarithmic ? Math.log : (x) => x, back = logarithmic ? Math.exp : (x) => x;
  const v = values.map(to);
  if (v.length === 1) return [back(v[0] - 0.05 * (Math.abs(v[0]) || 1)), back(v[0] + 0.05 * (Math.abs(v[0]) || 1))];
  const inner = v.slice(1).map((x, k) => 0.5 * (x + v[k]));
  const first = v[0] - (inner[0] - v[0]), last = v.at(-1) + (v.at(-1) - inner.at(-1));
  return [first, ...inner, last].map(back);
}

class Axis {
  constructor(values) {
    this.values = values;
    this.logarithmic = is_logarithmic(values);
    this.borders = borders(values, this.logarithmic);
  }
  fit(from, to) {
    const domain = [this.borders[0], this.borders.at(-1)];
    this.scale = (this.logarithmic ? scaleLog : scaleLinear)(domain, [from, to]);
  }
  ticks(side) {
    const axis = side(this.scale);
    return this.values.length <= most_named_ticks ? axis.tickValues(this.values).tickFormat(String) : axis.ticks(6, "~g");
  }
  cell(value) {
    const k = this.values.indexOf(value);
    const [a, b] = [this.scale(this.borders[k]), this.scale(this.borders[k + 1])];
    return [Math.min(a, b), Math.abs(b - a)];
  }
  // The value in whose cell a place lies.
  at(place) {
    return this.values[bisectRight(this.borders, this.scale.invert(place)) - 1];
  }
}

export class Diagram {
  // on: { hover(point or null, x, y), choose(point), step(direction), enter() }
  constructor(scan, on) {
    this.on = on;
    this.x = new Axis(scan.V);
    this.y = new Axis(scan.L);
    this.drawing = svg("svg", {
      tabindex: "0",
      role: "application",
      "aria-roledescription": "diagram",
      onkeydown: (event) => this.on_key(event),
      onpointermove: (event) => this.on.hover(this.point_at(event), event),
      onpointerleave: (event) => this.on.hover(null, event),
      onclick: (event) => {
        const point = this.point_at(event);
        if (point) this.on.choose(point);
      },
    });
    this.element = element("div", { class: "diagram" }, this.drawing);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  // shown: { map, colour_of(point), lines, title }
  show(shown, chosen) {
    this.shown = shown;
    this.chosen = chosen;
    this.drawing.setAttribute("aria-label", `${shown.title} over reduced volume and L: arrow keys go from point to point, Enter goes to the shape`);
    this.draw();
  }
  choose(point) {
    this.chosen = point;
    this.draw_chosen();
  }

  draw() {
    const width = this.element.clientWidth;
    if (!this.shown || !width) return;
    const height = Math.round(Math.min(Math.max(0.72 * width, 290), 520));
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
    const middle = 0.5 * (margin.top + height - margin.bottom);
    return [
      across,
      up,
      svg("text", { class: "title", x: 0.5 * (margin.left + width - margin.right), y: height - 8 }, "reduced volume V_r"),
      svg("text", { class: "title", transform: `translate(13 ${middle}) rotate(-90)` }, "elastic constant L"),
    ];
  }
  draw_chosen() {
    if (!this.ring) return;
    this.ring.replaceChildren();
    if (!this.chosen) return;
    const { x, y, width, height } = this.place(this.chosen);
    for (const name of ["outer", "inner"]) this.ring.append(svg("rect", { class: name, x, y, width, height }));
  }

  point_at(event) {
    const box = this.drawing.getBoundingClientRect();
    const V = this.x.at(event.clientX - box.left), L = this.y.at(event.clientY - box.top);
    return this.shown?.map.at(V, L) ?? null;
  }
  on_key(event) {
    if (event.key in directions) this.on.step(directions[event.key]);
    else if (event.key === "Enter") this.on.enter();
    else return;
    event.preventDefault();
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

// Axes of a diagram over the values of a grid.
import { bisectRight, scaleLinear, scaleLog, scalePoint } from "d3";
import { svg } from "../dom.js";
import { number_of } from "./table.js";

export const margin = { left: 72, right: 14, top: 10, bottom: 46 };
const most_named_ticks = 8;

export const height_for = (width) => Math.round(Math.min(Math.max(0.72 * width, 290), 520));
// Four digits.
export const short = (value) =>
  value !== 0 && Math.abs(value) < 1e-3 ? value.toExponential(3).replace(/\.?0+e/, "e") : String(Number(value.toPrecision(4)));

export function axis_titles(width, height, across, up) {
  const middle = 0.5 * (margin.top + height - margin.bottom);
  return [
    svg("text", { class: "title", x: 0.5 * (margin.left + width - margin.right), y: height - 8 }, across),
    svg("text", { class: "title", transform: `translate(13 ${middle}) rotate(-90)` }, up),
  ];
}

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

export class Axis {
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
    return this.values.length <= most_named_ticks ? axis.tickValues(this.values).tickFormat(short) : axis.ticks(6, "~g");
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

// Of a quantity that has these values: numbers, or classes.
export function scale_of(quantity, texts, range) {
  if (quantity.classes) return scalePoint(quantity.classes.filter((name) => texts.includes(name)), range).padding(0.5);
  const values = texts.map(number_of).filter(Number.isFinite);
  if (!values.length) return scaleLinear([0, 1], range);
  const low = Math.min(...values), high = Math.max(...values);
  const room = high > low ? 0.05 * (high - low) : 0.1 * (Math.abs(high) || 1);
  return scaleLinear([low - room, high + room], range);
}

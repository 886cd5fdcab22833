// The history of a run as charts over time, with a line at the frame that is shown.
import uPlot from "uplot";
import { colour_of_page, element } from "../dom.js";

const height = 200;
const least_span = 1e-9; // of the values: less is rounding
const shown_decades = 16;
const dashes = [[], [8, 3], [2, 3], [8, 3, 2, 3]]; // told apart without colours too
const logarithmic = 3; // uPlot's number of a logarithmic axis

const is_decade = (value) => value !== null && Math.abs(Math.log10(value) % 1) < 1e-6;
const decades = (_, values) => values.map((value) => (is_decade(value) ? value : null));
const decade_texts = (_, values) => values.map((value) => (is_decade(value) ? value.toExponential(0).replace("e+", "e") : ""));

const linear_texts = (_, values) => values.map((value) => String(Number(value.toPrecision(8))));
const short = (value) => (value === null ? "" : String(Number(value.toPrecision(3))));

function linear_range(_, low, high) {
  const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
  const margin = high - low > least_span * size ? 0.06 * (high - low) : 0.1 * size;
  return [low - margin, high + margin];
}

// From the rows of charts.csv, one per line: { title, y_name, logarithmic, least_dissipation, lines }.
function charts_of(rows) {
  const charts = new Map();
  for (const row of rows) {
    const chart = { ...row, logarithmic: row.logarithmic === "1", least_dissipation: Number(row.least_dissipation), lines: [] };
    if (!charts.has(row.title)) charts.set(row.title, chart);
    charts.get(row.title).lines.push(row);
  }
  return [...charts.values()];
}

const dissipation_of = (row) =>
  ["friction", "order", "viscous"].map((part) => Number(row[`dissipation_${part}`] ?? 0)).reduce((a, b) => a + b);

// The lines of a chart that have something to show, null where there is nothing or an axis has no place for it. On a
// logarithmic one that is also what is `shown_decades` below the largest value: it is rounding.
function lines_of(chart, rows) {
  const most = rows.reduce((top, row) => Math.max(top, dissipation_of(row)), 0);
  const says = (row) => !(dissipation_of(row) < chart.least_dissipation * most);
  const lines = chart.lines.map(({ column, called }, k) => ({
    called,
    colour: `--c${k}`,
    dash: dashes[k],
    values: rows.map((row) => (says(row) && row[column] ? Number(row[column]) : NaN)),
  }));
  const largest = lines.reduce((top, { values }) => values.reduce((a, b) => (b > a ? b : a), top), 0);
  const floor = chart.logarithmic ? largest / 10 ** shown_decades : -Infinity;
  for (const line of lines) line.values = line.values.map((value) => (Number.isFinite(value) && value > floor ? value : null));
  return lines.filter(({ values }) => values.filter((value) => value !== null).length > 1);
}

export class Charts {
  // `charts`: the rows of charts.csv; `time_name`; on_time(time): a time was clicked.
  constructor(series, charts, time_name, on_time) {
    this.series = series;
    this.time_name = time_name;
    this.on_time = on_time;
    this.times = series.map((row) => Number(row.time));
    this.log_time = this.times.at(-1) > 1000 * (this.times.find((time) => time > 0) ?? Infinity);
    const box = element("input", { type: "checkbox", onchange: () => this.draw(box.checked) });
    box.checked = this.log_time;
    this.places = charts_of(charts).map((chart) => ({ chart, place: element("div", { class: "chart" }) }));
    this.element = element(
      "div",
      {},
      element("label", { class: "choice" }, box, "logarithmic time"),
      element("div", { class: "live-charts" }, ...this.places.map(({ place }) => place)),
    );
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  draw(log_time = this.log_time) {
    this.log_time = log_time;
    this.plots?.forEach((plot) => plot.destroy());
    this.plots = this.places.map(({ chart, place }) => this.plot(chart, place));
  }

  plot(chart, place) {
    const rows = this.series.filter((row) => !this.log_time || Number(row.time) > 0);
    const lines = lines_of(chart, rows);
    place.hidden = lines.length === 0;
    const data = [rows.map((row) => Number(row.time)), ...lines.map(({ values }) => values)];
    const ink = colour_of_page("--soft"), grid = { stroke: colour_of_page("--line"), width: 1 };
    const axis = { stroke: ink, grid, ticks: grid, font: "12px system-ui, sans-serif" };
    const log_axis = { ...axis, values: decade_texts, grid: { ...grid, filter: decades }, ticks: { ...grid, filter: decades } };
    const options = {
      width: Math.max(place.clientWidth, 200),
      height,
      title: chart.title,
      scales: {
        x: { time: false, distr: this.log_time ? logarithmic : 1 },
        y: chart.logarithmic ? { distr: logarithmic } : { range: linear_range },
      },
      axes: [
        { ...(this.log_time ? log_axis : axis), size: 30 },
        { ...(chart.logarithmic ? log_axis : { ...axis, values: linear_texts }), size: 60, label: chart.y_name, labelSize: 20, labelFont: "12px system-ui, sans-serif" },
      ],
      series: [
        { label: this.time_name, value: (_, v) => short(v) },
        ...lines.map(({ called, colour, dash }) => ({
          label: called,
          stroke: colour_of_page(colour),
          dash,
          width: 1.8,
          points: { show: false },
          value: (_, v) => (v === null ? "" : String(Number(v.toPrecision(9)))),
        })),
      ],
      cursor: { drag: { x: false, y: false } },
      hooks: { draw: [(plot) => this.draw_line(plot)] },
    };
    const plot = new uPlot(options, data, place);
    plot.over.addEventListener("click", (event) => this.on_time(plot.posToVal(event.offsetX, "x")));
    return plot;
  }

  draw_line(plot) {
    if (!(this.time > 0 || (this.time === 0 && !this.log_time))) return;
    const { ctx, bbox } = plot, x = Math.round(plot.valToPos(this.time, "x", true)) + 0.5;
    if (!(x >= bbox.left - 1 && x <= bbox.left + bbox.width + 1)) return;
    ctx.save();
    ctx.strokeStyle = colour_of_page("--ink");
    ctx.lineWidth = 1.5 * window.devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  show_time(time) {
    this.time = time;
    this.element.dataset.time = time;
    this.plots?.forEach((plot) => plot.redraw(false));
  }
  resize() {
    if (!this.plots) return this.draw();
    this.plots.forEach((plot, k) => plot.setSize({ width: Math.max(this.places[k].place.clientWidth, 200), height }));
  }
}

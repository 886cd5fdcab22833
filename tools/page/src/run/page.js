// The live page of an evolution.
import { colour_bytes, colour_map_choices } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { Units } from "../data.js";
import { choice, element } from "../dom.js";
import { SurfaceView } from "../surface/view.js";
import { Charts } from "./charts.js";
import { Film } from "./film.js";
import { ProfileFilm } from "./profile_film.js";

const fields = [
  ["order", "order β", 0],
  ["H", "mean curvature H", 0.01],
  ["speed", "speed |V|", 0.002],
]; // and the part of the nodes whose values may lie beyond the colours
const frame_milliseconds = 80;
const told = ["energy", "order_min", "order_mean", "order_max", "H_abs_max", "speed_max", "reduced_volume"];
const least_width = 1e-6; // of the largest value: less is quantisation

const megabytes = (bytes) => `${(1e-6 * bytes).toFixed(1)} MB`;

export class RunPage {
  constructor(parts, size) {
    this.film = parts.has("meshes.csv") ? new Film(parts) : new ProfileFilm(parts);
    if (!this.film.frames.length) throw new Error("none of its states is in the folder");
    this.series = parts.table("series.csv");
    this.units = new Units(parts);
    this.view = new SurfaceView("the surface");
    this.charts = new Charts(this.series, parts.table("charts.csv"), this.units.titled("time", "t"), (time) => this.show(this.nearest(time)));
    this.choices = { field: "order", colours: "viridis", range: "all" };
    this.slider = element("input", {
      type: "range",
      min: "0",
      max: String(this.film.frames.length - 1),
      value: "0",
      "aria-label": "time",
      oninput: () => this.show(Number(this.slider.value)),
    });
    this.play_button = element("button", { type: "button", onclick: () => this.play() }, "Play");
    this.time = element("output", { class: "time" });
    this.bar = element("div");
    this.numbers = element("table", { class: "numbers" });
    this.element = element(
      "div",
      { class: "explore-run" },
      this.controls(),
      element("div", { class: "two" }, element("div", {}, this.view.element, this.bar), element("div", {}, this.numbers)),
      element("div", { class: "slide" }, this.play_button, this.slider, this.time),
      element("p", { class: "note" }, this.about(size)),
      this.charts.element,
    );
    if (is_uniform(this.film.whole_range("order", 0))) this.choose("field", "H");
    this.show(this.film.frames.length - 1);
  }

  about(size) {
    const { frames, states, about } = this.film;
    const shown = frames.length === states ? states : `${frames.length} of ${states}`;
    return `${shown} ${about}; their data take ${megabytes(size)} of this page.`;
  }

  controls() {
    const select = (key, label, options) => {
      const made = choice(label, options, this.choices[key], (value) => this.choose(key, value));
      made.querySelector("select").name = key;
      return made;
    };
    this.form = element(
      "div",
      { class: "controls" },
      select("field", "colour by", fields.filter(([name]) => this.film.has(name)).map(([name, title]) => [name, title])),
      select("range", "from", [["all", "all frames"], ["one", "this frame"]]),
      select("colours", "colours", colour_map_choices),
    );
    return this.form;
  }
  choose(key, value) {
    this.choices[key] = value;
    this.form.querySelector(`[name=${key}]`).value = value;
    if (this.index !== undefined) this.show(this.index);
  }

  nearest(time) {
    const distance = (frame) => Math.abs(Number(frame.time) - time);
    return this.film.frames.reduce((best, frame, k, all) => (distance(frame) < distance(all[best]) ? k : best), 0);
  }

  show(index) {
    this.index = index;
    const frame = this.film.frames[index], { field, colours, range } = this.choices;
    const [name, title, clipped] = fields.find(([key]) => key === field);
    const ends = range === "all" ? this.film.whole_range(name, clipped) : this.film.range([frame], name, clipped);
    const bytes = colour_bytes(colours, is_uniform(ends) ? [ends[0], ends[0]] : ends, this.film.values(frame, name));
    this.view.show(this.film.surface(frame), bytes);
    const shown = this.units.shown(name, is_uniform(ends) ? [ends[0], ends[0]] : ends);
    this.bar.replaceChildren(colour_bar(this.units.titled(name, title), colours, shown, clipped > 0));
    this.slider.value = String(index);
    this.time.textContent = `t = ${this.units.after("time", frame.time)}`;
    this.slider.setAttribute("aria-valuetext", this.time.textContent);
    this.charts.show_time(Number(frame.time));
    this.show_numbers(frame);
  }

  // Of the row of series.csv at the time of the frame, or the last before it.
  show_numbers(frame) {
    const row = this.series.findLast((one) => Number(one.time) <= Number(frame.time)) ?? this.series[0];
    const line = (name) => element("tr", { "data-column": name }, element("th", { scope: "row" }, this.units.titled(name)), element("td", {}, row[name]));
    this.numbers.replaceChildren(element("tbody", {}, ...["time", ...told].filter((name) => row[name] !== undefined).map(line)));
  }

  play() {
    const stop = () => {
      clearInterval(this.playing);
      this.playing = null;
      this.play_button.textContent = "Play";
    };
    if (this.playing) return stop();
    const last = this.film.frames.length - 1;
    if (this.index === last) this.show(0);
    this.play_button.textContent = "Stop";
    this.playing = setInterval(() => {
      if (this.index < last) this.show(this.index + 1);
      if (this.index === last) stop();
    }, frame_milliseconds);
  }
}

function is_uniform([low, high]) {
  return high - low <= least_width * Math.max(Math.abs(low), Math.abs(high));
}

// The live page of an evolution.
import { Units } from "../data.js";
import { element } from "../dom.js";
import { number_lines } from "../numbers.js";
import { FilmView } from "../surface/film_view.js";
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

const megabytes = (bytes) => `${(1e-6 * bytes).toFixed(1)} MB`;

export class RunPage {
  constructor(parts, size) {
    this.film = parts.has("meshes.csv") ? new Film(parts) : new ProfileFilm(parts);
    if (!this.film.frames.length) throw new Error("none of its states is in the folder");
    this.series = parts.table("series.csv");
    this.units = new Units(parts);
    this.states = Number(parts.get("states"));
    this.view = new FilmView(this.film, {
      label: "the surface",
      fields: fields.filter(([name]) => this.film.has(name)),
      all: "all frames",
      one: "this frame",
      units: this.units,
      on_choice: () => this.show(this.index),
    });
    this.charts = new Charts(this.series, parts.table("charts.csv"), this.units.titled("time", "t"), (time) => this.show(this.nearest(time)));
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
    this.numbers = element("table", { class: "numbers" });
    this.element = element(
      "div",
      { class: "explore-run" },
      this.view.controls,
      element("div", { class: "two" }, this.view.element, element("div", {}, this.numbers)),
      element("div", { class: "slide" }, this.play_button, this.slider, this.time),
      element("p", { class: "note" }, this.about(size)),
      this.charts.element,
    );
    this.show(this.film.frames.length - 1);
  }

  about(size) {
    const { frames, about } = this.film;
    const shown = frames.length === this.states ? this.states : `${frames.length} of ${this.states}`;
    return `${shown} ${about}; their data take ${megabytes(size)} of this page.`;
  }

  nearest(time) {
    const distance = (frame) => Math.abs(Number(frame.time) - time);
    return this.film.frames.reduce((best, frame, k, all) => (distance(frame) < distance(all[best]) ? k : best), 0);
  }

  show(index) {
    this.index = index;
    const frame = this.film.frames[index];
    this.view.show(frame);
    this.slider.value = String(index);
    this.time.textContent = `t = ${this.units.after("time", frame.time)}`;
    this.slider.setAttribute("aria-valuetext", this.time.textContent);
    this.charts.show_time(Number(frame.time));
    this.show_numbers(frame);
  }

  // Of the row of series.csv at the time of the frame, or the last before it.
  show_numbers(frame) {
    const row = this.series.findLast((one) => Number(one.time) <= Number(frame.time)) ?? this.series[0];
    const columns = ["time", ...told].filter((name) => row[name] !== undefined);
    this.numbers.replaceChildren(element("tbody", {}, ...number_lines(columns, this.units, row)));
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

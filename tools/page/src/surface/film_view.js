// A frame of a film as a surface, in the colours of a field that can be chosen.
import { colour_bytes, colour_map_choices } from "../colours.js";
import { colour_bar } from "../colour_bar.js";
import { choice, element } from "../dom.js";
import { SurfaceView } from "./view.js";

const least_width = 1e-6; // of the largest value: less is quantisation

export function is_uniform([low, high]) {
  return high - low <= least_width * Math.max(Math.abs(low), Math.abs(high));
}

// `element`, and `controls` to be placed elsewhere.
export class FilmView {
  // fields: of each its name, title, and the part of the nodes whose values may lie beyond the colours; all: "all frames";
  // on_choice(): to be shown again.
  constructor(film, { label, fields, all, one, units, on_choice }) {
    Object.assign(this, { film, fields, units, on_choice });
    this.view = new SurfaceView(label);
    this.bar = element("div");
    this.element = element("div", {}, this.view.element, this.bar);
    const uniform = film.frames.length > 0 && is_uniform(film.whole_range("order", 0));
    this.choices = { field: uniform ? "H" : "order", colours: "viridis", range: "all" };
    const select = (key, title, options) => {
      const made = choice(title, options, this.choices[key], (value) => this.choose(key, value));
      made.querySelector("select").name = key;
      return made;
    };
    this.controls = element(
      "div",
      { class: "controls" },
      select("field", "colour by", fields.map(([name, title]) => [name, title])),
      select("range", "from", [["all", all], ["one", one]]),
      select("colours", "colours", colour_map_choices),
    );
  }
  select(key) {
    return this.controls.querySelector(`[name=${key}]`);
  }
  choose(key, value) {
    this.choices[key] = value;
    this.select(key).value = value;
    this.on_choice();
  }

  // The frame, or what has become of it: `changed` has its surface and reach, and by their names values and ends of fields.
  show(frame, changed = null) {
    const { film, units } = this, { field: name, colours, range } = this.choices;
    const [, title, clipped] = this.fields.find(([key]) => key === name);
    const values = changed?.fields[name]?.values ?? film.values(frame, name);
    const found = changed?.fields[name]?.ends ?? (range === "all" ? film.whole_range(name, clipped) : film.range([frame], name, clipped));
    const ends = is_uniform(found) ? [found[0], found[0]] : found;
    this.view.show(changed?.surface ?? film.surface(frame), colour_bytes(colours, ends, values), changed?.reach);
    this.bar.replaceChildren(colour_bar(units.titled(name, title), colours, units.shown(name, ends), clipped > 0));
  }
}

// What the colours mean: a bar with its numbers, or a list of classes.
import { format, scaleLinear } from "d3";
import { colour_scale } from "./colours.js";
import { element } from "./dom.js";

// `clipped`: there are values beyond the ends, which have the colours of the ends.
export function colour_bar(title, map, [low, high], clipped = false) {
  const scale = colour_scale(map, [0, 1]);
  const stops = Array.from({ length: 13 }, (_, k) => scale(k / 12)).join(", ");
  const bar = element("div", { class: "bar", style: `background: linear-gradient(to right, ${stops})` });
  const numbers = element("div", { class: "ticks" });
  const axis = scaleLinear([low, high], [0, 100]);
  const ticks = low === high ? [low] : axis.ticks(4);
  const text = low === high ? format(".4g") : axis.tickFormat(4);
  for (const tick of ticks) {
    const at = low === high ? 50 : axis(tick);
    if (at < 6 || at > 94) continue; // or half of the number would be outside
    numbers.append(element("span", { style: `left: ${at}%` }, text(tick)));
  }
  return element("div", { class: "colours" }, element("div", {}, title + (clipped ? " (the ends: that and beyond)" : "")), bar, numbers);
}

// `entries`: pairs of a colour and a text.
export function colour_list(title, entries) {
  return element(
    "div",
    { class: "colours" },
    element("div", {}, title),
    element(
      "div",
      { class: "classes" },
      ...entries.map(([colour, text]) => element("span", {}, element("i", { style: `background: ${colour}` }), text)),
    ),
  );
}

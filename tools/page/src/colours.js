// Colours that people who see fewer of them can tell apart, too.
import { interpolateCividis, interpolateGreys, interpolateViridis, rgb, scaleLinear } from "d3";

export const colour_maps = {
  viridis: interpolateViridis,
  cividis: interpolateCividis,
  grey: (part) => interpolateGreys(0.92 - 0.84 * part),
};
export const colour_map_choices = Object.keys(colour_maps).map((name) => [name, name]);

// Okabe and Ito's, the light ones last.
export const class_colours = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442", "#999999"];

export const not_known = "#a9aeb3";

// From numbers to colours: `domain` low and high, beyond them the colours of the ends.
export function colour_scale(map, [low, high]) {
  const part = scaleLinear([low, high], [0, 1]).clamp(true);
  const colours = colour_maps[map];
  return (value) => (Number.isFinite(value) ? colours(low === high ? 0.5 : part(value)) : not_known);
}

// The same for many numbers at once, as bytes.
export function colour_bytes(map, [low, high], values) {
  const steps = 256;
  const table = Array.from({ length: steps }, (_, k) => rgb(colour_maps[map](k / (steps - 1))));
  const grey = rgb(not_known);
  const bytes = new Uint8Array(3 * values.length);
  const factor = high > low ? (steps - 1) / (high - low) : 0;
  for (let i = 0; i < values.length; ++i) {
    const k = factor ? Math.round(factor * (values[i] - low)) : steps / 2;
    const { r, g, b } = Number.isFinite(values[i]) ? table[Math.min(Math.max(k, 0), steps - 1)] : grey;
    bytes[3 * i] = r;
    bytes[3 * i + 1] = g;
    bytes[3 * i + 2] = b;
  }
  return bytes;
}

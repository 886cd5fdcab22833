// The profiles of an axisymmetric evolution as surfaces: what film.js is for a 3D run.
import { PackedFields } from "../packed_fields.js";
import { revolved } from "../surface/revolved.js";

export class ProfileFilm {
  constructor(parts) {
    const profiles = new PackedFields(parts, "profiles");
    this.frames = parts.table("shown.csv").map(({ time, file }, k) => ({ time, file, profile: profiles.get(k) }));
    this.about = "profiles, turned about their axis";
  }
  has(name) {
    return name in this.frames[0].profile;
  }
  values(frame, name) {
    return this.surface(frame).at((node) => frame.profile[name][node]);
  }
  surface(frame) {
    return revolved(frame.profile);
  }
  whole_range(name, clipped) {
    return this.range(this.frames, name, clipped);
  }
  // The range of a field over some frames but for `clipped`, the part of the nodes that has more or less.
  range(frames, name, clipped) {
    const values = Float32Array.from(frames.flatMap((frame) => [...frame.profile[name]].filter(Number.isFinite))).sort();
    const cut = Math.floor(clipped * values.length);
    return values.length ? [values[cut], values[values.length - 1 - cut]] : [0, 0];
  }
}

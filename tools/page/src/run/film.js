// Curved surfaces with their fields, as studies/report/packed_film.h has them: the frames of a 3D run, states at rest.
import { dequantised, summed } from "../data.js";

const unknown = 65535;

export class Film {
  constructor(parts) {
    this.fields = parts.table("fields.csv").map(({ name, low, high }) => ({ name, low: Number(low), high: Number(high) }));
    this.meshes = parts.table("meshes.csv").map(({ triangles, nodes }, k) => ({
      curved: Number(triangles),
      nodes: Number(nodes),
      triangles: parts.get(`mesh/${k}`),
      numbers: summed(parts.get(`frames/${k}`), this.fields.length * Number(nodes)),
    }));
    const seen = this.meshes.map(() => 0);
    this.frames = parts.table("shown.csv").map(({ mesh, ...frame }) => {
      const of = this.meshes[Number(mesh)];
      const size = this.fields.length * of.nodes, from = size * seen[Number(mesh)]++;
      return { ...frame, mesh: of, numbers: of.numbers.subarray(from, from + size) };
    });
    this.ranges = new Map();
    const triangles = [...new Set(this.meshes.map((mesh) => mesh.curved))].join(", ");
    this.about = `frames of ${triangles} curved triangles, each drawn as nine plain ones`;
    this.centre = ["x", "y", "z"].map((name) => {
      const { low, high } = this.field(name);
      return 0.5 * (low + high);
    });
  }

  has(name) {
    return this.field(name) !== undefined;
  }
  field(name) {
    return this.fields.find((field) => field.name === name);
  }
  raw(frame, name) {
    const k = this.fields.indexOf(this.field(name)), { nodes } = frame.mesh;
    return frame.numbers.subarray(k * nodes, (k + 1) * nodes);
  }
  values(frame, name) {
    const { low, high } = this.field(name);
    return dequantised(this.raw(frame, name), low, high);
  }
  surface(frame) {
    const { nodes, triangles } = frame.mesh;
    const positions = new Float32Array(3 * nodes);
    ["x", "y", "z"].forEach((name, k) => {
      const values = this.values(frame, name);
      for (let i = 0; i < nodes; ++i) positions[3 * i + k] = values[i] - this.centre[k];
    });
    return { positions, triangles };
  }

  // The range of a field over all frames but for `clipped`, the part of the nodes that has more or less.
  whole_range(name, clipped) {
    const key = `${name} ${clipped}`;
    if (!this.ranges.has(key)) this.ranges.set(key, this.range(this.frames, name, clipped));
    return this.ranges.get(key);
  }
  // The same over some frames.
  range(frames, name, clipped) {
    const counts = new Uint32Array(unknown);
    let all = 0;
    for (const frame of frames)
      for (const number of this.raw(frame, name))
        if (number !== unknown) {
          ++counts[number];
          ++all;
        }
    const { low, high } = this.field(name), step = (high - low) / (unknown - 1);
    const after = (most, k, by) => {
      for (let sum = counts[k]; sum <= most && counts[k + by] !== undefined; sum += counts[k]) k += by;
      return k;
    };
    const ends = [after(clipped * all, 0, 1), after(clipped * all, unknown - 1, -1)];
    return all ? ends.map((k) => low + step * k) : [0, 0];
  }
}

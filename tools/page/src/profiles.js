// Profiles by what they belong to, as studies/report/packed_profiles.h has them: r, z, order, H at the nodes.
import { dequantised, summed } from "./data.js";

const fields = ["r", "z", "order", "H"];

export class Profiles {
  constructor(parts) {
    const numbers = summed(parts.get("profiles"), 1);
    this.packed = new Map();
    let from = 0;
    for (const line of parts.table("profiles.csv")) {
      const size = fields.length * Number(line.nodes);
      this.packed.set(Number(line.index), { line, numbers: numbers.subarray(from, from + size) });
      from += size;
    }
  }

  // Unpacked when it is asked for, since there may be thousands; null where there is none.
  get(index) {
    const packed = this.packed.get(index);
    if (!packed) return null;
    const { line, numbers } = packed, nodes = Number(line.nodes);
    const values = (field, k) =>
      dequantised(numbers.subarray(k * nodes, (k + 1) * nodes), Number(line[`${field}_low`]), Number(line[`${field}_high`]));
    return Object.fromEntries(fields.map((field, k) => [field, values(field, k)]));
  }
}

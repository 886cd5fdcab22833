// Fields at the nodes of curves and surfaces by what they belong to, as studies/report/packed_fields.h has them.
import { dequantised, summed } from "./data.js";

export class PackedFields {
  constructor(parts, name) {
    this.packed = new Map();
    if (!parts.has(name)) return;
    const numbers = summed(parts.get(name), 1), table = parts.table(`${name}.csv`);
    this.fields = table.columns.filter((column) => column.endsWith("_low")).map((column) => column.slice(0, -4));
    let from = 0;
    for (const line of table) {
      const size = this.fields.length * Number(line.nodes);
      this.packed.set(line.key, { line, numbers: numbers.subarray(from, from + size) });
      from += size;
    }
  }

  has(key) {
    return this.packed.has(String(key));
  }
  // Unpacked when it is asked for, since there may be thousands; null where there is none.
  get(key) {
    const packed = this.packed.get(String(key));
    if (!packed) return null;
    const { line, numbers } = packed, nodes = Number(line.nodes);
    const values = (field, k) =>
      dequantised(numbers.subarray(k * nodes, (k + 1) * nodes), Number(line[`${field}_low`]), Number(line[`${field}_high`]));
    return Object.fromEntries(this.fields.map((field, k) => [field, values(field, k)]));
  }
}

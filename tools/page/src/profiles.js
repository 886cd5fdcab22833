// Profiles by what they belong to, as studies/report/packed_profiles.h has them: r, z, order, H at the nodes.
import { dequantised, summed } from "./data.js";

export function read_profiles(parts) {
  const numbers = summed(parts.get("profiles"), 1);
  const profiles = new Map();
  let from = 0;
  for (const line of parts.table("profiles.csv")) {
    const nodes = Number(line.nodes), profile = {};
    for (const field of ["r", "z", "order", "H"]) {
      profile[field] = dequantised(numbers.subarray(from, from + nodes), Number(line[`${field}_low`]), Number(line[`${field}_high`]));
      from += nodes;
    }
    profiles.set(Number(line.index), profile);
  }
  return profiles;
}

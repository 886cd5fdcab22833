// A mode u(s) cos mφ of an axisymmetric state: the surface, displaced by it, and its fields.
import { revolved } from "../surface/revolved.js";
import { displacements, orders } from "./amplitude.js";

// From r, z, order, u and b at the nodes: with the outward normals (−t_z, t_r).
export function with_normals(mode) {
  const { r, z } = mode, last = r.length - 1;
  const normals = Array.from(r, (_, i) => {
    if (i === 0 || i === last) return [0, i === 0 ? 1 : -1];
    const t = [r[i + 1] - r[i - 1], z[i + 1] - z[i - 1]], size = Math.hypot(...t);
    return [-t[1] / size, t[0] / size];
  });
  return { ...mode, normals };
}

// The displacement of node i at the angle φ by (r, z).
export const displacement_by = ({ u, normals }, m, amplitude) => (i, phi) =>
  normals[i].map((n) => amplitude * u[i] * Math.cos(m * phi) * n);

export const displaced = (mode, m, amplitude, options = {}) =>
  revolved(mode, { ...options, displaced: displacement_by(mode, m, amplitude) });

// How far from the middle of its axis it may reach.
export const reach_of = ({ r, z, u }) => Math.max(...Array.from(r, (x, i) => Math.hypot(x, z[i] - 0.5 * (z[0] + z.at(-1))))) + displacements(u)[1];

// Title, value at node i and the angle φ, and range of the fields of a displaced state.
export const fields_of = ({ order, u, b }, m, amplitude) => ({
  u: {
    title: "displacement along the normal",
    value: (i, phi) => amplitude * u[i] * Math.cos(m * phi),
    range: displacements(u),
  },
  order: {
    title: "order β",
    value: (i, phi) => order[i] + amplitude * b[i] * Math.cos(m * phi),
    range: orders(order, b),
  },
});

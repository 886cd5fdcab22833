// A profile turned about its axis, as triangles.
const segments = 72;
const first_angle = -0.25;

const still = () => [0, 0];

// `open` leaves a quarter out, to look inside; `displaced` moves node i at the angle φ by (r, z). `at` of the result gives
// the corners their numbers, value(i, φ).
export function revolved({ r, z }, { open = false, displaced = still } = {}) {
  const nodes = r.length, middle = 0.5 * (z[0] + z[nodes - 1]);
  const columns = open ? segments + 1 : segments; // closed, the last piece ends where the first begins
  const angle = (k) => first_angle + ((open ? 1.5 : 2) * Math.PI * k) / segments;
  const at = (value) => Float32Array.from({ length: nodes * columns }, (_, c) => value(Math.floor(c / columns), angle(c % columns)));
  const positions = new Float32Array(3 * nodes * columns);
  for (let i = 0, to = 0; i < nodes; ++i)
    for (let k = 0; k < columns; ++k, to += 3) {
      const phi = angle(k), [dr, dz] = displaced(i, phi), radius = r[i] + dr;
      positions.set([radius * Math.cos(phi), radius * Math.sin(phi), z[i] + dz - middle], to);
    }
  const triangles = new Uint32Array(6 * (nodes - 1) * segments);
  for (let i = 0, to = 0; i + 1 < nodes; ++i)
    for (let k = 0; k < segments; ++k, to += 6) {
      const a = i * columns + k, b = i * columns + ((k + 1) % columns);
      triangles.set([a, a + columns, b, b, a + columns, b + columns], to);
    }
  return { positions, triangles, at };
}

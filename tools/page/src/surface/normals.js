// Outward normals at the nodes of plain triangles: those of the triangles, by their areas.
export function normals_of({ positions, triangles }) {
  const normals = new Float32Array(positions.length);
  const side = (from, to) => [0, 1, 2].map((k) => positions[3 * to + k] - positions[3 * from + k]);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = triangles.subarray(t, t + 3);
    const u = side(a, b), v = side(a, c);
    for (let k = 0; k < 3; ++k) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3], component = u[i] * v[j] - u[j] * v[i];
      for (const node of [a, b, c]) normals[3 * node + k] += component;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const size = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k] /= size;
  }
  return normals;
}

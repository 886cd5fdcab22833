// Draws a surface without WebGL: its triangles from the back to the front.
import { Matrix4 } from "three";

const ambient = 0.45;

export function canvas_painter(canvas) {
  const context = canvas.getContext("2d");
  let width = 0, height = 0, surface = null, colours = null;

  // Of each corner the place on the canvas, and the distance from the camera.
  function projected(camera) {
    const { positions } = surface;
    const m = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    const places = new Float32Array(positions.length);
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y, z] = [positions[i], positions[i + 1], positions[i + 2]];
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      places[i] = width * (0.5 + (0.5 * (m[0] * x + m[4] * y + m[8] * z + m[12])) / w);
      places[i + 1] = height * (0.5 - (0.5 * (m[1] * x + m[5] * y + m[9] * z + m[13])) / w);
      places[i + 2] = w;
    }
    return places;
  }

  // The cosine between the normal of a triangle and the view, which is where the light comes from.
  function brightness(a, b, c, eye) {
    const p = surface.positions;
    const u = [0, 1, 2].map((k) => p[b + k] - p[a + k]), v = [0, 1, 2].map((k) => p[c + k] - p[a + k]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const to = [eye.x - p[a], eye.y - p[a + 1], eye.z - p[a + 2]];
    const size = Math.hypot(...n) * Math.hypot(...to);
    return size > 0 ? Math.abs(n[0] * to[0] + n[1] * to[1] + n[2] * to[2]) / size : 0;
  }

  return {
    name: "canvas",
    resize(w, h) {
      const ratio = Math.min(window.devicePixelRatio, 2);
      [width, height] = [w, h];
      [canvas.width, canvas.height] = [Math.round(ratio * w), Math.round(ratio * h)];
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
    },
    set_surface(shown) {
      surface = shown;
    },
    set_colours(bytes) {
      colours = bytes;
    },
    paint(camera) {
      context.clearRect(0, 0, width, height);
      camera.updateMatrixWorld();
      const places = projected(camera);
      const { triangles } = surface;
      const depth = (t) => places[3 * triangles[t] + 2] + places[3 * triangles[t + 1] + 2] + places[3 * triangles[t + 2] + 2];
      const order = Array.from({ length: triangles.length / 3 }, (_, k) => [depth(3 * k), 3 * k]);
      order.sort((one, other) => other[0] - one[0]);
      for (const [, t] of order) {
        const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
        const light = ambient + (1 - ambient) * brightness(a, b, c, camera.position);
        const shade = (k) => Math.round((light * (colours[a + k] + colours[b + k] + colours[c + k])) / 3);
        context.fillStyle = context.strokeStyle = `rgb(${shade(0)},${shade(1)},${shade(2)})`;
        context.beginPath();
        context.moveTo(places[a], places[a + 1]);
        context.lineTo(places[b], places[b + 1]);
        context.lineTo(places[c], places[c + 1]);
        context.closePath();
        context.fill();
        context.stroke(); // or the seams would shine through
      }
    },
  };
}

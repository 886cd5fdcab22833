// A surface to turn and zoom, by mouse, finger and keys. Its axis z points up.
import { PerspectiveCamera } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element } from "../dom.js";
import { canvas_painter } from "./canvas.js";
import { webgl_painter } from "./webgl.js";

const field_of_view = 30; // degrees
const start = { azimuth: -1.05, elevation: 0.42 };
const turn = 0.12; // radians for a key
const least_radius = 1.25; // so that shapes of equal area are seen in their proportions

export class SurfaceView {
  constructor(label) {
    this.canvas = element("canvas", {
      tabindex: "0",
      role: "img",
      "aria-label": `${label}: arrow keys turn it, + and − zoom, Home turns it back`,
      onkeydown: (event) => this.on_key(event),
    });
    this.element = element("div", { class: "surface" }, this.canvas);
    this.camera = new PerspectiveCamera(field_of_view, 1, 0.01, 1000);
    this.camera.up.set(0, 0, 1);
    this.painter = webgl_painter(this.canvas) ?? canvas_painter(this.canvas);
    this.element.dataset.painter = this.painter.name;
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enablePan = false;
    this.controls.enableZoom = false; // a page scrolls, unless the surface was chosen
    this.canvas.addEventListener("focus", () => (this.controls.enableZoom = true));
    this.canvas.addEventListener("blur", () => (this.controls.enableZoom = false));
    this.canvas.style.touchAction = "pan-y";
    this.controls.addEventListener("change", () => this.paint_soon());
    this.radius = 0;
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  // `colours`: three bytes for each corner; `reach`: of what moves, so that it is seen from one distance.
  show(surface, colours, reach = null) {
    this.painter.set_surface(surface);
    this.painter.set_colours(colours);
    this.has_surface = true;
    const radius = Math.max(least_radius, reach ?? radius_of(surface.positions));
    if (Math.abs(radius - this.radius) > 0.02 * this.radius) this.look_from(this.angles() ?? start, radius);
    this.paint_soon();
  }

  angles() {
    if (!this.radius) return null;
    const { x, y, z } = this.camera.position;
    return { azimuth: Math.atan2(y, x), elevation: Math.asin(z / Math.hypot(x, y, z)) };
  }
  look_from({ azimuth, elevation }, radius = this.radius, distance) {
    this.radius = radius;
    const up = Math.min(Math.max(elevation, -1.55), 1.55);
    const far = distance ?? (1.06 * radius) / Math.sin((0.5 * field_of_view * Math.PI) / 180);
    this.camera.position.set(Math.cos(up) * Math.cos(azimuth), Math.cos(up) * Math.sin(azimuth), Math.sin(up));
    this.camera.position.multiplyScalar(far);
    this.controls.update();
    this.paint_soon();
  }

  on_key(event) {
    const { azimuth, elevation } = this.angles() ?? start;
    const distance = this.camera.position.length();
    const turned = {
      ArrowLeft: [azimuth - turn, elevation, distance],
      ArrowRight: [azimuth + turn, elevation, distance],
      ArrowUp: [azimuth, elevation + turn, distance],
      ArrowDown: [azimuth, elevation - turn, distance],
      "+": [azimuth, elevation, distance / 1.1],
      "-": [azimuth, elevation, distance * 1.1],
      Home: [start.azimuth, start.elevation, undefined],
    }[event.key];
    if (!turned) return;
    event.preventDefault();
    this.look_from({ azimuth: turned[0], elevation: turned[1] }, this.radius, turned[2]);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.painter.resize(width, height);
    this.paint_soon();
  }

  paint_soon() {
    if (this.waiting || !this.has_surface) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.painter.paint(this.camera);
    });
  }
}

export function radius_of(positions) {
  let largest = 0;
  for (let i = 0; i < positions.length; i += 3)
    largest = Math.max(largest, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  return largest;
}

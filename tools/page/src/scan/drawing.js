// A drawing of the points of a scan that listens to the pointer and to keys.
import { svg } from "../dom.js";

const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

// on: { hover(point or null, event), choose(point), step(direction), enter() }; point_at(x, y): the point there, or null.
export function drawing_for(on, point_at) {
  const drawing = svg("svg", {
    tabindex: "0",
    role: "application",
    "aria-roledescription": "diagram",
    onkeydown: (event) => {
      if (event.key in directions) on.step(directions[event.key]);
      else if (event.key === "Enter") on.enter();
      else return;
      event.preventDefault();
    },
    onpointermove: (event) => on.hover(at(event), event),
    onpointerleave: (event) => on.hover(null, event),
    onclick: (event) => {
      const point = at(event);
      if (point) on.choose(point);
    },
  });
  const at = (event) => {
    const box = drawing.getBoundingClientRect();
    return point_at(event.clientX - box.left, event.clientY - box.top);
  };
  return drawing;
}

const reach = 40; // pixels from a point within which it is meant

// The point that is drawn next to (x, y), if it is near; place(point): where it is.
export function nearest_point(points, place, x, y) {
  const distance = (point) => Math.hypot(place(point)[0] - x, place(point)[1] - y);
  const found = points.reduce((a, b) => (distance(b) < distance(a) ? b : a));
  return distance(found) < reach ? found : null;
}

export const ring_at = ([cx, cy]) => ["outer", "inner"].map((name) => svg("circle", { class: name, cx, cy, r: 8 }));

export const label_of = (title) => `${title}: arrow keys go from point to point, Enter goes to the shape`;

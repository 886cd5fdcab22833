// How far a mode displaces its state: a slider, and a swing.
import { element } from "../dom.js";

const largest = 0.3, usual = 0.15;
const steps = 60; // of a swing
const frame_milliseconds = 40;

export class Amplitude {
  constructor(on_change) {
    this.on_change = on_change;
    this.slider = element("input", {
      type: "range",
      min: String(-largest),
      max: String(largest),
      step: "0.01",
      value: String(usual),
      "aria-label": "amplitude",
      oninput: () => this.tell(),
    });
    this.button = element("button", { type: "button", onclick: () => (this.swinging ? this.stop() : this.swing()) }, "Swing");
    this.said = element("output", { class: "time" });
    this.element = element("div", { class: "slide" }, this.button, this.slider, this.said);
  }

  tell(amplitude = Number(this.slider.value)) {
    this.said.textContent = `amplitude ${amplitude.toFixed(2)}`;
    this.on_change(amplitude);
  }
  swing() {
    this.button.textContent = "Stop";
    let k = 0;
    this.swinging = setInterval(() => this.tell(Number(this.slider.value) * Math.cos((2 * Math.PI * ++k) / steps)), frame_milliseconds);
  }
  stop() {
    clearInterval(this.swinging);
    this.swinging = null;
    this.button.textContent = "Swing";
    this.tell();
  }
}

// What the displacement u has with amplitudes up to the largest, and the order.
export function displacements(u) {
  const most = largest * u.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
  return [-most, most];
}
export function orders(order, b) {
  const reach = Array.from(order, (value, i) => [value, largest * Math.abs(b[i])]);
  return [Math.min(...reach.map(([value, change]) => value - change)), Math.max(...reach.map(([value, change]) => value + change))];
}

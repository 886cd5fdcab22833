// What is told beside the pointer.
import { element } from "./dom.js";

const beyond = 16; // pixels between the pointer and the text

export class Tip {
  constructor(host) {
    this.host = host;
    this.element = element("div", { class: "tip", hidden: true });
    host.append(this.element);
  }
  show(event, lines) {
    this.element.hidden = false;
    this.element.replaceChildren(...lines.map((line) => element("div", {}, line)));
    const box = this.host.getBoundingClientRect(), width = this.element.offsetWidth;
    const x = event.clientX - box.left, y = event.clientY - box.top;
    const left = x + beyond + width > box.width ? x - beyond - width : x + beyond;
    this.element.style.left = `${Math.max(0, Math.min(left, box.width - width))}px`;
    this.element.style.top = `${y + beyond}px`;
  }
  hide() {
    this.element.hidden = true;
  }
}

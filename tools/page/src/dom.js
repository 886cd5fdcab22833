// Elements of the page, by name, properties and children.

const svg_space = "http://www.w3.org/2000/svg";

function fill(node, properties, children) {
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

export const element = (name, properties = {}, ...children) =>
  fill(document.createElement(name), properties, children);

export const svg = (name, properties = {}, ...children) =>
  fill(document.createElementNS(svg_space, name), properties, children);

// A <select> in its label; `options` are pairs of value and text. It hides where there is nothing to choose.
export function choice(label, options, chosen, on_change) {
  const select = element(
    "select",
    { onchange: () => on_change(select.value) },
    ...options.map(([value, text]) => element("option", { value, selected: value === chosen }, text)),
  );
  return element("label", { class: "choice", hidden: options.length < 2 }, label, select);
}

export const colour_of_page = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

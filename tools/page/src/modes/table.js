// A table of modes with one of them to be chosen.
import { element } from "../dom.js";

const no_shape = "No shape: its file was not in modes/ when the report was made.";

// `modes`: { name, label, row, has_shape }; one without a row is the state at rest. `radio` is put into each.
export function modes_table(modes, columns, units, on_choose) {
  const cells = ({ row }) => (row ? columns.map((column) => element("td", {}, row[column])) : [element("td", { colspan: columns.length }, "at rest")]);
  const line = (mode) => {
    const choose = () => mode.has_shape && on_choose(mode);
    mode.radio = element("input", { type: "radio", name: "mode", disabled: !mode.has_shape, "aria-label": mode.label, onchange: choose });
    const unstable = Number(mode.row?.eigenvalue) < 0, title = mode.has_shape ? undefined : no_shape;
    return element("tr", { "data-mode": mode.name, class: unstable ? "unstable" : "", title, onclick: choose }, element("td", {}, mode.radio), ...cells(mode));
  };
  return element(
    "table",
    {},
    element("thead", {}, element("tr", {}, element("th"), ...columns.map((column) => element("th", {}, units.titled(column))))),
    element("tbody", {}, ...modes.map(line)),
  );
}

// Of a row of modes.csv.
export const name_of_mode = ({ m, parity, number }) => `m${m}_${parity}_${number}`;
export const label_of_mode = ({ m, parity, number }) => `m = ${m}, ${parity}, ${number}`;

export const at_rest = { name: "rest", label: "at rest", row: null, has_shape: true };

// All numbers of a row, as they stand in its table.
import { element } from "./dom.js";

export const number_lines = (columns, units, row) =>
  columns.map((column) => element("tr", { "data-column": column }, element("th", { scope: "row" }, units.titled(column)), element("td", {}, row[column])));

export function numbers_table(columns, units, row, file) {
  return element(
    "details",
    { open: true },
    element("summary", {}, units.there ? `All numbers of ${file}, in physical units` : `All numbers, as in ${file}`),
    element("table", { class: "numbers" }, element("tbody", {}, ...number_lines(columns, units, row))),
  );
}

#include "studies/rest_states/pass_row.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

namespace {

void add_end(std::size_t k, Columns<PassRow>& columns) {
  const auto add = [&](const char* name, auto make, auto member) {
    columns.push_back(make(
        fmt::format("{}_{}", name, k + 1),
        [ k, member ](auto& row) -> auto& { return row.ends[k].*member; }));
  };
  const auto any = [](std::string name, auto member) {
    return column<PassRow>(std::move(name), member);
  };
  const auto known = [](std::string name, auto member) {
    return known_column<PassRow>(std::move(name), member);
  };
  add("end", any, &PassEnd::state);
  add("class", any, &PassEnd::symmetry);
  add("negative_directions", any, &PassEnd::negative_directions);
  add("energy_end", known, &PassEnd::energy);
  add("barrier", known, &PassEnd::barrier);
  add("time", known, &PassEnd::time);
  add("stop_reason", any, &PassEnd::stop_reason);
}

std::string text_of(const PassEnd& end) {
  if (!end.is_gone()) return "open";
  if (!end.state) return fmt::format("U = {:.7g}, not at rest: {}", end.energy, end.stop_reason);
  const std::string saddle =
      *end.negative_directions == 0 ? "" : fmt::format(", {} negative", *end.negative_directions);
  const std::string doubt = end.stop_reason == at_rest ? "" : ", " + end.stop_reason;
  return fmt::format("state {}, {}{}, {:.4g} below{}", *end.state, end.symmetry, saddle,
                     end.barrier, doubt);
}

}  // namespace

Columns<PassRow> pass_columns(const StatesInput& input) {
  using Row = PassRow;
  Columns<Row> columns{
      column("pass", &Row::key),
      column("reduced_volume", &Row::reduced_volume),
      column("L", &Row::L),
      column("class", &Row::symmetry),
      known_column("energy", &Row::energy),
      column("kind", &Row::kind),
  };
  if (follows_other_number(input))
    columns.insert(columns.begin() + 3, column(input.follow->parameter, &Row::followed));
  for (const std::size_t k : {0u, 1u}) add_end(k, columns);
  columns.push_back(column("remark", &Row::remark));
  return columns;
}

std::string table_of(const StatesInput& input, const std::vector<PassRow>& passes) {
  std::string text;
  for (const PassRow& row : passes) {
    text += fmt::format("pass {}, V_r = {:.6g}, L = {:.6g}", row.key, row.reduced_volume, row.L);
    if (follows_other_number(input))
      text += fmt::format(", {} = {:.6g}", input.follow->parameter, row.followed);
    text += fmt::format(", {}, U = {:.9g}: {}{}\n", row.symmetry, row.energy, name(row.kind),
                        row.remark.empty() ? "" : ", " + row.remark);
    for (const PassEnd& end : row.ends) text += "  " + text_of(end) + "\n";
  }
  return text;
}

}  // namespace sbeh::studies

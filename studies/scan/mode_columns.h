// Stability in 3D as columns of a table.
#pragma once

#include "axisym/modes/stability_3d.h"
#include "studies/io/columns.h"

#include <fmt/format.h>

#include <string>

namespace sbeh::studies {

/// The m of the unstable modes, such as "1 2"; "none" where all are known to be stable; nothing where that is not known.
std::string text_of_modes(const axisym::Stability3d& modes);
/// From such a text, if it is one.
bool read_unstable_modes(const std::string& field, axisym::Stability3d& modes);

/// With the columns of `Row::modes` after the others: number and m of the falling directions, what rigid motions leave,
/// and the eigenvalue and the rate of each m.
template <class Row>
Columns<Row> with_modes(Columns<Row> columns) {
  using axisym::Stability3d;
  columns.push_back(column<Row>("negative_directions_3d",
                                inside(&Row::modes, &Stability3d::negative_directions)));
  columns.push_back(
      {"unstable_modes", [](const Row& row) { return csv_field(text_of_modes(row.modes)); },
       [](Row& row, const std::string& field) { return read_unstable_modes(field, row.modes); }});
  columns.push_back(known_column<Row>("rigid_residual",
                                      inside(&Row::modes, &Stability3d::rigid_residual), "{:.3g}"));
  const auto add = [&](const char* name, auto values) {
    for (std::size_t m = 0; m <= axisym::most_modes; ++m)
      columns.push_back(known_column<Row>(
          fmt::format("{}_m{}", name, m),
          [ m, values ](auto& row) -> auto& { return (row.modes.*values)[m]; }));
  };
  add("eigenvalue", &Stability3d::eigenvalue);
  add("rate", &Stability3d::rate);
  return columns;
}

}  // namespace sbeh::studies

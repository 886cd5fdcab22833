#include "studies/rest_states/rest_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

bool follows_other_number(const StatesInput& input) {
  return input.follow && input.follow->parameter != followed_volume
      && input.follow->parameter != "L";
}

double energy_of(const RestRow& row) {
  return row.measures ? row.measures->diagnostics.energy.total() : not_known;
}

std::filesystem::path frame_of(const std::filesystem::path& folder, int number) {
  return folder / fmt::format("frames/state_{:04}.vtu", number);
}

std::filesystem::path mode_of(const std::filesystem::path& folder, int number, int eigenpair) {
  return folder / fmt::format("modes/state_{:04}_mode_{}.vtu", number, eigenpair);
}

std::filesystem::path growth_mode_of(const std::filesystem::path& folder, int number, int mode) {
  return folder / fmt::format("modes/state_{:04}_rate_{}.vtu", number, mode);
}

Columns<RestRow> rest_columns(const StatesInput& input) {
  using Row = RestRow;
  using Measures = RestMeasures;
  using surface3d::Diagnostics, model::Energy;
  const auto measure = [](std::string name, auto member) {
    return part_column(std::move(name), &Row::measures, member, "");
  };
  const auto diagnostic = [&](const std::string& name, auto... members) {
    return measure(name, inside(&Measures::diagnostics, members...));
  };
  const auto length = [&](std::string name, std::size_t k) {
    return measure(
        std::move(name), [k](auto& of) -> auto& { return of.lengths[k]; });
  };
  Columns<Row> columns{
      column("number", &Row::key),
      column("model", &Row::model),
      column("branch", &Row::start),
      column("reduced_volume", &Row::reduced_volume),
      column("L", &Row::L),
      column("status", &Row::status),
      derived_column<Row>("energy",
                          [](const Row& row) {
                            return row.measures
                                     ? fmt::format("{}", row.measures->diagnostics.energy.total())
                                     : "";
                          }),
      known_column("energy_error", &Row::energy_error, "{:.3g}"),
      diagnostic("energy_distortion", &Diagnostics::energy, &Energy::distortion),
      diagnostic("energy_bending", &Diagnostics::energy, &Energy::bending),
      diagnostic("energy_thermotropic", &Diagnostics::energy, &Energy::thermotropic),
      diagnostic("energy_area_difference", &Diagnostics::energy, &Energy::area_difference),
      diagnostic("order_min", &Diagnostics::order_min),
      diagnostic("order_max", &Diagnostics::order_max),
      diagnostic("order_mean", &Diagnostics::order_mean),
      diagnostic("order_std", &Diagnostics::order_std),
      diagnostic("H_abs_max", &Diagnostics::H_abs_max),
      diagnostic("W2", &Diagnostics::W2),
      diagnostic("area", &Diagnostics::area),
      diagnostic("volume", &Diagnostics::volume),
      length("length_1", 0),
      length("length_2", 1),
      length("length_3", 2),
      measure("pressure", &Measures::pressure),
      measure("tension", &Measures::tension),
      measure("triangles", &Measures::triangles),
      measure("negative_directions", &Measures::negative_directions),
      measure("rigid_motions", &Measures::rigid_motions),
      measure("class", &Measures::symmetry),
      measure("self_contact", &Measures::self_contact),
      part_column("residual", &Row::measures, &Measures::residual, "", "{:.3g}"),
      column("stop_reason", &Row::stop_reason),
  };
  const auto numbered = [&](const char* kind, int count, auto Row::*values) {
    for (std::size_t k = 0; k < std::size_t(count); ++k)
      columns.push_back(known_column<Row>(
          fmt::format("{}_{}", kind, k + 1),
          [ k, values ](auto& row) -> auto& { return (row.*values)[k]; }));
  };
  numbered("eigenvalue", input.eigenpairs, &Row::eigenvalues);
  numbered("rate", input.rates, &Row::rates);
  if (follows_other_number(input)) {
    const std::string parameter = input.follow->parameter;
    columns.insert(columns.begin() + 5, column(parameter, &Row::followed));
  }
  if (input.follow)
    columns.insert(columns.begin() + 3, {column("path", &Row::path), column("point", &Row::point),
                                         column("from", &Row::from)});
  else if (input.passes)
    columns.insert(columns.begin() + 3, {column("point", &Row::point), column("from", &Row::from)});
  else if (input.search)
    columns.insert(columns.begin() + 3, column("from", &Row::from));
  return columns;
}

std::string table_of(const StatesInput& input, const std::vector<RestRow>& rows) {
  const bool other = follows_other_number(input);
  std::string text = fmt::format("{:>6} {:>8} {:>8} ", "number", "V_r", "L");
  if (other) text += fmt::format("{:>11} ", input.follow->parameter);
  text +=
      fmt::format("{:>14} {:>9} {:>6}  {}\n", "energy", "negative", "class", "lowest eigenvalues");
  for (const RestRow& row : rows) {
    text += fmt::format("{:>6} {:>8.6g} {:>8.6g} ", row.key, row.reduced_volume, row.L);
    if (other) text += fmt::format("{:>11.6g} ", row.followed);
    if (row.measures)
      text += fmt::format("{:>14.9g} {:>9} {:>6} ", row.measures->diagnostics.energy.total(),
                          row.measures->negative_directions, row.measures->symmetry);
    for (int k = 0; row.measures && k < std::min(3, input.eigenpairs); ++k)
      if (const double value = row.eigenvalues[std::size_t(k)]; std::isfinite(value))
        text += fmt::format(" {:.6g}", value);
    if (row.status != PointStatus::stationary)
      text += fmt::format(" {}: {}", sbeh::name(row.status), row.stop_reason);
    text += "\n";
  }
  return text;
}

}  // namespace sbeh::studies

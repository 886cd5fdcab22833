#include "studies/seifert/seifert.h"

#include "axisym/modes/threshold.h"
#include "axisym/shooting/seifert_shooting.h"
#include "axisym/spectral/minimiser.h"
#include "axisym/stationary/classical_branches.h"
#include "axisym/stationary/symmetry.h"
#include "studies/io/output.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/mode_columns.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::studies {

using axisym::Branch;
using axisym::ClassicalShape;
using axisym::SpecialPoint;
using axisym::SpecialPoints;

namespace {

// Reduced volumes of the diagram: each branch nearly as far as it exists and does not touch itself,
// steps of 1/40 between.
std::vector<double> volumes_of(Branch branch) {
  std::vector<double> volumes;
  if (branch == Branch::stomatocyte) volumes.push_back(0.66);
  const int from = branch == Branch::stomatocyte ? 26 : 39, to = branch == Branch::oblate ? 21 : 16;
  for (int k = from; k >= to; --k) volumes.push_back(k / 40.);
  if (branch == Branch::oblate) volumes.push_back(0.505);
  return volumes;
}

constexpr std::array modes_of_shapes{0, 1, 2, 3, 4};

// Between neighbours.
std::vector<ClassicalThreshold> thresholds_of(Branch branch,
                                              const std::vector<axisym::BranchState>& states,
                                              const axisym::Numerics& numerics) {
  constexpr double promised = 1e-9;
  std::vector<ClassicalThreshold> found;
  for (std::size_t k = 1; k < states.size(); ++k) {
    axisym::Line line{axisym::classical_material(), model::Model::SSH, states[k - 1].at,
                      states[k].at};
    line.symmetric = axisym::is_symmetric(states[k - 1].X);
    for (const axisym::Threshold& t :
         axisym::thresholds_along(line, states[k - 1], modes_of_shapes, numerics, promised))
      found.push_back(
          {branch, t.m, t.parity,
           SpecialPoint{
               .reduced_volume = t.state.at.reduced_volume,
               .energy = axisym::reduced_energy(t.state),
               .error = t.is_located ? t.error : std::numeric_limits<double>::infinity()}});
  }
  return found;
}

WitnessReport report_of_elements(const axisym::Numerics& numerics) {
  const Stopwatch watch;
  axisym::ElementBranches branches(numerics);
  WitnessReport r{"elements", {}, {}, 0};
  for (const Branch branch : axisym::classical_branches) {
    const auto states = branches.states(branch, volumes_of(branch));
    for (const axisym::BranchState& state : states) {
      r.shapes.push_back(axisym::shape_of(branch, state));
      r.modes.push_back(axisym::stability_3d(axisym::classical_material(), model::Model::SSH, state,
                                             modes_of_shapes.back())
                            .value_or(axisym::Stability3d{}));
    }
    for (ClassicalThreshold& threshold : thresholds_of(branch, states, numerics))
      r.thresholds.push_back(threshold);
  }
  r.points = branches.special_points_with_errors();
  r.seconds = watch.seconds();
  return r;
}

template <class Shapes, class Points>
WitnessReport report(std::string name, Shapes&& shapes_of, Points&& points) {
  const Stopwatch watch;
  WitnessReport r{std::move(name), {}, {}, 0};
  for (const Branch branch : axisym::classical_branches)
    for (const ClassicalShape& shape : shapes_of(branch, volumes_of(branch)))
      r.shapes.push_back(shape);
  r.points = points();
  r.seconds = watch.seconds();
  return r;
}

WitnessReport witness(int which, const axisym::Numerics& numerics) {
  if (which == 0) return report_of_elements(numerics);
  if (which == 1)
    return report(
        "shooting", [](Branch b, const auto& v) { return axisym::shoot_branch(b, v); },
        [] { return axisym::shoot_special_points(); });
  return report(
      "minimiser", [](Branch b, const auto& v) { return axisym::minimise_branch(b, v); },
      [] { return axisym::minimise_special_points(); });
}

Disagreement disagreement(const WitnessReport& a, const WitnessReport& b, Branch branch) {
  Disagreement d{a.witness, b.witness, branch, 0, 0, 0, 0};
  for (const ClassicalShape& s : a.shapes)
    for (const ClassicalShape& t : b.shapes)
      if (s.branch == branch && t.branch == branch && s.reduced_volume == t.reduced_volume) {
        d.energy = std::max(d.energy, std::abs(s.energy - t.energy));
        d.H_pole = std::max(d.H_pole, std::abs(s.H_pole - t.H_pole));
        d.pressure = std::max(d.pressure, std::abs(s.pressure - t.pressure));
        d.tension = std::max(d.tension, std::abs(s.tension - t.tension));
      }
  return d;
}

SpecialPoints agreed_points(const std::vector<WitnessReport>& witnesses) {
  SpecialPoints points{};
  for (const auto& [name, member] : special_point_names()) {
    std::vector<SpecialPoint> each;
    each.reserve(witnesses.size());
    for (const WitnessReport& w : witnesses) each.push_back(w.points.*member);
    SpecialPoint& agreed = points.*member;
    agreed = *std::ranges::min_element(each, {}, &SpecialPoint::error);
    for (const SpecialPoint& point : each)
      agreed.error = std::max(agreed.error, std::abs(point.reduced_volume - agreed.reduced_volume));
  }
  return points;
}

void write_tables(const OutputFolder& folder, const SeifertSummary& summary) {
  std::vector<BranchRow> shapes;
  for (const WitnessReport& w : summary.witnesses)
    for (std::size_t k = 0; k < w.shapes.size(); ++k)
      shapes.push_back(
          {w.witness, w.shapes[k], w.modes.empty() ? axisym::Stability3d{} : w.modes[k]});
  std::vector<PointRow> points, each;
  for (const NamedPoint& p : special_point_names()) {
    points.push_back({"", p.name, summary.points.*p.member});
    for (const WitnessReport& w : summary.witnesses)
      each.push_back({w.witness, p.name, w.points.*p.member});
  }
  const auto write = [&](std::string_view name, const auto& columns, const auto& rows) {
    write_file(folder / name, table_text(columns, rows));
  };
  write("branches.csv", branch_columns(), shapes);
  write("points.csv", point_columns(), points);
  write("points_by_witness.csv", witness_point_columns(), each);
  write("stability_lines.csv", classical_threshold_columns(), summary.witnesses.front().thresholds);
  write("differences.csv", disagreement_columns(), summary.disagreements);
}

// Empty where the witness does not tell.
Column<BranchRow> negative_directions() {
  return {"negative_directions",
          [](const BranchRow& row) {
            const int count = row.shape.negative_directions;
            return count < 0 ? "" : std::to_string(count);
          },
          [](BranchRow& row, const std::string& field) {
            return field.empty() || read_field(row.shape.negative_directions, field);
          }};
}

}  // namespace

const std::vector<NamedPoint>& special_point_names() {
  static const std::vector<NamedPoint> names{
      {"prolate_oblate", &SpecialPoints::prolate_oblate},
      {"oblate_stomatocyte", &SpecialPoints::oblate_stomatocyte},
      {"stomatocyte_fold", &SpecialPoints::stomatocyte_fold},
      {"oblate_symmetry_loss", &SpecialPoints::oblate_symmetry_loss},
      {"oblate_self_contact", &SpecialPoints::oblate_self_contact},
  };
  return names;
}

SeifertSummary run_seifert(const std::filesystem::path& path, int elements) {
  const OutputFolder folder(path);
  refuse_results(folder, {"run.toml", "branches.csv"});
  axisym::Numerics numerics;
  numerics.elements = elements;
  numerics.validate();

  SeifertSummary summary;
  summary.witnesses.resize(3);
  tbb::parallel_for(
      0, 3, [&](int k) { summary.witnesses[std::size_t(k)] = witness(k, numerics); },
      tbb::simple_partitioner());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      for (const Branch branch : axisym::classical_branches)
        summary.disagreements.push_back(
            disagreement(summary.witnesses[i], summary.witnesses[j], branch));
  summary.points = agreed_points(summary.witnesses);

  write_tables(folder, summary);
  return summary;
}

std::string table_of(const SeifertSummary& summary) {
  std::string text = "largest differences of the witnesses\n";
  text += fmt::format("  {:<22} {:<12} {:>10} {:>10} {:>10} {:>10}\n", "", "", "F/(8 pi kappa)",
                      "H_pole", "pressure", "tension");
  for (const Disagreement& d : summary.disagreements)
    text += fmt::format("  {:<22} {:<12} {:>14.1e} {:>10.1e} {:>10.1e} {:>10.1e}\n",
                        d.first + " - " + d.second, sbeh::name(d.branch), d.energy, d.H_pole,
                        d.pressure, d.tension);
  text += "\nspecial points (the error covers what the witnesses disagree in)\n";
  for (const NamedPoint& p : special_point_names()) {
    const SpecialPoint& s = summary.points.*p.member;
    text += fmt::format("  {:<22} V_r = {:.9f} +- {:.1e}   F/(8 pi kappa) = {:.8f}\n", p.name,
                        s.reduced_volume, s.error, s.energy);
  }
  text += "\nwhere the second variation changes its sign (finite elements)\n";
  for (const ClassicalThreshold& t : summary.witnesses.front().thresholds)
    text += fmt::format("  {:<22} V_r = {:.9f} +- {:.1e}   F/(8 pi kappa) = {:.8f}\n",
                        fmt::format("{}, m = {} {}", sbeh::name(t.branch), t.m, name(t.parity)),
                        t.point.reduced_volume, t.point.error, t.point.energy);
  for (const WitnessReport& w : summary.witnesses)
    text += fmt::format("{}: {} shapes and the points in {:.2f} s\n", w.witness, w.shapes.size(),
                        w.seconds);
  return text;
}

const Columns<BranchRow>& branch_columns() {
  using Row = BranchRow;
  const auto of_shape = [](std::string name, auto member) {
    return column<Row>(std::move(name), inside(&Row::shape, member));
  };
  static const Columns<Row> columns = [&] {
    Columns<Row> all{
        column("witness", &Row::witness),
        of_shape("branch", &ClassicalShape::branch),
        of_shape("reduced_volume", &ClassicalShape::reduced_volume),
        of_shape("energy_reduced", &ClassicalShape::energy),
        of_shape("H_pole", &ClassicalShape::H_pole),
        of_shape("pressure", &ClassicalShape::pressure),
        of_shape("tension", &ClassicalShape::tension),
        negative_directions(),
        of_shape("self_contact", &ClassicalShape::self_contact),
        column<Row>("negative_directions_3d",
                    inside(&Row::modes, &axisym::Stability3d::negative_directions)),
        derived_column<Row>("unstable_modes",
                            [](const Row& row) { return text_of_modes(row.modes); }),
    };
    for (const int m : modes_of_shapes)
      all.push_back(known_column<Row>(
          fmt::format("eigenvalue_m{}", m), [m](auto& row) -> auto& {
            return row.modes.eigenvalue[std::size_t(m)];
          }));
    return all;
  }();
  return columns;
}

const Columns<ClassicalThreshold>& classical_threshold_columns() {
  using Row = ClassicalThreshold;
  static const Columns<Row> columns{
      column("branch", &Row::branch),
      column("m", &Row::m),
      column("parity", &Row::parity),
      column<Row>("reduced_volume", inside(&Row::point, &SpecialPoint::reduced_volume)),
      column<Row>("energy_reduced", inside(&Row::point, &SpecialPoint::energy)),
      column<Row>("error", inside(&Row::point, &SpecialPoint::error), "{:.2g}"),
  };
  return columns;
}

const Columns<PointRow>& point_columns() {
  using Row = PointRow;
  static const Columns<Row> columns{
      column("name", &Row::name),
      column<Row>("reduced_volume", inside(&Row::point, &SpecialPoint::reduced_volume)),
      column<Row>("energy_reduced", inside(&Row::point, &SpecialPoint::energy)),
      column<Row>("error", inside(&Row::point, &SpecialPoint::error), "{:.2g}"),
  };
  return columns;
}

const Columns<PointRow>& witness_point_columns() {
  static const Columns<PointRow> columns = [] {
    Columns<PointRow> all = point_columns();
    all.insert(all.begin(), column("witness", &PointRow::witness));
    return all;
  }();
  return columns;
}

const Columns<Disagreement>& disagreement_columns() {
  using Row = Disagreement;
  static const Columns<Row> columns{
      column("first", &Row::first),
      column("second", &Row::second),
      column("branch", &Row::branch),
      column("energy_reduced", &Row::energy, "{:.3g}"),
      column("H_pole", &Row::H_pole, "{:.3g}"),
      column("pressure", &Row::pressure, "{:.3g}"),
      column("tension", &Row::tension, "{:.3g}"),
  };
  return columns;
}

}  // namespace sbeh::studies

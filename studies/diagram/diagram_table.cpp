#include "studies/diagram/diagram_table.h"

#include "axisym/diagnostics.h"
#include "axisym/diagram/closing.h"
#include "axisym/diagram/equal_energy.h"
#include "axisym/shape_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <span>

namespace sbeh::studies {

using axisym::Line;
using axisym::PathState;
using axisym::Special;
using std::numbers::pi;

namespace {

// F/κ of what is measured.
double energy_of(const model::Material& material, const model::Energy& energy) {
  const double kappa = material.kappa(model::full_order),
               gaussian = 4 * pi * material.kappa_gauss(model::full_order);
  return (energy.total() - gaussian) / kappa;
}

double effective_H0(const model::Material& material, double moment) {
  return material.spontaneous_curvature - moment / material.kappa(model::full_order);
}

DiagramPlace place_of(double value, const model::Material& material,
                      const axisym::StationaryState& state) {
  const axisym::Diagnostics d = diagnose(material, state);
  return {value, effective_H0(material, state.moment), d.W2, d.reduced_volume,
          energy_of(material, d.energy)};
}

DiagramPlace place_of(double value, const Line& line, const PathState& state) {
  DiagramPlace place = place_of(value, line.material_at(state.mu), state);
  place.reduced_volume = line.at(state.mu).reduced_volume;  // exactly
  return place;
}

// The name of the branch that leaves at a symmetry loss, or comes back there; where it was not traced, that of its kind.
std::string child_at(const std::vector<DiagramBranch>& branches, const DiagramBranch& parent,
                     double reduced_volume) {
  constexpr double same = 1e-9;
  for (const DiagramBranch& child : branches)
    if (child.from == parent.name
        && (std::abs(child.start_volume - reduced_volume) < same
            || (child.end_volume
                && std::abs(*child.end_volume - reduced_volume) < axisym::near_return)))
      return child.name;
  return parent.name == "prolate" ? "pear" : "stomatocyte";
}

// Of the points of a leg from its end on, those with about one, two, four and eight times the neck's last radius.
template <class Points>
std::vector<const axisym::TracePoint*> into_the_neck(const Points& from_end) {
  constexpr double narrow = 0.1;
  std::vector<const axisym::TracePoint*> picked;
  double wanted = 0;
  for (const axisym::TracePoint& p : from_end) {
    const double radius = axisym::thinnest_neck(p.state.X);
    if (picked.size() == 4 || p.leg != from_end.front().leg || radius > narrow) break;
    if (radius < wanted) continue;
    picked.push_back(&p);
    wanted = 2 * radius;
  }
  return picked;
}

// To what V_r tends where some of the necks close, and nothing is known in closed form.
void extrapolate(const Line& line, const std::vector<const axisym::TracePoint*>& points,
                 Bifurcation& limit) {
  std::array<axisym::ClosingMeasures, 4> way;
  if (points.size() < way.size()) return;
  for (std::size_t k = 0; k < way.size(); ++k) {
    const PathState& state = points[k]->state;
    way[k] = {axisym::thinnest_neck(state.X), {line.at(state.mu).reduced_volume}};
  }
  const auto closed = axisym::with_closed_neck(way);
  limit.at.reduced_volume = closed.values[0];
  limit.error = closed.errors[0];
}

// Spheres that touch stand for the last state of a branch whose necks close; without them it is that state, and its last ones
// tell V_r.
Bifurcation limit_of(double value, const DiagramBranch& branch, bool at_end) {
  const auto& points = branch.trace.points;
  const axisym::TracePoint& last = at_end ? points.back() : points.front();
  const model::Material material = branch.line.material_at(last.state.mu);
  Bifurcation limit{
      "limit",   branch.name, branch.from,      place_of(value, branch.line, last.state),
      not_known, last.leg,    last.self_contact};
  if (const auto spheres = closing_shape(material, diagnose(material, last.state))) {
    const axisym::Diagnostics d = diagnose(material, *spheres);
    const double kappa = material.kappa(model::full_order);
    const model::AreaDifference& ad = material.area_difference;
    double H0 = material.spontaneous_curvature;
    if (ad.is_there())
      H0 = ad.compliance() > 0 ? -(d.W2 - ad.W2) / (d.area * ad.compliance() * kappa)
                               : closing_H0(*spheres);
    limit.at = {value, H0, d.W2, d.reduced_volume, energy_of(material, d.energy)};
    limit.error = 0;
  } else if (at_end) {
    extrapolate(branch.line, into_the_neck(std::views::reverse(points)), limit);
  } else {
    extrapolate(branch.line, into_the_neck(points), limit);
  }
  return limit;
}

// Consecutive states of a leg that are minima within axisymmetry and do not touch themselves, by ascending μ.
std::vector<std::vector<PathState>> minima_of(const DiagramBranch& branch) {
  std::vector<std::vector<PathState>> pieces;
  const axisym::TracePoint* before = nullptr;
  for (const axisym::TracePoint& p : branch.trace.points) {
    if (p.negative_directions > 0 || p.self_contact) {
      before = nullptr;
      continue;
    }
    if (!before || before->leg != p.leg) pieces.emplace_back();
    pieces.back().push_back(p.state);
    before = &p;
  }
  for (auto& piece : pieces) std::ranges::sort(piece, {}, &PathState::mu);
  return pieces;
}

void add_equal_energies(const DiagramInput& input, double value,
                        const std::vector<DiagramBranch>& branches,
                        std::vector<Bifurcation>& rows) {
  for (std::size_t i = 0; i < branches.size(); ++i)
    for (std::size_t j = i + 1; j < branches.size(); ++j)
      for (const auto& a : minima_of(branches[i]))
        for (const auto& b : minima_of(branches[j])) {
          Line line = branches[i].line;
          line.symmetric = branches[i].line.symmetric && branches[j].line.symmetric;
          for (const auto& both : equal_energies(line, a, b, input.numerics())) {
            DiagramPlace at = place_of(value, line.material, both.first);
            at.reduced_volume = both.first.at.reduced_volume;
            rows.push_back(
                {"equal_energy", branches[i].name, branches[j].name, at, both.error, 0, false});
          }
        }
}

}  // namespace

std::vector<DiagramRow> rows_of(double value, const DiagramBranch& branch) {
  std::vector<DiagramRow> rows;
  for (const axisym::TracePoint& p : branch.trace.points) {
    const double neck = axisym::thinnest_neck(p.state.X),
                 kappa = branch.line.material.kappa(model::full_order);
    rows.push_back({branch.name, branch.from, p.leg, place_of(value, branch.line, p.state),
                    p.state.pressure / kappa, p.state.tension / kappa,
                    std::isfinite(neck) ? neck : not_known, p.negative_directions,
                    p.negative_directions_3d, p.self_contact});
  }
  return rows;
}

std::vector<Bifurcation> bifurcations_of(const DiagramInput& input, double value,
                                         const std::vector<DiagramBranch>& branches) {
  std::vector<Bifurcation> rows;
  for (const DiagramBranch& branch : branches) {
    for (const axisym::SpecialState& s : branch.trace.specials) {
      Bifurcation row{"fold",
                      branch.name,
                      branch.from,
                      place_of(value, branch.line, s.state),
                      std::isfinite(s.error) ? s.error : not_known,
                      s.leg,
                      axisym::crosses_itself(s.state.X)};
      if (s.kind == Special::mode) row.kind = fmt::format("mode_{}", s.m);
      if (s.kind == Special::symmetry_loss) {
        row.kind = "symmetry_loss";
        row.from = branch.name;
        row.branch = child_at(branches, branch, row.at.reduced_volume);
      }
      rows.push_back(std::move(row));
    }
    if (branch.trace.points.empty()) continue;
    if (branch.trace.begin == axisym::TraceEnd::limit)
      rows.push_back(limit_of(value, branch, false));
    if (branch.trace.end == axisym::TraceEnd::limit) rows.push_back(limit_of(value, branch, true));
  }
  add_equal_energies(input, value, branches, rows);
  return rows;
}

std::vector<DiagramShapeRow> lowest_shapes(const DiagramInput& input, double value,
                                           const std::vector<DiagramBranch>& branches) {
  constexpr int columns = 7;
  const double width = (1 - input.least_volume) / columns;
  std::vector<DiagramShapeRow> rows;
  for (int k = 0; k < columns; ++k) {
    const double volume = input.least_volume + (k + 0.5) * width;
    const axisym::TracePoint* best = nullptr;
    const DiagramBranch* of = nullptr;
    double least = 0;
    for (const DiagramBranch& branch : branches)
      for (const axisym::TracePoint& p : branch.trace.points) {
        const DiagramPlace at = place_of(value, branch.line, p.state);
        const bool is_near = std::abs(at.reduced_volume - volume) < 0.3 * width;
        // Along a branch the energy goes with V_r: compared are energies carried to the same one.
        const double energy =
            at.energy + p.state.pressure * 4 * pi / 3 * (volume - at.reduced_volume);
        if (!is_near || p.negative_directions > 0 || p.self_contact || (best && energy >= least))
          continue;
        best = &p;
        of = &branch;
        least = energy;
      }
    if (!best) continue;
    const axisym::Nodes& X = best->state.X;
    const Eigen::Index stride = std::max<Eigen::Index>(1, X.cols() / 100);
    const double middle = (X(1, 0) + X(1, X.cols() - 1)) / 2;
    for (Eigen::Index i = 0; i < X.cols(); i += stride)
      rows.push_back({k, of->name, value, of->line.at(best->state.mu).reduced_volume, X(0, i),
                      X(1, i) - middle});
    if ((X.cols() - 1) % stride != 0)
      rows.push_back({k, of->name, value, of->line.at(best->state.mu).reduced_volume, 0,
                      X(1, X.cols() - 1) - middle});
  }
  return rows;
}

const Columns<DiagramShapeRow>& diagram_shape_columns() {
  using Row = DiagramShapeRow;
  static const Columns<Row> columns{
      column("number", &Row::number), column("branch", &Row::branch),
      column("value", &Row::value),   column("reduced_volume", &Row::reduced_volume),
      column("r", &Row::r, "{:.6g}"), column("z", &Row::z, "{:.6g}"),
  };
  return columns;
}

namespace {

template <class Row>
Columns<Row> place_columns() {
  const auto of = [](std::string name, auto member) {
    return column<Row>(std::move(name), inside(&Row::at, member));
  };
  return {of("H0", &DiagramPlace::H0), of("W2", &DiagramPlace::W2),
          of("reduced_volume", &DiagramPlace::reduced_volume), of("energy", &DiagramPlace::energy)};
}

template <class Row>
void append(Columns<Row>& to, const Columns<Row>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

const Columns<Bifurcation>& bifurcation_columns() {
  using Row = Bifurcation;
  static const Columns<Row> columns = [] {
    Columns<Row> all{column("kind", &Row::kind), column("branch", &Row::branch),
                     column("from", &Row::from)};
    append(all, place_columns<Row>());
    all.push_back(known_column("error", &Row::error, "{:.2g}"));
    all.push_back(column("leg", &Row::leg));
    all.push_back(column("self_contact", &Row::self_contact));
    all.push_back(column<Row>("value", inside(&Row::at, &DiagramPlace::value)));
    return all;
  }();
  return columns;
}

const Columns<DiagramRow>& diagram_columns() {
  using Row = DiagramRow;
  static const Columns<Row> columns = [] {
    Columns<Row> all{column("branch", &Row::branch), column("from", &Row::from),
                     column("leg", &Row::leg)};
    append(all, place_columns<Row>());
    append(all, {column("pressure", &Row::pressure), column("tension", &Row::tension),
                 known_column("neck", &Row::neck),
                 column("negative_directions", &Row::negative_directions),
                 column("negative_directions_3d", &Row::negative_directions_3d),
                 column("self_contact", &Row::self_contact),
                 column<Row>("value", inside(&Row::at, &DiagramPlace::value))});
    return all;
  }();
  return columns;
}

}  // namespace sbeh::studies

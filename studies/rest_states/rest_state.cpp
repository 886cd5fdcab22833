#include "studies/rest_states/rest_state.h"

#include "studies/evolution/event_log.h"
#include "studies/evolution/frame_file.h"
#include "studies/io/interrupt.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/parameters/physics_numbers.h"
#include "surface3d/lipids.h"
#include "surface3d/mesh/resolution.h"
#include "surface3d/mesh/self_contact.h"
#include "surface3d/moments.h"
#include "surface3d/stationary/symmetry_class.h"
#include "surface3d/variational/growth_rates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::Eigenmode;
using surface3d::GrowthMode;
using surface3d::NewtonStatus;
using surface3d::StationaryState;
using surface3d::Triangulation;

namespace {

// A revolved state that Newton's method moves farther than this, in radii, is another one then.
constexpr double far_from_start = 0.1;
constexpr double same_on_path = 0.03;

const char* why(NewtonStatus status) {
  return status == NewtonStatus::singular
           ? "Newton's method meets a singular matrix: a bifurcation or a fold is near"
           : "Newton's method does not converge from this start";
}

// With the state, and the mode's own fields and value.
void write_mode(const fs::path& file, const SeenState& seen, NodeFields fields,
                const std::string& name, double value, const Physics& physics) {
  const StationaryState& state = seen.state;
  fields["order"] = state.beta.transpose();
  fields["mean_curvature"] = state.H.transpose();
  Globals globals{{name, Eigen::VectorXd::Constant(1, value)}};
  write_physics(physics, globals);
  const meshing::CurvedMesh surface{
      .order = 3, .triangles = seen.mesh->triangles, .nodes = state.X};
  write_file(file, vtu_text(surface, fields, globals));
}

void write_files(const fs::path& folder, int number, const SeenState& seen,
                 const std::vector<Eigenmode>& modes, const Physics& physics) {
  make_folder(folder / "frames");
  write_frame(frame_of(folder, number),
              {.mesh = seen.mesh,
               .state = seen.state,
               .target = surface3d::lipids_and_volume(
                   *seen.mesh, effective(physics.material, physics.model), seen.state)},
              physics);
  if (!modes.empty()) make_folder(folder / "modes");
  int k = 0;
  for (const Eigenmode& mode : modes)
    write_mode(mode_of(folder, number, ++k), seen,
               {{"displacement", seen.normals * mode.u.asDiagonal()},
                {"order_change", mode.b.transpose()}},
               "eigenvalue", mode.eigenvalue, physics);
}

// False where they are not found.
bool measure_rates(int count, const SeenState& seen, const fs::path& folder, const Physics& physics,
                   RestRow& row) {
  const auto modes =
      surface3d::growth_rates(physics.material, *seen.mesh, physics.model, seen.state, count);
  if (!modes) return false;
  make_folder(folder / "modes");
  const surface3d::Nodes normals = surface3d::node_normals(*seen.mesh, seen.state.X);
  int k = 0;
  for (const GrowthMode& mode : *modes) {
    row.rates[std::size_t(k)] = mode.rate;
    write_mode(growth_mode_of(folder, row.key, ++k), seen,
               {{"displacement", normals * mode.u.asDiagonal()},
                {"order_change", mode.b.transpose()},
                {"motion", mode.V}},
               "rate", mode.rate, physics);
  }
  return true;
}

// What keeps a state from being believed; empty where nothing does.
std::string doubt_about(const SeenState& seen, const RestMeasures& measures) {
  const auto curvature = surface3d::curvature_of(*seen.mesh, seen.state.X);
  if (!curvature) return "the surface is degenerate";
  const surface3d::Indicators indicators =
      surface3d::indicators_of(*seen.mesh, seen.state.X, *curvature);
  if (!surface3d::resolved(indicators))
    return "the triangles do not resolve the surface: " + passed_limits(indicators);
  if (measures.self_contact) return "the surface comes near itself: contact is not in the model";
  return {};
}

}  // namespace

namespace {

// But for the system, which is linearised nearby.
RestState rest_state_near(const StatesInput& input, const axisym::PlanePoint& at,
                          const RestStart& start,
                          const surface3d::NewtonOptions& options = {.keeps_factors = true}) {
  RestState result{.mesh = start.mesh, .failure = start.failure};
  if (!start.mesh) return result;
  const model::Material material = input.material.with_L1(at.L);
  result.system = start.system
                    ? start.system
                    : std::make_shared<surface3d::NewtonSystem>(*start.mesh, material, input.model);
  result.system->set_material(material);
  auto found = surface3d::solve_stationary(
      *result.system, axisym::target_of(at.reduced_volume),
      surface3d::guess_from(*start.mesh, material, input.model, start.state), options);
  if (found.status != NewtonStatus::converged) {
    result.failure = why(found.status);
    return result;
  }
  result.moved = (found.state.X - start.state.X).colwise().norm().maxCoeff();
  result.state = std::move(found.state);
  result.normals = std::move(found.normals);
  return result;
}

}  // namespace

RestState rest_state_from(const StatesInput& input, const axisym::PlanePoint& at,
                          const RestStart& start, const surface3d::NewtonOptions& options) {
  RestState result = rest_state_near(input, at, start, options);
  if (result.failure.empty() && !result.system->linearise(result.state, result.normals))
    result.failure = why(NewtonStatus::singular);
  return result;
}

bool resolved_by(const Triangulation& mesh, const surface3d::Nodes& X) {
  const auto curvature = surface3d::curvature_of(mesh, X);
  return curvature && surface3d::resolved(surface3d::indicators_of(mesh, X, *curvature));
}

RestState on_new_triangles(const StatesInput& input, const axisym::PlanePoint& at,
                           const RestState& state) {
  const model::Material material = input.material.with_L1(at.L);
  RestState there;
  for (const double more : {1., 1.5, 2.}) {
    there = rest_state_from(
        input, at,
        remeshed_start(*state.mesh, state.state, material, int(more * state.mesh->count())));
    if (there.failure.empty() && resolved_by(*there.mesh, there.state.X)) return there;
  }
  if (there.failure.empty()) there.failure = "the triangles do not resolve the state";
  return there;
}

RestMeasures measures_of(const SeenState& seen, const model::Material& material) {
  const Triangulation& mesh = *seen.mesh;
  const StationaryState& state = seen.state;
  const int rigid = seen.system.rigid_count();
  RestMeasures of{.diagnostics = surface3d::diagnose(mesh, material, state),
                  .pressure = state.pressure,
                  .tension = state.tension,
                  .triangles = mesh.count(),
                  .negative_directions = seen.system.negative_directions(),
                  .rigid_motions = rigid};
  of.diagnostics.energy = surface3d::energy(material, mesh, state);
  const surface3d::Moments moments = surface3d::moments_of(surface3d::samples_of(mesh, state.X));
  for (int k = 0; k < 3; ++k) of.lengths[std::size_t(k)] = std::sqrt(moments.principal[k]);
  of.symmetry = surface3d::symmetry_class(mesh, state);
  of.self_contact = !surface3d::self_contacts(mesh, state.X).empty();
  of.residual = surface3d::residual_of(seen.system, state);
  return of;
}

void measure(const StatesInput& input, const SeenState& seen, const fs::path& folder,
             RestRow& row) {
  const Physics physics{input.model, input.material.with_L1(seen.at.L)};
  row.measures = measures_of(seen, physics.material);
  row.stop_reason = doubt_about(seen, *row.measures);
  auto modes = surface3d::lowest_modes(seen.system, seen.state, seen.normals, input.eigenpairs);
  if (row.stop_reason.empty() && !modes) row.stop_reason = "the eigenpairs are not found";
  if (!modes) modes.emplace();
  modes->resize(std::min(modes->size(), std::size_t(input.eigenpairs)));
  for (std::size_t k = 0; k < modes->size(); ++k) row.eigenvalues[k] = (*modes)[k].eigenvalue;
  write_files(folder, row.key, seen, *modes, physics);
  if (input.rates > 0 && !measure_rates(input.rates, seen, folder, physics, row)
      && row.stop_reason.empty())
    row.stop_reason = "the rates of the linearised flow are not found";
  row.status = row.stop_reason.empty() ? PointStatus::stationary : PointStatus::unresolved;
  if (row.stop_reason.empty()) row.stop_reason = "stationary";
}

RestRow row_at(const StatesInput& input, const StatePlace& place) {
  RestRow row;
  row.key = place.number;
  row.model = input.model;
  row.start = brings_its_mesh(input.start) ? name(input.start) : name(input.branch);
  row.reduced_volume = place.at.reduced_volume;
  row.L = place.at.L;
  return row;
}

double energy_error(const StatesInput& input, const RestRow& row, const RestStart& coarser,
                    bool on_path) {
  const axisym::PlanePoint at{row.reduced_volume, row.L};
  const RestState other =
      on_path ? rest_state_near(input, at, coarser) : rest_state_from(input, at, coarser);
  if (!other.failure.empty() || !row.measures) return not_known;
  // Near a branching point the energies of two branches differ by the fourth power of their distance.
  const bool same = on_path
                      ? other.moved < same_on_path
                      : other.system->negative_directions() == row.measures->negative_directions
                            && other.system->rigid_count() == row.measures->rigid_motions;
  if (!same) return not_known;
  const double energy =
      surface3d::energy(input.material.with_L1(row.L), *other.mesh, other.state).total();
  return std::abs(energy - energy_of(row));
}

double energy_error_on_path(const StatesInput& input, const RestRow& row, const SeenState& seen) {
  const model::Material material = input.material.with_L1(seen.at.L);
  double error = not_known;
  for (const int share : {4, 2})
    if (std::isnan(error) && !interrupt_signal())
      error = energy_error(
          input, row, remeshed_start(*seen.mesh, seen.state, material, seen.mesh->count() / share),
          true);
  return error;
}

RestRow rest_row(const StatesInput& input, const StatePlace& place, const fs::path& folder) {
  RestRow row = row_at(input, place);
  const RestState found = rest_state_from(input, place.at, rest_start(input, place.at));
  if (!found.failure.empty()) {
    row.stop_reason = found.failure;
    return row;
  }
  const SeenState seen{*found.system, found.mesh, found.state, found.normals, place.at};
  measure(input, seen, folder, row);
  const bool has_axis = !brings_its_mesh(input.start) && input.perturbation.empty();
  if (has_axis && found.moved > far_from_start) {
    row.status = PointStatus::unresolved;
    row.stop_reason =
        fmt::format("Newton's method has left the axisymmetric state by {:.2g}", found.moved);
  }
  if (interrupt_signal()) return row;
  row.energy_error =
      energy_error(input, row, coarser_start(input, place.at, row.measures->triangles / 4));
  if (std::isnan(row.energy_error) && brings_its_mesh(input.start))
    row.energy_error = energy_error_on_path(input, row, seen);
  if (std::isnan(row.energy_error) && row.status == PointStatus::stationary) {
    row.status = PointStatus::unresolved;
    row.stop_reason =
        "a quarter of the triangles has no such state: more of them would show whether it is "
        "resolved";
  }
  return row;
}

}  // namespace sbeh::studies

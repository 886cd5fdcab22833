#include "studies/evolution/run_start.h"

#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"
#include "meshing/shapes.h"
#include "studies/evolution/event_log.h"
#include "studies/io/errors.h"
#include "studies/io/input_path.h"
#include "studies/mesh/file_surface.h"
#include "studies/mesh/make_mesh.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/scan/scan_table.h"
#include "studies/states/profile_file.h"
#include "surface3d/lipids.h"
#include "surface3d/moments.h"
#include "surface3d/order_step.h"
#include "surface3d/stationary/symmetry_class.h"
#include "surface3d/symmetry.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace sbeh::studies {

namespace {

using meshing::CurvedMesh;
constexpr double unit_area = 4 * std::numbers::pi;
constexpr double usual_grading = 1;

// A surface and, where the start brings it, its order.
struct Start {
  CurvedMesh mesh;
  Eigen::VectorXd beta = {};  // nodes, or empty
  std::vector<std::string> remarks = {};
};

// Throws std::invalid_argument for what no mesh maker has checked.
void require_sound(const CurvedMesh& mesh, const meshing::Names& names = {}) {
  quality_of_sound(mesh, names);
  if (!(meshing::volume(mesh) > 0))
    throw std::invalid_argument("the surface is turned inside out: its volume is negative");
}

// The same for the mesh of a file.
CurvedMesh sound(CurvedMesh mesh, const std::string& file, const meshing::Names& names = {}) {
  try {
    require_sound(mesh, names);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  return mesh;
}

meshing::Resolution on_shape(const RunInput& input) {
  return {.triangles = input.triangles, .symmetry = input.symmetry.mesh};
}
// Of shapes that a formula gives.
meshing::Resolution fitted(const RunInput& input) {
  return {.triangles = input.triangles,
          .grading = usual_grading,
          .symmetry = input.symmetry.mesh,
          .fitted = true};
}

Start make(const Ellipsoid& e, const RunInput& input) {
  const meshing::Resolution resolution = fitted(input);
  if (e.reduced_volume) return {meshing::ellipsoid(*e.reduced_volume, e.prolate, resolution)};
  const Eigen::Vector3d axes(e.axes.data());
  return {meshing::ellipsoid(axes / axes.maxCoeff(), resolution)};
}

Start make(const HarmonicSphere& sphere, const RunInput& input) {
  const meshing::Resolution resolution = fitted(input);
  if (sphere.reduced_volume)
    return {meshing::harmonic_sphere(sphere.modes, *sphere.reduced_volume, resolution)};
  return {meshing::harmonic_sphere(sphere.modes, resolution)};
}

// What of a file is not taken along with its surface.
std::vector<std::string> left_behind(const CurvedFile& file, const std::string& name) {
  if (!file.fields.contains("order")) return {};
  return {
      fmt::format("{}: has an order, which shape = \"mesh\" does not take: that is for surfaces "
                  "alone; a frame of a run goes on with its order and material by shape = "
                  "\"frame\"",
                  name)};
}

// What the run itself would say at its first moment.
std::vector<std::string> remarks_on_resolution(const surface3d::Triangulation& mesh,
                                               const surface3d::Nodes& X, const std::string& file) {
  const auto curvature = surface3d::curvature_of(mesh, X);
  if (!curvature) return {};
  const surface3d::Indicators indicators = surface3d::indicators_of(mesh, X, *curvature);
  if (surface3d::resolved(indicators)) return {};
  return {
      fmt::format("{}: its triangles do not resolve the surface, and the run will not be trusted: "
                  "{}; more or better triangles would help",
                  file, passed_limits(indicators))};
}

Start make(const MeshFileStart& start, const RunInput&) {
  require_there(start.file);
  FileSurface file = surface_of_file(start.file, false);
  Start result;
  if (const auto* curved_file = std::get_if<CurvedFile>(&file.surface)) {
    result.mesh = meshing::of_order(curved_file->mesh, 3);
    result.remarks = left_behind(*curved_file, start.file);
  } else {
    result.mesh = curved(*std::get<0>(file.surface), 3);
  }
  result.mesh = sound(std::move(result.mesh), start.file, file.names);
  result.mesh.nodes.colwise() -= meshing::centre(result.mesh);
  const auto unresolved =
      remarks_on_resolution(surface3d::Triangulation(result.mesh), result.mesh.nodes, start.file);
  result.remarks.insert(result.remarks.end(), unresolved.begin(), unresolved.end());
  result.remarks.insert(result.remarks.begin(), file.notes.begin(), file.notes.end());
  return result;
}

Start make(const ScanRow& row, const RunInput& input) {
  const axisym::State profile = state_of(row);
  meshing::RevolvedMesh revolved = meshing::revolved(profile, on_shape(input));
  return {std::move(revolved.mesh), std::move(revolved.beta)};
}

Start make(const FrameStart& start, const RunInput&) {
  const FlowMoment frame = read_frame(start.file);
  if (!frame.state.beta.allFinite())
    throw InputError(fmt::format("{}: its order is no finite number everywhere", start.file));
  return {sound(curved_mesh(frame), start.file), frame.state.beta};
}

Start make(const ModeStart& start, const RunInput& input) {
  try {
    meshing::RevolvedMesh made = displaced(read_mode(start.file), start.amplitude, on_shape(input));
    return {std::move(made.mesh), std::move(made.beta)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("amplitude = {}: {}", start.amplitude, error.what()));
  }
}

double difference(const surface3d::State& a, const surface3d::State& b) {
  return std::max((a.X - b.X).cwiseAbs().maxCoeff(), (a.beta - b.beta).cwiseAbs().maxCoeff());
}

// Not a number where the surface is degenerate.
double energy_of(const surface3d::Triangulation& mesh, const model::Material& material,
                 const surface3d::State& state) {
  const auto curvature = surface3d::curvature_of(mesh, state.X);
  return curvature ? surface3d::energy(mesh, material, state, *curvature).total() : not_known;
}

// As surface3d::CoupledSystem has them.
int unknowns_of(const RunInput& input, int nodes, int quadratic_nodes) {
  const model::AreaConstraint area = model::area_constraint(input.model);
  const int mesh_motion = input.numerics.scheme == surface3d::Scheme::split ? 0 : 3 * nodes;
  if (area == model::AreaConstraint::global) return 2 * nodes + mesh_motion + 2;
  return 4 * nodes + quadratic_nodes + mesh_motion + 7;
}

}  // namespace

void perturb(CurvedMesh& mesh, const std::vector<meshing::Harmonic>& modes) {
  const surface3d::Triangulation triangulation(mesh);
  const surface3d::Nodes n = surface3d::node_normals(triangulation, mesh.nodes);
  const Eigen::Vector3d centre = mesh.nodes.rowwise().mean();
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i) {
    const Eigen::Vector3d direction = (mesh.nodes.col(i) - centre).normalized();
    mesh.nodes.col(i) += meshing::harmonic_sum(modes, direction) * n.col(i);
  }
  try {
    require_sound(mesh);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("is too large: {}", error.what()));
  }
}

meshing::RevolvedMesh displaced(const StateMode& mode, double amplitude,
                                const meshing::Resolution& resolution) {
  RevolvedMode made = revolved(mode, resolution);
  const Eigen::VectorXd beta = made.beta + amplitude * made.order_change;
  if (!(orders.contains(beta.minCoeff()) && orders.contains(beta.maxCoeff())))
    throw std::invalid_argument(
        fmt::format("is too large: the order would reach from {:.3g} to {:.3g}, which must be {}",
                    beta.minCoeff(), beta.maxCoeff(), orders.text()));
  made.mesh.nodes += amplitude * made.displacement;
  try {
    require_sound(made.mesh);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("is too large: {}", error.what()));
  }
  return {std::move(made.mesh), beta};
}

namespace {

// Where the start brings none.
surface3d::Field first_order(const RunInput& input, const surface3d::Triangulation& mesh,
                             const surface3d::Nodes& X) {
  if (!model::has_free_order(input.model))
    return surface3d::Field::Constant(mesh.nodes, model::full_order);
  try {
    AreaSamples surface;
    if (input.order_pattern.is_there()) {
      auto samples = surface3d::samples_of(mesh, X);
      surface = {std::move(samples.points), std::move(samples.areas)};
    }
    surface3d::State state{X,
                           with_pattern(surface3d::Field::Constant(mesh.nodes, input.initial_order),
                                        input.order_pattern, X, surface)};
    if (input.material.conserves_order())
      state.beta.array() += shift_to_mean(
          input.material, surface3d::total_order(mesh, state) / surface3d::area(mesh, X));
    return state.beta;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[surface] {}", error.what()));
  }
}

// Throws std::invalid_argument where the state has not what it is to keep.
std::string remark_on_symmetry(const surface3d::Triangulation& mesh, const surface3d::State& state,
                               const surface3d::FlowSymmetry& symmetry) {
  const std::string& symbol = symmetry.mesh.symbol();
  const auto of_mesh = surface3d::symmetry_of(mesh, state, symmetry.mesh);
  if (!of_mesh)
    throw std::invalid_argument(
        fmt::format("[surface] symmetry = \"{}\": the triangles have not this symmetry", symbol));
  if (!symmetry.kept.is_trivial()) {
    const auto kept = surface3d::symmetry_of(mesh, state, symmetry.kept);
    const double off = kept ? difference(state, surface3d::symmetric_part(*kept, state)) : 1;
    if (!(off <= 1e-6))
      throw std::invalid_argument(fmt::format(
          "[surface] keep_symmetry = \"{}\": the start has not this symmetry, it is off by {:.2g}; "
          "give a smaller one, or C1 to let the start lose it",
          symmetry.kept.symbol(), off));
  }
  return fmt::format(
      "the triangles have the symmetry {}, from which the start is off by {:.1e}; {}", symbol,
      surface3d::asymmetry(mesh, state, *of_mesh),
      symmetry.kept.is_trivial() ? "it is not kept" : "each step keeps " + symmetry.kept.symbol());
}

// Where it is not the number that was asked for, of triangles into which those of a symmetric body are divided.
std::optional<std::string> remark_on_count(const RunInput& input, int made) {
  if (std::holds_alternative<MeshFileStart>(input.start)
      || std::holds_alternative<FrameStart>(input.start))
    return {};
  const int body = meshing::body_with(input.symmetry.mesh).triangle_count();
  const auto divided = [body](double n) { return body * int(n * n); };
  if (made == input.triangles || made != divided(std::round(std::sqrt(double(made) / body))))
    return {};
  const double below = std::max(1., std::floor(std::sqrt(double(input.triangles) / body)));
  return fmt::format(
      "{} triangles, not {}: with symmetry = \"{}\" their number is {} n², near that {} or {}",
      made, input.triangles, input.symmetry.mesh.symbol(), body, divided(below),
      divided(below + 1));
}

// Of a start that may lose what its triangles have not.
std::optional<std::string> remark_on_lack(const surface3d::Triangulation& mesh,
                                          const surface3d::State& state) {
  const std::string symbol = surface3d::symmetry_class(mesh, state);
  if (symbol == "C1" || symbol.ends_with("oov") || symbol.ends_with("ooh")) return {};
  return fmt::format(
      "the start has the symmetry {0}, its triangles have not, which decides when a shape that is "
      "unstable loses it; symmetry = \"{0}\" in [surface] gives it triangles that have it",
      symbol);
}

// A frame goes on as it is; what has the area already, its own or that of its lipids at full order, keeps its bits.
void scale_to_unit(const model::Material& material, Start& start) {
  const double area = meshing::area(start.mesh);
  double unit = area, rounding = 1e-14;
  if (material.has_lipid_density() && start.beta.size() > 0) {
    const surface3d::Triangulation mesh(start.mesh);
    unit = surface3d::lipids_and_volume(mesh, material, {start.mesh.nodes, start.beta}).area;
    rounding = 1e-10;  // of a quadrature
  }
  if (std::abs(unit / unit_area - 1) > rounding)
    meshing::scale_to_area(start.mesh, area / unit * unit_area);
}

}  // namespace

RunStart start_of(const RunInput& input) {
  Start start;
  try {
    start = std::visit([&](const auto& shape) { return make(shape, input); }, input.start);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[surface] {}", error.what()));
  }
  try {
    if (!input.perturbation.empty()) perturb(start.mesh, input.perturbation);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[surface] perturbation: {}", error.what()));
  }
  const bool free_order = model::has_free_order(input.model);
  const model::Material material =
      free_order ? input.material : input.material.with_uniform_order();
  scale_to_unit(material, start);
  const auto mesh = std::make_shared<const surface3d::Triangulation>(start.mesh);
  if (start.beta.size() == 0) start.beta = first_order(input, *mesh, start.mesh.nodes);
  const surface3d::State brought{start.mesh.nodes, start.beta};
  surface3d::State state = brought;
  if (!free_order) state.beta.setConstant(model::full_order);
  if (const auto origin = origin_of_any(input.start)) {
    const auto energies = [&]() -> StartEnergies {
      return {energy_of(*mesh, origin->physics->material, brought),
              energy_of(*mesh, input.material, state)};
    };
    if (const auto remark = remark_on(*origin, input, energies)) start.remarks.push_back(*remark);
  }
  if (!input.symmetry.mesh.is_trivial()) {
    start.remarks.push_back(remark_on_symmetry(*mesh, state, input.symmetry));
    if (const auto remark = remark_on_count(input, mesh->count())) start.remarks.push_back(*remark);
  } else if (std::holds_alternative<HarmonicSphere>(input.start)) {
    if (const auto remark = remark_on_lack(*mesh, state)) start.remarks.push_back(*remark);
  }
  return {{.mesh = mesh,
           .state = state,
           .target = surface3d::lipids_and_volume(*mesh, material, state),
           .symmetry = input.symmetry},
          start.remarks};
}

RunCost cost_of(const RunInput& input, int triangles) {
  const int nodes = 9 * triangles / 2 + 2, quadratic_nodes = 2 * triangles + 2;
  const int unknowns = unknowns_of(input, nodes, quadratic_nodes);
  const surface3d::Numerics& numerics = input.numerics;
  using surface3d::Integrator;
  const double steps = numerics.integrator == Integrator::step_doubling ? 2.6
                     : numerics.integrator == Integrator::variational   ? 5
                                                                        : 1,
               factors = numerics.factorisation == surface3d::Factorisation::every_step ? 2.2 : 1;
  const double linear = 4.1e-6 * unknowns * std::pow(unknowns / 6400., 0.15), rest = 5e-6 * nodes;
  return {.unknowns = unknowns,
          .seconds_per_step = steps * factors * (linear + rest),
          .megabytes = 40 + 0.011 * unknowns,
          .frame_megabytes = 3.1e-4 * nodes};
}

}  // namespace sbeh::studies

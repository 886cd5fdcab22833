#include "studies/modes/mode_file.h"

#include "axisym/curve.h"
#include "meshing/curvature.h"
#include "meshing/revolution.h"
#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/parameters/physics_numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

namespace {

constexpr int fewest_triangles_of_file = 320, most_triangles_of_file = 5120;

// Names of the field data.
constexpr const char *of_mode = "mode", *of_r = "profile_r", *of_z = "profile_z",
                     *of_order = "profile_order", *of_u = "profile_displacement",
                     *of_b = "profile_order_change";

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw InputError(fmt::format("{}: is no mode of sbeh modes: {}", path.string(), what));
}

const Eigen::VectorXd& part(const Globals& globals, const char* name,
                            const std::filesystem::path& path) {
  const auto found = globals.find(name);
  if (found == globals.end()) fail(path, fmt::format("it lacks the field {}", name));
  return found->second;
}

}  // namespace

std::string stem(const ModeKey& key) {
  return fmt::format("m{}_{}_{}", key.m, name(key.parity), key.number);
}

void normalise(axisym::Field& u, axisym::Field& b) {
  constexpr double alone = 1e-6;       // of the order alone: it has no displacement to go by
  constexpr double nearly = 1 - 1e-6;  // equal ones, as on either side of the equator
  const double of_u = u.cwiseAbs().maxCoeff(), of_b = b.cwiseAbs().maxCoeff();
  const axisym::Field& measured = of_u > alone * of_b ? u : b;
  const double largest = std::max(of_u > alone * of_b ? of_u : of_b, 1e-300);
  Eigen::Index at = 0;
  while (std::abs(measured[at]) < nearly * largest && at + 1 < measured.size()) ++at;
  const double factor = 1 / std::copysign(largest, measured[at]);
  u *= factor;
  b *= factor;
}

RevolvedMode revolved(const StateMode& mode, const meshing::Resolution& resolution) {
  meshing::RevolvedMesh made = meshing::revolved(mode.state, resolution);
  RevolvedMode result{.mesh = std::move(made.mesh),
                      .beta = std::move(made.beta),
                      .along_normal = {},
                      .displacement = {},
                      .order_change = {}};
  // Along the node normals, as the solver displaces the curve.
  const axisym::Nodes& X = mode.state.X;
  const axisym::Nodes n = axisym::node_normals(X);
  const auto field = [&](const Eigen::VectorXd& values) {
    return meshing::ProfileCurve({X, values});
  };
  const auto along = field(mode.u), ordering = field(mode.b),
             outward = field(mode.u.cwiseProduct(n.row(0).transpose())),
             upward = field(mode.u.cwiseProduct(n.row(1).transpose()));
  const Eigen::Index nodes = result.mesh.nodes.cols();
  result.displacement.resize(3, nodes);
  result.along_normal.resize(nodes);
  result.order_change.resize(nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const Eigen::Vector3d x = result.mesh.nodes.col(i);
    const double r = std::hypot(x[0], x[1]), phi = std::atan2(x[1], x[0]);
    const double t = along.nearest({r, x[2]}), wave = std::cos(mode.key.m * phi);
    const double across = wave * outward.beta_at(t);
    result.displacement.col(i) << across * std::cos(phi), across * std::sin(phi),
        wave * upward.beta_at(t);
    result.along_normal[i] = wave * along.beta_at(t);
    result.order_change[i] = wave * ordering.beta_at(t);
  }
  return result;
}

namespace {

// With more triangles, smaller ones at narrow necks and sharp rims, where few cannot bend as it does.
RevolvedMode revolved_for_file(const StateMode& mode) {
  meshing::Resolution resolution{.triangles = fewest_triangles_of_file};
  for (; resolution.triangles <= most_triangles_of_file; resolution.triangles *= 4) try {
      return revolved(mode, resolution);
    } catch (const std::invalid_argument&) {
      ++resolution.grading;
    }
  throw std::invalid_argument(
      fmt::format("no {} triangles bend as sharply as the shape", most_triangles_of_file));
}

}  // namespace

void write_mode(const std::filesystem::path& path, const StateMode& mode) {
  const RevolvedMode surface = revolved_for_file(mode);
  const NodeFields at_nodes{
      {"order", surface.beta.transpose()},
      {"mean_curvature", meshing::node_mean_curvature(surface.mesh).transpose()},
      {"displacement", surface.displacement},
      {"order_change", surface.order_change.transpose()}};
  Globals globals{{of_mode, (Eigen::VectorXd(5) << mode.key.m, int(mode.key.parity),
                             mode.key.number, mode.eigenvalue, mode.rate)
                                .finished()},
                  {of_r, mode.state.X.row(0)},
                  {of_z, mode.state.X.row(1)},
                  {of_order, mode.state.beta},
                  {of_u, mode.u},
                  {of_b, mode.b}};
  write_physics(mode, globals);
  write_file(path, vtu_text(surface.mesh, at_nodes, globals));
}

StateMode read_mode(const std::filesystem::path& path) {
  const auto file = read_curved_mesh(path);
  if (!file) fail(path, "it has plain triangles");
  const Globals& globals = file->globals;
  const Eigen::VectorXd &key = part(globals, of_mode, path), &r = part(globals, of_r, path),
                        &z = part(globals, of_z, path), &order = part(globals, of_order, path),
                        &u = part(globals, of_u, path), &b = part(globals, of_b, path);
  constexpr auto parities = values_of(axisym::Parity{});
  if (key.size() != 5 || !(key[1] >= 0 && key[1] < double(parities.size())))
    fail(path, fmt::format("its field {} is damaged", of_mode));
  for (const Eigen::VectorXd* field : {&z, &order, &u, &b})
    if (field->size() != r.size()) fail(path, "its profile is damaged");
  const auto physics = physics_in(globals, path.string());
  if (!physics) fail(path, "it does not say with what it was computed");
  StateMode mode;
  static_cast<Physics&>(mode) = *physics;
  mode.state = {axisym::Nodes(2, r.size()), order};
  mode.state.X << r.transpose(), z.transpose();
  mode.key = {int(key[0]), parities.at(std::size_t(key[1])), int(key[2])};
  mode.eigenvalue = key[3];
  mode.rate = key[4];
  mode.u = u;
  mode.b = b;
  return mode;
}

}  // namespace sbeh::studies

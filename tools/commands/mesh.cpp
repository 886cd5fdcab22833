// `sbeh mesh`: a shape becomes a curved mesh in a file, a report, or both.
#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/mesh/make_mesh.h"
#include "studies/report/path_kind.h"
#include "studies/scan/scan_row.h"
#include "tools/commands/commands.h"
#include "tools/commands/mesh_output.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

namespace sbeh::tools {

namespace fs = std::filesystem;
using studies::InputError;

namespace {

struct MeshWords {
  CLI::App *sphere = nullptr, *ellipsoid = nullptr, *harmonic = nullptr, *revolve = nullptr,
           *file = nullptr;
  std::string axes, input, area, symmetry;
  MeshOutput output;
  std::vector<std::string> modes;
  std::optional<double> reduced_volume;
  std::optional<int> triangles, order;
  double grading = 0;
  bool prolate = false, repair = false;
};

// Three numbers between commas.
std::array<double, 3> three_numbers(const char* option, const std::string& text,
                                    const char* meaning) {
  const auto fields = studies::split_csv(text);
  std::array<double, 3> numbers{};
  bool ok = fields.size() == 3;
  for (std::size_t k = 0; ok && k < 3; ++k)
    ok = studies::parse_number(fields[k], numbers[k]) && std::isfinite(numbers[k]);
  if (!ok) throw InputError(fmt::format("{} {}: must be {}", option, text, meaning));
  return numbers;
}

meshing::Harmonic harmonic_of(const std::string& text) {
  constexpr int highest = 100;
  const auto [l, m, amplitude] =
      three_numbers("--mode", text, "degree, order, amplitude, as in 5,3,0.5");
  if (l != std::floor(l) || m != std::floor(m) || l < 0 || l > highest || std::abs(m) > l)
    throw InputError(fmt::format(
        "--mode {}: degree and order must be integers, 0 <= l <= {}, -l <= m <= l", text, highest));
  return {int(l), int(m), amplitude};
}

double area_of(const std::string& text) {
  double area = 4 * std::numbers::pi;
  if (text != "4pi" && !studies::parse_number(text, area))
    throw InputError(fmt::format("--area {}: must be a number > 0, or 4pi", text));
  return area;
}

meshing::PointGroup symmetry_of(const std::string& symbol) {
  try {
    return meshing::PointGroup(symbol);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("--symmetry {}: {}", symbol, error.what()));
  }
}

studies::MeshRequest request_of(const MeshWords& w) {
  studies::MeshRequest request{.shape = studies::SphereShape{},
                               .triangles = w.triangles,
                               .order = w.order,
                               .grading = w.grading,
                               .reduced_volume = w.reduced_volume};
  if (!w.area.empty()) request.area = area_of(w.area);
  if (!w.symmetry.empty()) request.symmetry = symmetry_of(w.symmetry);
  if (*w.ellipsoid) {
    studies::EllipsoidShape ellipsoid{.semi_axes = {}, .prolate = w.prolate};
    if (!w.axes.empty()) {
      const auto a = three_numbers("--axes", w.axes, "three lengths > 0, as in 1,1,0.5");
      ellipsoid.semi_axes = Eigen::Vector3d(a[0], a[1], a[2]);
    }
    request.shape = ellipsoid;
  }
  if (*w.harmonic) {
    studies::HarmonicShape shape;
    for (const std::string& mode : w.modes) shape.modes.push_back(harmonic_of(mode));
    request.shape = shape;
  }
  if (*w.revolve) request.shape = studies::ProfileShape{w.input};
  if (*w.file) request.shape = studies::FileShape{w.input, w.repair};
  return request;
}

studies::MadeMesh make(const MeshWords& w, const studies::MeshRequest& request) {
  try {
    return studies::make_mesh(request);
  } catch (const std::runtime_error&) {  // of a mesh or of a table
    if (*w.revolve) studies::refuse_other_kind(w.input, "mesh revolve");
    if (*w.file) studies::refuse_other_kind(w.input, "mesh file");
    throw;
  }
}

int make_and_write(const MeshWords& w) {
  require_place(w.output, "mesh");
  const studies::MeshRequest request = request_of(w);
  const studies::MadeMesh made = make(w, request);
  if (*w.revolve)
    if (const auto remark = studies::remark_on_profile(w.input)) complain(*remark);
  put(made, request, w.output);
  return 0;
}

}  // namespace

Command add_mesh(CLI::App& program) {
  const auto words = std::make_shared<MeshWords>();
  MeshWords& w = *words;
  CLI::App* mesh =
      program.add_subcommand("mesh", "a curved mesh of a shape: mesh SHAPE ... -o FILE");
  mesh->require_subcommand(1);
  const auto add = [&](const char* name, const char* text) {
    CLI::App* shape = mesh->add_subcommand(name, text);
    add_mesh_output(*shape, w.output);
    shape->add_option("--triangles", w.triangles, "about so many (1280)");
    shape->add_option("--order", w.order, "of the curved triangles, 1 ... 3 (3)");
    shape->add_option("--grading", w.grading, "smaller triangles where |H| is large, 0 ... 10 (0)");
    shape->add_option("--area", w.area, "scale to this area, a number or 4pi");
    shape->add_option(
        "--reduced-volume", w.reduced_volume,
        "exactly this one: chooses the ellipsoid, scales harmonics, moves other surfaces a little");
    return shape;
  };
  w.sphere = add("sphere", "the unit sphere");
  w.ellipsoid = add("ellipsoid", "of given semi-axes, or of given reduced volume and area 4pi");
  w.ellipsoid->add_option("--axes", w.axes, "semi-axes along x,y,z, as in 1,1,0.5");
  w.ellipsoid->add_flag("--prolate", w.prolate, "long along z instead of flat");
  w.harmonic = add("harmonic", "r = 1 + sum of a Y_lm, real and orthonormal");
  w.harmonic->add_option("--mode", w.modes, "l,m,a, as in 5,3,0.5; may be repeated")
      ->required()
      ->allow_extra_args(false);
  w.revolve = add("revolve", "a profile from a scan, revolved, with its order");
  w.revolve->add_option("PROFILE", w.input, "table of nodes (points/*.csv)")->required();
  for (CLI::App* shape : {w.sphere, w.ellipsoid, w.harmonic, w.revolve})
    shape->add_option(
        "--symmetry", w.symmetry,
        "triangles with this point group about z, which the shape must have: D3h, say");
  w.file = add("file", "triangles of a file, curved; without --triangles they stay as they are");
  w.file->add_option("FILE", w.input, ".obj, .off, .ply, .stl, .msh, .tsi, .vtk, .vtp or .vtu")
      ->required();
  w.file->add_flag("--repair", w.repair, "mend what can be mended safely, and say what was done");
  return {mesh, [words] { return make_and_write(*words); }};
}

}  // namespace sbeh::tools

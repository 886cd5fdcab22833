#include "tools/commands/self_test.h"

#include "meshing/shapes.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/scan/branch_points.h"
#include "surface3d/diagnostics.h"
#include "tools/commands/command.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace sbeh::tools {

namespace fs = std::filesystem;
using std::numbers::pi;

namespace {

bool say(bool is_well, const std::string& what) {
  fmt::print("{:4} {}\n", is_well ? "ok" : "BAD", what);
  return is_well;
}

bool is_near(const std::string& what, double value, double expected, double tolerance) {
  return say(
      std::abs(value - expected) <= tolerance,
      fmt::format("{} = {:.10g} (to be {:.10g} within {:g})", what, value, expected, tolerance));
}

// Uniformly ordered surfaces of 320 triangles.
bool surfaces_are_well() {
  const auto measures = [](const meshing::CurvedMesh& mesh, const model::Material& material) {
    return surface3d::diagnose(
        surface3d::Triangulation(mesh), material,
        {mesh.nodes, surface3d::Field::Constant(mesh.nodes.cols(), model::full_order)});
  };
  const meshing::Resolution resolution{.triangles = 320};
  const model::Material material;
  const double kappa = material.kappa(model::full_order);
  const auto sphere = measures(meshing::sphere(resolution), material.without_gaussian());
  const auto oblate = measures(meshing::ellipsoid(0.8, false, resolution), material);
  const bool energy = is_near("3D: energy F/(8 pi kappa) of the sphere",
                              sphere.energy.bending / (8 * pi * kappa), 1, 1e-5);
  return is_near("3D: Gauss-Bonnet on an oblate, its total curvature/(4 pi)",
                 oblate.total_gauss_curvature / (4 * pi), 1, 1e-3)
      && energy;
}

// Seifert's oblate: the energy by shooting and by minimisation.
bool scan_point_is_well() {
  constexpr double known = -10.172379928;
  const auto point = studies::branch_point({.model = model::Model::SSH,
                                            .branch = axisym::Branch::oblate,
                                            .reduced_volume = 0.8,
                                            .material = model::Material{}.with_L(0.05)});
  return is_near("axisymmetric: energy of the oblate with V_r = 0.8, L = 0.05",
                 point.row.diagnostics ? point.row.diagnostics->energy.total() : NAN, known, 1e-8);
}

// The bytes with which every PNG begins.
bool is_png(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(8, ' ');
  return in.read(head.data(), 8) && head == "\x89PNG\r\n\x1a\n";
}

bool pictures_are_well() {
  std::string folder = (fs::temp_directory_path() / "sbeh-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
    return say(false, fmt::format("pictures: no folder in {}", fs::temp_directory_path().string()));
  const fs::path mesh = fs::path(folder) / "mesh.vtu";
  studies::write_mesh(mesh, meshing::ellipsoid(0.8, false, {.triangles = 80}), {});
  const bool drawn = draw({"mesh", mesh.string(), "--format", "png"}) == 0
                  && is_png(fs::path(mesh).replace_extension(".png"));
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return say(drawn, "pictures are drawn (this one is away again)");
}

}  // namespace

int self_test() {
  bool is_well = true;
  for (const auto part : {surfaces_are_well, scan_point_is_well, pictures_are_well})
    is_well = part() && is_well;
  fmt::print("{}\n", is_well ? "all is well" : "something is not as it should be, see above");
  return is_well ? 0 : 1;
}

}  // namespace sbeh::tools

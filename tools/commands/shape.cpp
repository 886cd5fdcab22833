// `sbeh shape`: a vesicle at rest as a mesh, in one line.
#include "studies/io/errors.h"
#include "studies/scan/branch_points.h"
#include "tools/commands/commands.h"
#include "tools/commands/mesh_output.h"

#include <numbers>

namespace sbeh::tools {

namespace {

struct ShapeWords {
  double reduced_volume = 0, radius = 1, L = 0.05, spontaneous_curvature = 0;
  std::string branch = "oblate", model = "SSH";
  int triangles = 1280, order = 3;
  MeshOutput output;
};

axisym::StationaryState state_of(const ShapeWords& w) {
  const axisym::StationaryCase of{.model = *value_named<model::Model>(w.model),
                                  .branch = *value_named<axisym::Branch>(w.branch),
                                  .reduced_volume = w.reduced_volume,
                                  .material = [&] {
                                    model::Material material = model::Material{}.with_L(w.L);
                                    material.spontaneous_curvature =
                                        w.spontaneous_curvature * w.radius;
                                    return material;
                                  }()};
  of.material.validate();
  const studies::PointOutcome point = studies::branch_point(of);
  if (point.row.status != studies::PointStatus::stationary)
    throw studies::InputError(
        fmt::format("shape: {} {} with a reduced volume of {}: there is none: {}", w.model,
                    w.branch, w.reduced_volume, point.row.stop_reason));
  return *point.state;
}

int shape(const ShapeWords& w) {
  require_place(w.output, "shape");
  const double area = 4 * std::numbers::pi * w.radius * w.radius;
  const studies::MeshRequest request{.shape = studies::StateShape{state_of(w)},
                                     .triangles = w.triangles,
                                     .order = w.order,
                                     .area = area,
                                     .reduced_volume = w.reduced_volume};
  put(studies::make_mesh(request), request, w.output);
  return 0;
}

std::vector<std::string> words_of(const auto& values) {
  std::vector<std::string> words;
  words.reserve(std::size(values));
  for (const auto value : values) words.emplace_back(sbeh::name(value));
  return words;
}

}  // namespace

Command add_shape(CLI::App& program) {
  const auto words = std::make_shared<ShapeWords>();
  ShapeWords& w = *words;
  CLI::App* app = program.add_subcommand(
      "shape",
      "a vesicle at rest as a mesh, as in: shape --reduced-volume 0.64 --radius 3.9 -o rbc.stl");
  const CLI::Range positive(std::numeric_limits<double>::min(), 1e12);
  app->add_option("--reduced-volume", w.reduced_volume, "of the shape, 0 < V_r <= 1")
      ->required()
      ->check(CLI::Range(1e-3, 1.0));
  app->add_option("--radius", w.radius, "of the sphere of equal area, in your unit of length (1)")
      ->check(positive);
  app->add_option("--branch", w.branch,
                  "oblate (biconcave discs too), prolate, stomatocyte (oblate)")
      ->check(CLI::IsMember(words_of(axisym::classical_branches)));
  app->add_option("--model", w.model, "SSH: the classical shape; SBEH: with free order (SSH)")
      ->check(CLI::IsMember({"SSH", "SBEH"}));
  app->add_option("--L", w.L, "elastic constant of SBEH (0.05)")->check(positive);
  app->add_option("--spontaneous-curvature", w.spontaneous_curvature,
                  "H0, per your unit of length, of the sign of the trace H: a sphere has -2/R (0)");
  app->add_option("--triangles", w.triangles, "about so many (1280)");
  app->add_option("--order", w.order, "of the curved triangles, 1 ... 3 (3)");
  add_mesh_output(*app, w.output);
  return {app, [words] { return shape(*words); }};
}

}  // namespace sbeh::tools

#include "studies/figures/plan.h"

#include "studies/io/errors.h"

#include <fmt/format.h>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;
using model::Model;

namespace {

void require(bool holds, const fs::path& file, const char* what) {
  if (!holds) throw InputError(fmt::format("{}: {}", file.string(), what));
}

}  // namespace

int number(Figure figure) { return int(figure) + 1; }

std::optional<Figure> figure_of(std::string_view word) {
  for (const Figure figure : values_of(Figure{}))
    if (word == name(figure) || word == std::to_string(number(figure))) return figure;
  return {};
}

Inputs read_inputs(const fs::path& folder, std::optional<int> triangles) {
  if (!fs::is_directory(folder))
    throw InputError(
        fmt::format("{}: no such folder: the figures' inputs are in the folder studies of the "
                    "sources, give its place by --inputs",
                    folder.string()));
  const fs::path scan = folder / "paper_flow.toml", oblate = folder / "paper_oblate_3d.toml",
                 sbeh = folder / "y53_ordered.toml", ssh = folder / "y53.toml";
  Inputs inputs{read_scan(scan), read_run(oblate), read_run(sbeh), read_run(ssh)};
  require(inputs.oblates.method == Method::flow && inputs.oblates.models.size() == 2
              && inputs.oblates.branches == std::vector<axisym::Branch>{axisym::Branch::oblate},
          scan, "must be a scan of the oblates of both models with method = \"flow\"");
  const auto* ellipsoid = std::get_if<Ellipsoid>(&inputs.oblate_3d.start);
  require(ellipsoid && ellipsoid->reduced_volume, oblate,
          "must start from an ellipsoid of a reduced volume");
  require(inputs.sbeh.model == Model::SBEH, sbeh, "must have model = \"SBEH\"");
  require(inputs.ssh.model == Model::SSH, ssh, "must have model = \"SSH\"");
  inputs.ssh.material.residual_stiffness = inputs.sbeh.material.residual_stiffness;
  if (triangles)
    for (RunInput* input : {&inputs.oblate_3d, &inputs.sbeh, &inputs.ssh})
      input->triangles = *triangles;
  return inputs;
}

bool needs_scan(Figure figure) { return figure == Figure::energy || figure == Figure::shapes; }

PlannedRun oblate_run(const Inputs& inputs, const PointKey& key) {
  PlannedRun run{fmt::format("oblates_3d/{}_v{:.6g}_L{:.6g}", sbeh::name(key.model),
                             key.reduced_volume, key.L),
                 inputs.oblate_3d};
  run.input.model = key.model;
  run.input.material = run.input.material.with_L1(key.L);
  std::get<Ellipsoid>(run.input.start).reduced_volume = key.reduced_volume;
  return run;
}

PlannedRun evolution_run(const Inputs& inputs, Model model) {
  return {fmt::format("evolution/{}", sbeh::name(model)),
          model == Model::SBEH ? inputs.sbeh : inputs.ssh};
}

bool needs_run(Figure figure, const PointKey& key) {
  if (figure == Figure::energy)
    return (key.reduced_volume == 0.7 || key.reduced_volume == 0.8) && key.L == 0.05;
  return figure == Figure::shapes && key.model == Model::SBEH;
}

std::vector<PlannedRun> runs_for(Figure figure, const Inputs& inputs) {
  std::vector<PlannedRun> runs;
  for (const PointKey& key : points_of(inputs.oblates))
    if (needs_run(figure, key)) runs.push_back(oblate_run(inputs, key));
  if (figure == Figure::evolution || figure == Figure::measures)
    for (const Model model : {Model::SBEH, Model::SSH})
      runs.push_back(evolution_run(inputs, model));
  return runs;
}

}  // namespace sbeh::studies::figures

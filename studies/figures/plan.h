// The paper's figures 1 to 4: what each of them is drawn from.
#pragma once

#include "model/names.h"
#include "studies/evolution/run_input.h"
#include "studies/scan/scan_input.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies::figures {

enum class Figure {
  energy,     ///< 1: energy over time of the oblates
  shapes,     ///< 2: stationary oblates with their order, and cuts through them
  evolution,  ///< 3: shapes from the perturbed sphere on
  measures    ///< 4: energy, W₂ and spread of the order over time in these runs
};
constexpr auto names(Figure) { return std::array{"energy", "shapes", "evolution", "measures"}; }
/// As in the paper: 1 … 4.
int number(Figure figure);
/// By name or number; empty for another word.
std::optional<Figure> figure_of(std::string_view word);

/// The inputs of all figures, from these files of one folder.
struct Inputs {
  ScanInput oblates;   ///< paper_flow.toml: axisymmetric, in time
  RunInput oblate_3d;  ///< paper_oblate_3d.toml; each point of the scan gives it its V_r and L
  RunInput sbeh, ssh;  ///< y53_ordered.toml; y53.toml with the same residual stiffness
};

/// `triangles`, where given, replaces those of the 3D inputs. Throws InputError.
Inputs read_inputs(const std::filesystem::path& folder, std::optional<int> triangles);

/// The scan's place in the folder of the figures.
inline constexpr const char* scan_folder = "oblates";
bool needs_scan(Figure figure);

/// A 3D run and its place in the folder of the figures.
struct PlannedRun {
  std::string folder;
  RunInput input;
};
PlannedRun oblate_run(const Inputs& inputs, const PointKey& key);
PlannedRun evolution_run(const Inputs& inputs, model::Model model);

/// Whether a figure is not complete without the 3D run of a point of the scan. The energies are asked for at
/// two reduced volumes and L only; of others they are shown where there are runs.
bool needs_run(Figure figure, const PointKey& key);
/// The 3D runs without which a figure is not complete.
std::vector<PlannedRun> runs_for(Figure figure, const Inputs& inputs);

/// The instants of figure 3. The paper names 0.6, 2.1 and 2.4 among its ten.
inline constexpr std::array instants{0.0, 0.02, 0.1, 0.3, 0.6, 1.2, 2.1, 2.4, 4.0, 10.0};

}  // namespace sbeh::studies::figures

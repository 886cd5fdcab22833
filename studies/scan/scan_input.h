// What a scan is asked for: stationary shapes over a grid of reduced volumes and elastic constants.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/options.h"
#include "model/material.h"
#include "model/names.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// How a scan finds its stationary states.
enum class Method {
  newton,  ///< Newton's method and continuation from point to point
  flow     ///< the equations of motion in time, from an ellipsoid
};
constexpr auto names(Method) { return std::array{"newton", "flow"}; }

/// The input of a scan: table [scan], optional [material] and [numerics], all keys as the members.
/// The points are all combinations of reduced_volume, L, models and branches, a million at most.
struct ScanInput {
  std::vector<double> reduced_volume;  ///< V_r, each in 0 < V_r <= 1; ascending
  std::vector<double> L;               ///< one-constant elastic constants, each > 0; ascending
  std::vector<model::Model> models{model::Model::SBEH, model::Model::SSH};
  std::vector<axisym::Branch> branches{axisym::Branch::oblate};
  Method method = Method::newton;
  bool beyond_fold =
      false;  ///< also the saddles and sharp rims of SBEH's oblates; method newton, two
              ///< seconds per reduced volume with a fold
  model::Material material;  ///< its L1, L2, L3 give way to L of the point: material.with_L(L)
  axisym::Numerics numerics;
  double flow_end_time = 200;  ///< method flow, key `end_time`: a run that is not at rest ends here

  bool operator==(const ScanInput&) const = default;
};

std::size_t point_count(const ScanInput& input);

/// Throws InputError.
ScanInput read_scan(const std::filesystem::path& path);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const ScanInput& input, std::string_view version);

}  // namespace sbeh::studies

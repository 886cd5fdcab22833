// What a scan is asked for: stationary shapes over a grid of reduced volumes and elastic constants.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "model/names.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"
#include "studies/parameters/units.h"
#include "studies/states/initial_order.h"

#include <array>
#include <filesystem>
#include <optional>
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

/// Stationary states: all combinations of reduced_volume, L, models and branches.
struct StateGrid {
  std::vector<double> reduced_volume;  ///< V_r, each in 0 < V_r <= 1; ascending
  std::vector<double> L;               ///< L1, each > 0; ascending
  std::vector<model::Model> models{model::Model::SBEH, model::Model::SSH};
  std::vector<axisym::Branch> branches{axisym::Branch::oblate};
  model::Material material;  ///< its L1, L2, L3 give way to L of the point: material.with_L1(L)
  axisym::Numerics numerics;
  int interfaces = 0;  ///< of the states, see StationaryCase

  bool has(model::Model model) const;

  bool operator==(const StateGrid&) const = default;
};

/// Which state of a grid; ordered as finished tables are.
struct PointKey {
  double reduced_volume = 0;  ///< 0 < V_r <= 1
  double L = 0;               ///< > 0
  model::Model model = model::Model::SBEH;
  axisym::Branch branch = axisym::Branch::oblate;
  auto operator<=>(const PointKey&) const = default;  // NOLINT(modernize-use-nullptr): false alarm
};
/// Name of the point's files without ending, such as SBEH_oblate_v0.6_L0.07.
std::string stem(const PointKey& key);
/// One of its files in a scan's folder: the profile with ".csv".
std::filesystem::path point_file(const std::filesystem::path& folder, const PointKey& key,
                                 std::string_view ending);
/// All of a grid, in order.
std::vector<PointKey> points_of(const StateGrid& grid);
axisym::StationaryCase case_of(const StateGrid& grid, const PointKey& key);

/// The keys reduced_volume, L, models and branches, of which `branches` are allowed. Throws InputError.
void read_grid(const TomlTable& table, StateGrid& grid,
               const std::vector<axisym::Branch>& branches);
void write_grid(TomlText& toml, const StateGrid& grid);

/// Values of a number of [material], by the name of a MaterialNumber.
struct ScanAxis {
  std::string parameter;
  std::vector<double> values;

  bool operator==(const ScanAxis&) const = default;
};

/// The input of a scan: table [scan], optional [material] and [numerics], all keys as the members.
/// A million points at most.
struct ScanInput : StateGrid {
  /// Beside reduced_volume and L, which may stand among them; see scan_stack.h.
  std::vector<ScanAxis> axes;
  /// Keys `domains`, `domain_width`, `order_formula`: the order of the spheroid from which each branch begins, at the highest
  /// reduced volume and the least L; `interfaces` are those that it has. For a conserved order, SBEH and method newton.
  OrderPattern start_order;
  Method method = Method::newton;
  /// further.csv has the other states of each branch with at most so many negative directions; none without it. See traced_states.h.
  std::optional<int> further{};
  bool beyond_fold =
      false;  ///< also the saddles and sharp rims of SBEH's oblates; method newton, two
              ///< seconds per reduced volume with a fold
  /// Stability in 3D: the eigenvalues of u cos mφ are computed up to this m; 0: none.
  int modes = 4;
  double flow_end_time = 200;  ///< method flow, key `end_time`: a run that is not at rest ends here
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const ScanInput&) const = default;
};

std::size_t point_count(const ScanInput& input);

/// Throws InputError.
ScanInput read_scan(const std::filesystem::path& path);
/// The same of a file that was read already.
ScanInput scan_in(const TomlTable& file);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const ScanInput& input, std::string_view version);

}  // namespace sbeh::studies

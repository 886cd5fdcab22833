// Which rest states in 3D are asked for.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "meshing/point_group.h"
#include "meshing/spherical_harmonics.h"
#include "studies/parameters/units.h"
#include "studies/scan/scan_row.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

inline constexpr int most_eigenpairs = 50;

/// From where Newton's method starts.
enum class StatesStart {
  branch,  ///< the axisymmetric state, revolved
  scan,    ///< the same, out of the folder of a scan
  frame,   ///< of a 3D run, or of such states
  mesh     ///< a surface alone, of full order
};
constexpr auto names(StatesStart) { return std::array{"branch", "scan", "frame", "mesh"}; }

inline constexpr const char* followed_volume = "reduced_volume";

/// Table [follow]: the branch of the one state.
struct FollowInput {
  std::string parameter = followed_volume;  ///< what changes, this or the name of a MaterialNumber
  double to = 0;                            ///< where it ends, on either side of where it starts
  bool switches = true;                     ///< key `switch`: on to the branches that leave, too
  double longest_step =
      0.1;  ///< of the way, or in root mean square of displacement and order, 0 < … <= 1
  int most_states = 60;   ///< of each branch, 2 … 1000
  int most_negative = 8;  ///< negative directions with which a branch is gone on, 0 … 100

  bool operator==(const FollowInput&) const = default;
};

/// Table [search]: states that no branch leads to, from the one state.
struct SearchInput {
  int most_states = 12;  ///< the first one included, 2 … 1000
  double reach =
      0.4;  ///< largest displacement or change of order along a mode, in radii, 0 < … <= 1

  bool operator==(const SearchInput&) const = default;
};

/// Table [states], all keys as the members; optional [follow] or [search], [material] (without L), [numerics] (of the axisymmetric states) and
/// [units]. A scan's material, and what a frame was computed with, stand for what the file does not say.
struct StatesInput {
  model::Model model = model::Model::SBEH;  ///< SBEH or SSH
  StatesStart start =
      StatesStart::branch;  ///< by the one of the keys branch, frame, mesh, scan that is there
  axisym::Branch branch = axisym::Branch::oblate;
  std::string file;                    ///< of scan, frame or mesh
  std::string file_in_description{};   ///< where that names it from its own folder; else as it is
  std::vector<double> reduced_volume;  ///< V_r, each in 0 < V_r < 1; ascending
  std::vector<double> L;               ///< ascending; all combinations
  std::vector<meshing::Harmonic>
      perturbation;                ///< displaces the start along the normal by Σ a_lm Y_lm
  int triangles = 320;             ///< about so many; frames and meshes bring their own
  meshing::PointGroup symmetry{};  ///< of the triangles, new ones included
  int eigenpairs = 6;              ///< lowest of the second variation, 0 … 50
  int rates = 0;                   ///< largest of the linearised flow, 0 … 50
  bool passes = false;             ///< to which states those with one negative direction lead
  model::Material material;        ///< its L1 gives way to L
  axisym::Numerics numerics;
  std::optional<FollowInput> follow{};
  std::optional<SearchInput> search{};
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const StatesInput&) const = default;
};

/// Whether its triangles are those of a file.
bool brings_its_mesh(StatesStart start);

/// The material with the default L1, as StatesInput has it.
model::Material without_L(model::Material material);

struct StatePlace {
  int number;
  axisym::PlanePoint at;
};
/// By L, then by V_r, numbered from 1.
std::vector<StatePlace> places_of(const StatesInput& input);

/// The parameter's value at the one place of an input.
double value_of(const StatesInput& input, const std::string& parameter);
/// The input at this value, in place of its own.
StatesInput at_value(StatesInput input, const std::string& parameter, double value);

/// Of the scan from which a state starts.
ScanRow row_of(const StatesInput& input, const axisym::PlanePoint& at);

/// Throws InputError.
StatesInput read_states(const std::filesystem::path& path);
/// The same of a file that was read already.
StatesInput states_in(const TomlTable& file);

/// Of one core, about what was measured, within a factor of two; `triangles` as the start has them.
double seconds_of(const StatesInput& input, int triangles);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const StatesInput& input, std::string_view version);

}  // namespace sbeh::studies

// The table of rest states in 3D: a row for each.
#pragma once

#include "studies/io/columns.h"
#include "studies/rest_states/states_input.h"
#include "studies/scan/scan_table.h"
#include "surface3d/diagnostics.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// What is known of a state that Newton's method has found.
struct RestMeasures {
  surface3d::Diagnostics
      diagnostics{};                ///< its energy being that of the state: see surface3d/README.md
  std::array<double, 3> lengths{};  ///< roots of the principal moments of the surface, ascending
  double pressure = 0, tension = 0;
  int triangles = 0;
  int negative_directions = 0;  ///< in which the energy falls, rigid motions apart
  int rigid_motions = 0;        ///< 6; 5 about an axis, 3 of a sphere
  std::string symmetry{};       ///< see surface3d/stationary/symmetry_class.h
  bool self_contact = false;
  double residual =
      0;  ///< largest force and order residual per area; what keeps the surface in place included
};

/// What a state is on its path.
enum class RestPoint {
  first,      ///< of its path
  step,       ///< one of those between
  fold,       ///< where the parameter turns back
  branching,  ///< where others leave
  joins,      ///< where it ends in a state with an axis
  renewed,    ///< the one before on new triangles
  last,       ///< at the end of the range
  end         ///< to which a pass leads
};
constexpr auto names(RestPoint) {
  return std::array{"first", "step", "fold", "branching", "joins", "renewed", "last", "end"};
}

/// A row of states.csv.
struct RestRow {
  int key = 0;  ///< its number
  model::Model model = model::Model::SBEH;
  std::string start;  ///< branch, or the word of its start
  std::optional<int> path =
      1;  ///< by [follow]: 1 the first, then in the order in which they are found; none of an end
  RestPoint point = RestPoint::first;
  std::optional<int>
      from;  ///< the number of the state where its path leaves another, near which [search] has found it, or of the pass
  double reduced_volume = 0, L = 0;
  double followed = 0;                              ///< the value of [follow]'s parameter
  PointStatus status = PointStatus::failed;         ///< stationary, unresolved or failed
  std::optional<RestMeasures> measures;             ///< none where it failed
  double energy_error = not_known;                  ///< estimated
  std::array<double, most_eigenpairs> eigenvalues;  ///< ascending; not_known beyond those asked for
  std::array<double, most_eigenpairs> rates;        ///< descending, likewise
  std::string stop_reason;
  RestRow() {
    eigenvalues.fill(not_known);
    rates.fill(not_known);
  }
};
Columns<RestRow> rest_columns(const StatesInput& input);

/// Whether [follow] is in neither V_r nor L, which have their columns.
bool follows_other_number(const StatesInput& input);

/// Not known where there is no state.
double energy_of(const RestRow& row);

/// Of the state of that number, in the folder of states.csv.
std::filesystem::path frame_of(const std::filesystem::path& folder, int number);
/// One of its eigenpairs, 1 …
std::filesystem::path mode_of(const std::filesystem::path& folder, int number, int eigenpair);
/// One of its modes in the linearised flow, 1 …
std::filesystem::path growth_mode_of(const std::filesystem::path& folder, int number, int mode);

/// The rows and what they say, for people.
std::string table_of(const StatesInput& input, const std::vector<RestRow>& rows);

}  // namespace sbeh::studies

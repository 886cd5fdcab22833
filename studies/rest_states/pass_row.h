// The table of passes: states with one negative direction, and to which states they lead.
#pragma once

#include "studies/rest_states/rest_row.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// The stop_reason of a way that has come to a state.
inline constexpr const char* at_rest = "at rest";

/// Where one way down ends.
struct PassEnd {
  std::optional<int> state{};  ///< its number in states.csv; none where it does not rest
  std::string symmetry{};      ///< its class
  std::optional<int> negative_directions{};  ///< 0 of a minimum
  double energy = not_known;                 ///< of that state, else the last one of the flow
  double barrier = not_known;                ///< U of the pass less that of the state
  double time = not_known;                   ///< that the flow has taken
  std::string stop_reason{};                 ///< "at rest", or why it is not; empty: not yet gone

  bool is_gone() const { return !stop_reason.empty(); }
};

enum class PassKind {
  open,        ///< not gone down yet both ways
  two_states,  ///< it lies between these
  one_state,   ///< both ways lead to one, turned or mirrored: see the remark
  no_rest      ///< one way at least does not come to rest
};
constexpr auto names(PassKind) { return std::array{"open", "two states", "one state", "no rest"}; }

/// A row of passes.csv.
struct PassRow {
  int key = 0;  ///< the number of the pass in states.csv
  double reduced_volume = 0, L = 0;
  double followed = 0;  ///< the value of [follow]'s parameter
  std::string symmetry{};
  double energy = not_known;
  PassKind kind = PassKind::open;
  std::array<PassEnd, 2> ends{};
  std::string remark{};
};
Columns<PassRow> pass_columns(const StatesInput& input);

/// end – pass – end, for people.
std::string table_of(const StatesInput& input, const std::vector<PassRow>& passes);

}  // namespace sbeh::studies

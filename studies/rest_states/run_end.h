// The state at rest that a 3D run has come to, or near to.
#pragma once

#include "studies/evolution/run.h"
#include "studies/rest_states/rest_row.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sbeh::studies {

/// Where such a state lies in a run's folder, which is one of results of `sbeh states`.
inline constexpr const char* rest_folder = "rest";

/// Of a run with finish = "newton" that has ended at rest, or near there: the state to which Newton's method leads from its last
/// frame. None of other runs, and none of spheres. What is there already is not computed again. Throws OutputError, and Interrupted.
std::optional<RestRow> rest_of_run(const RunInput& input, const RunSummary& run,
                                   const std::filesystem::path& folder, std::string_view version);

/// Energy, error, and in how many directions it falls: for people.
std::string describe_rest(const RestRow& row);

}  // namespace sbeh::studies

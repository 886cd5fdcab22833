// A classical phase diagram of SSH: its branches, where they leave each other, fold, end and change their stability.
#pragma once

#include "studies/diagram/diagram_table.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

struct DiagramSummary {
  std::vector<Bifurcation> bifurcations;
  std::size_t states = 0;
  int computed = 0;             ///< values, in this call; the rest was there
  std::vector<double> missing;  ///< values at which no branch begins
  bool interrupted = false;
  double seconds = 0;
};

/// Leaves run.toml (the resolved input), branches.csv, bifurcations.csv and shapes.csv in the folder, by ascending values,
/// written anew after each value. Values are worked on in parallel; those that are there are not repeated. A folder that holds another
/// study is refused. Progress goes to standard error. Throws OutputError.
DiagramSummary run_diagram(const DiagramInput& input, const std::filesystem::path& folder,
                           std::string_view version);

/// How many there are of each kind, as a table for people.
std::string table_of(const DiagramSummary& summary);

}  // namespace sbeh::studies

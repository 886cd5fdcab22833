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
  std::vector<double> missing;  ///< values at which no branch begins
  bool interrupted = false;
  double seconds = 0;
};

/// Leaves run.toml (the resolved input), branches.csv, bifurcations.csv and shapes.csv in the folder, by ascending values. Values are
/// worked on in parallel; when interrupted only those are there that were done. A folder that holds results already is
/// refused. Progress goes to standard error. Throws OutputError.
DiagramSummary run_diagram(const DiagramInput& input, const std::filesystem::path& folder,
                           std::string_view version);

/// How many there are of each kind, as a table for people.
std::string table_of(const DiagramSummary& summary);

}  // namespace sbeh::studies

#include "tools/picture/scan/scan_grid.h"

#include "tools/picture/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::picture {
namespace {

// Those with a state of their own first.
int rank_of(PointStatus status) {
  switch (status) {
    case PointStatus::stationary:
      return 0;
    case PointStatus::limit:
      return 1;
    case PointStatus::unresolved:
      return 2;
    case PointStatus::failed:
      return 3;
  }
  return 3;
}

// Of two branches at one point; a later row of the same branch replaces the earlier one.
bool preferred(const PointResult& candidate, const PointResult& current) {
  if (candidate.key.branch == current.key.branch) return true;
  if (candidate.status != current.status)
    return rank_of(candidate.status) < rank_of(current.status);
  return energy_of(candidate) < energy_of(current);
}

}  // namespace

ScanGrid::ScanGrid(const std::filesystem::path& directory, const std::string& branch)
    : directory_(directory) {
  const std::filesystem::path file = directory / "scan.csv";
  std::set<double> volumes, lengths;
  std::set<std::string> branches;
  for (const PointResult& row : studies::read_rows(studies::scan_columns(), file)) {
    const auto& [volume, L, model, own_branch] = row.key;
    branches.insert(name(own_branch));
    if (!branch.empty() && name(own_branch) != branch) continue;
    volumes.insert(volume);
    lengths.insert(L);
    const auto [place, is_new] = points_.try_emplace({model, volume, L}, row);
    if (!is_new && preferred(row, place->second)) place->second = row;
  }
  reduced_volumes_.assign(volumes.begin(), volumes.end());
  lengths_.assign(lengths.begin(), lengths.end());
  branches_.assign(branches.begin(), branches.end());
  if (points_.empty()) {
    throw InputError(branch.empty()
                         ? fmt::format("{}: has no rows yet; run the scan first.", file.string())
                         : fmt::format("{}: has no branch '{}'; there is: {}.", file.string(),
                                       branch, fmt::join(branches_, ", ")));
  }
}

bool ScanGrid::has(Model model) const {
  return std::ranges::any_of(points_, [&](const auto& p) { return std::get<0>(p.first) == model; });
}

bool ScanGrid::has_series() const {
  return std::ranges::any_of(
      points_, [&](const auto& p) { return std::filesystem::exists(series(p.second)); });
}

const PointResult* ScanGrid::find(Model model, std::size_t reduced_volume,
                                  std::size_t length) const {
  const auto found = points_.find({model, reduced_volumes_[reduced_volume], lengths_[length]});
  return found == points_.end() ? nullptr : &found->second;
}

std::filesystem::path ScanGrid::profile(const PointResult& point) const {
  return point_file(directory_, point.key, ".csv");
}

std::filesystem::path ScanGrid::series(const PointResult& point) const {
  return point_file(directory_, point.key, ".series.csv");
}

double energy_of(const PointResult& point) {
  return point.diagnostics ? point.diagnostics->energy.total() : studies::not_known;
}

std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(size, count);
  for (std::size_t i = 0; i < n; ++i)
    chosen.push_back(
        n == 1 ? 0 : std::size_t(std::llround(double(i) * double(size - 1) / double(n - 1))));
  return chosen;
}

}  // namespace sbeh::picture

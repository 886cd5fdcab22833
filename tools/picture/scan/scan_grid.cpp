#include "tools/picture/scan/scan_grid.h"

#include "studies/parameters/material_number.h"
#include "studies/scan/scan_stack.h"
#include "tools/picture/chart/axis.h"
#include "tools/picture/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// Of a scan over one number of the material at one L; of any other none.
std::vector<studies::ScanLayer> layers_in(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "run.toml";
  if (!std::filesystem::exists(file)) return {};
  const studies::ScanInput input = studies::read_scan(file);
  if (input.axes.empty()) return {};
  if (input.axes.size() > 1 || input.L.size() > 1)
    throw InputError(fmt::format(
        "{}: has more than two axes: pictures are made of its layers, such as {}",
        directory.string(), (directory / studies::layers_of(input).front().folder).string()));
  return studies::layers_of(input);
}

}  // namespace

ScanGrid::ScanGrid(const std::filesystem::path& directory, const std::string& branch)
    : directory_(directory) {
  const std::vector<studies::ScanLayer> layers = layers_in(directory);
  if (layers.empty()) read(directory, {}, branch);
  for (const studies::ScanLayer& layer : layers) {
    if (!std::filesystem::exists(directory / layer.folder / "scan.csv")) continue;
    folders_[layer.values.front()] = layer.folder;
    read(directory / layer.folder, layer.values.front(), branch);
  }
  if (!layers.empty()) {
    const studies::ScanInput input = studies::read_scan(directory / "run.toml");
    length_name_ = input.axes.front().parameter;
    single_L_ = input.L.front();
    length_axis_ = studies::MaterialNumber::named(length_name_)->title();
  }
  reduced_volumes_.assign(volumes_read_.begin(), volumes_read_.end());
  lengths_.assign(lengths_read_.begin(), lengths_read_.end());
  branches_.assign(branches_read_.begin(), branches_read_.end());
  const std::string file = (directory / "scan.csv").string();
  if (points_.empty()) {
    throw InputError(branch.empty() ? fmt::format("{}: has no rows yet; run the scan first.", file)
                                    : fmt::format("{}: has no branch '{}'; there is: {}.", file,
                                                  branch, fmt::join(branches_, ", ")));
  }
}

void ScanGrid::read(const std::filesystem::path& folder, const std::optional<double>& in_place_of_L,
                    const std::string& branch) {
  for (const PointResult& row : studies::read_rows(studies::scan_columns(), folder / "scan.csv")) {
    const auto& [volume, L, model, own_branch] = row.key;
    branches_read_.insert(name(own_branch));
    if (!branch.empty() && name(own_branch) != branch) continue;
    const double length = in_place_of_L.value_or(L);
    volumes_read_.insert(volume);
    lengths_read_.insert(length);
    const auto [place, is_new] = points_.try_emplace({model, volume, length}, row);
    if (!is_new && preferred(row, place->second)) place->second = row;
  }
}

std::string ScanGrid::length_title(std::size_t length) const {
  return length_name_ + " = " + short_number(lengths_[length]);
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

std::filesystem::path ScanGrid::folder_of(const PointResult& point) const {
  if (over_L()) return directory_;
  for (const auto& [place, row] : points_)
    if (&row == &point) return directory_ / folders_.at(std::get<2>(place));
  return directory_;
}

std::filesystem::path ScanGrid::profile(const PointResult& point) const {
  return point_file(folder_of(point), point.key, ".csv");
}

std::filesystem::path ScanGrid::series(const PointResult& point) const {
  return point_file(folder_of(point), point.key, ".series.csv");
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

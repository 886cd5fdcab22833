#include "tools/picture/canvas/scan_table.h"

#include "tools/picture/canvas/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

Model model_of(const std::string& text, const fs::path& file) {
  if (text == "SBEH") return Model::SBEH;
  if (text == "SSH") return Model::SSH;
  throw InputError(fmt::format("{}: model = '{}'; it must be SBEH or SSH.", file.string(), text));
}

Status status_of(const std::string& text, const fs::path& file) {
  if (text == "stationary") return Status::stationary;
  if (text == "unresolved") return Status::unresolved;
  if (text == "failed") return Status::failed;
  throw InputError(fmt::format("{}: status = '{}'; it must be stationary, unresolved or failed.",
                               file.string(), text));
}

// Of two branches at one point; a later row of the same branch replaces the earlier one.
bool preferred(const ScanPoint& candidate, const ScanPoint& current) {
  if (candidate.branch == current.branch) return true;
  if (candidate.status != current.status) return candidate.status < current.status;
  return candidate.energy < current.energy;
}

}  // namespace

ScanTable::ScanTable(const fs::path& directory, const std::string& branch) {
  const fs::path file = directory / "scan.csv";
  const CsvTable table(file);
  const auto column = [&](const char* name) { return table.column(name); };
  const std::size_t models = column("model"), volumes = column("reduced_volume"),
                    lengths = column("L"), branch_column = column("branch"),
                    states = column("status"), energies = column("energy"),
                    orders = column("order_min"), curvatures = column("H_abs_max");

  std::map<long long, double> volume_values, length_values;
  std::set<std::string> branch_names;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, branch_column);
    branch_names.insert(name);
    if (!branch.empty() && name != branch) continue;

    const double volume = table.number(row, volumes);
    const double length = table.number(row, lengths);
    if (!std::isfinite(volume) || !std::isfinite(length)) {
      throw InputError(
          fmt::format("{}: a row has no reduced_volume or L; mend or remove it.", file.string()));
    }
    const std::string stem = fmt::format("{}_{}_v{}_L{}", table.text(row, models), name,
                                         table.text(row, volumes), table.text(row, lengths));
    const ScanPoint point{.status = status_of(table.text(row, states), file),
                          .branch = name,
                          .energy = table.number(row, energies),
                          .order_min = table.number(row, orders),
                          .H_abs_max = table.number(row, curvatures),
                          .profile = directory / "points" / (stem + ".csv"),
                          .series = directory / "points" / (stem + ".series.csv")};
    volume_values.emplace(parameter_key(volume), volume);
    length_values.emplace(parameter_key(length), length);
    const Key key{model_of(table.text(row, models), file), parameter_key(volume),
                  parameter_key(length)};
    const auto [place, is_new] = points_.try_emplace(key, point);
    if (!is_new && preferred(point, place->second)) place->second = point;
  }
  branches_.assign(branch_names.begin(), branch_names.end());
  if (points_.empty()) {
    throw InputError(branch.empty()
                         ? fmt::format("{}: has no rows yet; run the scan first.", file.string())
                         : fmt::format("{}: has no branch '{}'; there is: {}.", file.string(),
                                       branch, fmt::join(branches_, ", ")));
  }
  for (const auto& [key, value] : volume_values) reduced_volumes_.push_back(value);
  for (const auto& [key, value] : length_values) lengths_.push_back(value);
}

bool ScanTable::has(Model model) const {
  return std::ranges::any_of(points_, [&](const auto& p) { return std::get<0>(p.first) == model; });
}

const ScanPoint* ScanTable::find(Model model, std::size_t reduced_volume,
                                 std::size_t length) const {
  const auto found = points_.find(
      {model, parameter_key(reduced_volumes_[reduced_volume]), parameter_key(lengths_[length])});
  return found == points_.end() ? nullptr : &found->second;
}

long long parameter_key(double parameter) { return std::llround(parameter * 1e9); }

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::vector<std::size_t> evenly_spread(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(size, count);
  for (std::size_t i = 0; i < n; ++i) {
    chosen.push_back(n == 1 ? 0
                            : static_cast<std::size_t>(
                                std::llround(double(i) * double(size - 1) / double(n - 1))));
  }
  return chosen;
}

}  // namespace sbeh::picture

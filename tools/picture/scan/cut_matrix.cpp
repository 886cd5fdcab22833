#include "tools/picture/scan/cut_matrix.h"

#include "studies/states/profile_file.h"
#include "tools/picture/chart/axis.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_volumes = 6;
constexpr std::size_t most_lengths = 7;

}  // namespace

CutMatrix::CutMatrix(const ScanGrid& scan)
    : scan_(scan),
      volumes_(evenly_spread(scan.reduced_volumes().size(), most_volumes)),
      lengths_(evenly_spread(scan.lengths().size(), most_lengths)),
      is_row_(lengths_.size() == 1) {
  for (const std::size_t volume : volumes_) {
    for (std::size_t length = 0; length < scan.lengths().size(); ++length) {
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const PointResult* point = scan.find(model, volume, length);
        if (!point || !std::filesystem::exists(scan.profile(*point))) continue;
        const Cut& cut = cuts_[point] = mirrored(studies::read_profile(scan.profile(*point)));
        extent_.include(cut);
        if (model == Model::SBEH) orders_.include(cut);
      }
    }
  }
}

std::size_t CutMatrix::volume(std::size_t row, std::size_t column) const {
  return volumes_[is_row_ ? column : row];
}

std::size_t CutMatrix::length(std::size_t row, std::size_t column) const {
  return lengths_[is_row_ ? row : column];
}

std::size_t CutMatrix::overlay_rows() const {
  if (is_row_ || !scan_.has(Model::SBEH)) return 0;
  return (volumes_.size() + columns() - 1) / columns();
}

const Cut* CutMatrix::cut(Model model, std::size_t volume, std::size_t length) const {
  const auto found = cuts_.find(scan_.find(model, volume, length));
  return found == cuts_.end() ? nullptr : &found->second;
}

std::string CutMatrix::title() const {
  const std::size_t all_volumes = scan_.reduced_volumes().size();
  const std::size_t all_lengths = scan_.lengths().size();
  if (volumes_.size() == all_volumes && lengths_.size() == all_lengths) return "Cross sections";
  return fmt::format("Cross sections: {} of {} reduced volumes, {} of {} values of L",
                     volumes_.size(), all_volumes, lengths_.size(), all_lengths);
}

std::string CutMatrix::row_title(std::size_t row) const {
  return is_row_ ? length_title(scan_.lengths()[length(row, 0)])
                 : volume_title(scan_.reduced_volumes()[volume(row, 0)]);
}

std::string CutMatrix::column_title(std::size_t column) const {
  return is_row_ ? volume_title(scan_.reduced_volumes()[volume(0, column)])
                 : length_title(scan_.lengths()[length(0, column)]);
}

std::string CutMatrix::remark(std::size_t volume, std::size_t length) const {
  std::vector<std::string> remarks;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    if (!scan_.has(model)) continue;
    const char* name = sbeh::name(model);
    const PointResult* point = scan_.find(model, volume, length);
    if (!point) {
      remarks.push_back(fmt::format("no {}", name));
    } else if (point->status == PointStatus::failed) {
      remarks.push_back(fmt::format("{} failed", name));
    } else if (!cut(model, volume, length)) {
      remarks.push_back(fmt::format("no {} profile", name));
    } else if (point->status == PointStatus::unresolved) {
      remarks.push_back(fmt::format("{} unresolved", name));
    }
  }
  return fmt::format("{}", fmt::join(remarks, ", "));
}

bool CutMatrix::any_remark() const {
  return std::ranges::any_of(volumes_, [&](std::size_t volume) {
    return std::ranges::any_of(lengths_,
                               [&](std::size_t length) { return !remark(volume, length).empty(); });
  });
}

std::vector<double> CutMatrix::half_heights() const {
  std::vector<Extent> extents(rows() + overlay_rows());
  for (std::size_t v = 0; v < volumes_.size(); ++v) {
    for (std::size_t length = 0; length < scan_.lengths().size(); ++length) {
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const Cut* shown = cut(model, volumes_[v], length);
        if (!shown) continue;
        extents[is_row_ ? 0 : v].include(*shown);
        if (overlay_rows() > 0) extents[rows() + v / columns()].include(*shown);
      }
    }
  }
  std::vector<double> halves;
  for (const Extent& extent : extents) {
    halves.push_back(std::max(extent.half_height, 0.2 * extent_.half_height));
  }
  return halves;
}

}  // namespace sbeh::picture

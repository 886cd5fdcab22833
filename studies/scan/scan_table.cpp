#include "studies/scan/scan_table.h"

#include "studies/io/csv_line.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace sbeh::studies {

namespace {

constexpr const char* header =
    "model,reduced_volume,L,branch,status,energy,energy_distortion,energy_bending,"
    "energy_thermotropic,order_min,order_max,order_mean,order_std,order_variance,H_pole,H_rim,"
    "H_abs_max,radius_equator,thickness_pole,W2,area,volume,residual,steps,wall_seconds,stop_"
    "reason,"
    "class,negative_directions,self_contact,fold_side,fold_L";
constexpr std::size_t columns = 31;

constexpr std::array<const char*, 3> status_words{"stationary", "unresolved", "failed"};

// The measured columns between status and residual, in their order; the total energy comes first.
std::array<double, 17> measures(const axisym::Diagnostics& d) {
  return {d.energy.total(),
          d.energy.distortion,
          d.energy.bending,
          d.energy.thermotropic,
          d.order_min,
          d.order_max,
          d.order_mean,
          d.order_std,
          d.order_variance,
          d.H_pole,
          d.H_rim,
          d.H_abs_max,
          d.radius_equator,
          d.thickness_pole,
          d.W2,
          d.area,
          d.volume};
}
axisym::Diagnostics diagnostics_of(const std::array<double, 17>& m) {
  axisym::Diagnostics d{};
  d.energy = {m[1], m[2], m[3]};
  d.order_min = m[4];
  d.order_max = m[5];
  d.order_mean = m[6];
  d.order_std = m[7];
  d.order_variance = m[8];
  d.H_pole = m[9];
  d.H_rim = m[10];
  d.H_abs_max = m[11];
  d.radius_equator = m[12];
  d.thickness_pole = m[13];
  d.W2 = m[14];
  d.area = m[15];
  d.volume = m[16];
  return d;
}

std::string line_of(const PointResult& row) {
  std::string line =
      fmt::format("{},{},{},{},{}", model::name(row.key.model), row.key.reduced_volume, row.key.L,
                  name(row.key.branch), status_words[std::size_t(row.status)]);
  std::array<double, 17> m;
  m.fill(std::nan(""));
  if (row.diagnostics) m = measures(*row.diagnostics);
  for (const double value : m) line += fmt::format(",{}", value);
  return line
       + fmt::format(",{:.3g},{},{:.4g},{},{},{},{:d},{}", row.residual, row.steps,
                     row.wall_seconds, csv_field(row.stop_reason), row.shape,
                     row.negative_directions ? std::to_string(*row.negative_directions) : "",
                     row.self_contact, row.fold_side)
       + (row.fold_L ? fmt::format(",{}", *row.fold_L) : ",");
}

std::optional<PointResult> row_of(const std::string& line) {
  const auto f = split_csv(line);
  if (f.size() != columns) return {};
  PointResult row;
  const auto model = model::value_named<model::Model>(f[0]);
  const auto branch = model::value_named<axisym::Branch>(f[3]);
  if (!model || !branch) return {};
  row.key.model = *model;
  row.key.branch = *branch;
  bool ok = parse_number(f[1], row.key.reduced_volume) && parse_number(f[2], row.key.L);
  const auto word = std::find(status_words.begin(), status_words.end(), f[4]);
  ok = ok && word != status_words.end();
  row.status = PointStatus(word - status_words.begin());
  std::array<double, 17> m{};
  for (std::size_t k = 0; ok && k < m.size(); ++k) ok = parse_number(f[5 + k], m[k]);
  if (!std::isnan(m[0])) row.diagnostics = diagnostics_of(m);
  double steps = 0;
  ok = ok && parse_number(f[22], row.residual) && parse_number(f[23], steps)
    && parse_number(f[24], row.wall_seconds);
  row.steps = int(steps);
  row.stop_reason = f[25];
  row.shape = f[26];
  if (!f[27].empty()) row.negative_directions = std::atoi(f[27].c_str());
  row.self_contact = f[28] == "1";
  row.fold_side = f[29];
  if (!f[30].empty()) ok = ok && parse_number(f[30], row.fold_L.emplace());
  return ok ? std::optional(row) : std::nullopt;
}

}  // namespace

PointKey key_of(const axisym::StationaryCase& of) {
  return {of.reduced_volume, of.L(), of.model, of.branch};
}

std::string stem(const PointKey& key) {
  return fmt::format("{}_{}_v{}_L{}", model::name(key.model), name(key.branch), key.reduced_volume,
                     key.L);
}

ScanTable::ScanTable(const OutputFolder& folder) : path_(folder / "scan.csv") {
  if (!std::filesystem::exists(path_)) {
    write_file(path_, std::string(header) + "\n");
  } else {
    std::istringstream text(read_file(path_));
    std::string line;
    if (!std::getline(text, line) || line != header)
      throw OutputError(
          fmt::format("{}: is no table of this version's scans; choose another folder "
                      "with -o or move the old one away",
                      path_.string()));
    for (int number = 2; std::getline(text, line); ++number) {
      const bool whole = !text.eof();  // its line end is there
      const auto row = row_of(line);
      if (row && whole) {
        rows_.insert_or_assign(row->key, *row);
      } else if (whole) {
        throw OutputError(
            fmt::format("{}:{}: is damaged; delete that line to have its point computed again",
                        path_.string(), number));
      }
    }
    sort();
  }
  file_.emplace(path_);
}

const PointResult* ScanTable::find(const PointKey& key) const {
  const auto at = rows_.find(key);
  return at == rows_.end() ? nullptr : &at->second;
}

void ScanTable::append(const PointResult& row) {
  file_->append(line_of(row));
  rows_.insert_or_assign(row.key, row);
}

void ScanTable::sort() {
  file_.reset();
  std::string text = std::string(header) + "\n";
  for (const auto& [key, row] : rows_) text += line_of(row) + "\n";
  write_file(path_, text);
  file_.emplace(path_);
}

}  // namespace sbeh::studies

#include "studies/report/packed_fields.h"

#include "studies/io/csv.h"

#include <fmt/format.h>

namespace sbeh::studies {

PackedFields::PackedFields(std::string_view name, const std::vector<std::string>& fields)
    : name_(name), table_("key,nodes") {
  for (const std::string& field : fields) table_ += fmt::format(",{0}_low,{0}_high", field);
  table_ += "\n";
}

void PackedFields::add(std::string_view key, const std::vector<std::vector<double>>& values) {
  table_ += fmt::format("{},{}", csv_field(key), values.front().size());
  for (const std::vector<double>& field : values) {
    NumberRange range;
    for (const double value : field) range.include(value);
    for (const double value : field) numbers_.push_back(quantised(value, range));
    table_ += fmt::format(",{:.8g},{:.8g}", range.low, range.high);
  }
  table_ += "\n";
}

void PackedFields::put_into(Bundle& bundle) const {
  bundle.add(name_ + ".csv", table_);
  bundle.add(name_, differences(numbers_, 1));
}

}  // namespace sbeh::studies

#include "studies/io/toml_reader.h"

#include "studies/io/csv.h"
#include "studies/io/input_path.h"
#include "studies/io/spelling.h"
#include "studies/io/toml_messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sbeh::studies {

namespace {

constexpr int largest_count = 100000;  // values of a range

// ---- looking up ---------------------------------------------------------------------------------

const toml::node* find(TableState& table, std::string_view key) {
  if (!asked_for(table, key)) table.asked.emplace_back(key);
  return table.table ? table.table->get(key) : nullptr;
}

/// The value, or null when it is absent and may be.
const toml::node* find(TableState& table, std::string_view key, bool may_be_absent,
                       std::string_view kind) {
  const toml::node* value = find(table, key);
  if (!value && !may_be_absent) fail_missing(table, key, kind);
  return value;
}

const toml::array& as_list(const TableState& table, std::string_view key, const toml::node& value,
                           std::string_view kind) {
  if (!value.is_array()) fail_at(table, key, value, kind);
  if (value.as_array()->empty()) fail_at(table, key, value, "must not be empty");
  return *value.as_array();
}

// ---- single values ------------------------------------------------------------------------------

/// Of a text with a unit.
double measured(const TableState& table, std::string_view key, const toml::node& value,
                const Dimension& dimension) {
  double number = 0;
  if (!table.scales && parse_number(value.as_string()->get(), number))
    fail_at(table, key, value, "must be a number");
  if (!table.scales)
    fail_at(table, key, value,
            table.document->contains("units")
                ? "must be a number here, without a unit"
                : "must be a number; a unit needs a table [units], which tells of what vesicle");
  try {
    return number_in(*table.scales, value.as_string()->get(), dimension);
  } catch (const std::invalid_argument& error) {
    fail_at(table, key, value, error.what());
  }
}

double as_number(const TableState& table, std::string_view key, const toml::node& value,
                 const Interval& allowed, std::string_view kind, std::string_view quantity = {}) {
  const Dimension dimension = dimension_of_key(quantity.empty() ? key : quantity);
  const bool is_measured = value.is_string() && dimension != dimension::none;
  if (!is_measured && !value.is_number()) fail_at(table, key, value, kind);
  const double number =
      is_measured ? measured(table, key, value, dimension) : *value.value<double>();
  if (!std::isfinite(number)) fail_at(table, key, value, "must be a finite number");
  if (!allowed.contains(number)) fail_at(table, key, value, "must be " + allowed.text());
  return number;
}

int as_integer(const TableState& table, std::string_view key, const toml::node& value, int low,
               int high, std::string_view kind) {
  if (!value.is_integer()) fail_at(table, key, value, kind);
  const std::int64_t integer = value.as_integer()->get();
  if (integer < low || integer > high)
    fail_at(table, key, value, fmt::format("must be >= {} and <= {}", low, high));
  return int(integer);
}

std::string as_word(const TableState& table, std::string_view key, const toml::node& value,
                    const std::vector<std::string>& known) {
  const auto* text = value.as_string();
  if (!text || std::find(known.begin(), known.end(), text->get()) == known.end())
    fail_at(table, key, value,
            (known.size() > 1 ? "must be one of " : "must be ") + in_quotes(known));
  return text->get();
}

/// The values of `{ from, to, count, spacing }`.
std::vector<double> as_range(const TomlTable& range, const Interval& allowed) {
  const double from = range.number("from", allowed);
  const double to = range.number("to", allowed);
  const int count = range.integer("count", 1, largest_count);
  const bool logarithmic = range.word("spacing", {"linear", "log"}, "linear") == "log";
  range.reject_unknown_keys();
  if (logarithmic && from <= 0) range.fail("from", "must be > 0 for spacing = \"log\"");
  if (logarithmic && to <= 0) range.fail("to", "must be > 0 for spacing = \"log\"");
  if (count == 1 && from != to) range.fail("count", "must be > 1, since from and to differ");
  if (count > 1 && from == to) range.fail("to", "must differ from from, since count > 1");
  std::vector<double> values = evenly_spaced(std::min(from, to), std::max(from, to), count,
                                             logarithmic ? Spacing::logarithmic : Spacing::linear);
  if (std::adjacent_find(values.begin(), values.end()) != values.end())
    range.fail("count", "must be smaller: the values are equal to 12 digits");
  return values;
}

}  // namespace

std::vector<double> evenly_spaced(double low, double high, int count, Spacing spacing) {
  std::vector<double> values{low};
  for (int i = 1; i < count - 1; ++i) {
    const double s = double(i) / (count - 1);
    const double exact = spacing == Spacing::logarithmic
                           ? std::exp((1 - s) * std::log(low) + s * std::log(high))
                           : (1 - s) * low + s * high;
    const double rounded = std::strtod(fmt::format("{:.11e}", exact).c_str(), nullptr);
    values.push_back(std::clamp(rounded, low, high));
  }
  if (count > 1) values.push_back(high);
  return values;
}

void TomlTable::measured_by(const std::optional<Scales>& scales) const { state_->scales = scales; }

bool TomlTable::has(std::string_view key) const { return find(*state_, key) != nullptr; }

double TomlTable::number(std::string_view key, const Interval& allowed,
                         std::optional<double> absent) const {
  constexpr auto kind = "must be a number";
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  return value ? as_number(*state_, key, *value, allowed, kind) : *absent;
}

double TomlTable::number_as(std::string_view quantity, std::string_view key,
                            const Interval& allowed) const {
  constexpr auto kind = "must be a number";
  return as_number(*state_, key, *find(*state_, key, false, kind), allowed, kind, quantity);
}

double TomlTable::number_or_infinity(std::string_view key, const Interval& allowed) const {
  constexpr auto kind = "must be a number";
  const toml::node* value = find(*state_, key, false, kind);
  if (value->is_floating_point() && std::isinf(*value->value<double>())
      && allowed.contains(*value->value<double>()))
    return *value->value<double>();
  return as_number(*state_, key, *value, allowed, kind);
}

int TomlTable::integer(std::string_view key, int low, int high, std::optional<int> absent) const {
  constexpr auto kind = "must be an integer";
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  return value ? as_integer(*state_, key, *value, low, high, kind) : *absent;
}

bool TomlTable::boolean(std::string_view key, std::optional<bool> absent) const {
  constexpr auto kind = "must be true or false";
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  if (!value) return *absent;
  if (!value->is_boolean()) fail_at(*state_, key, *value, kind);
  return value->as_boolean()->get();
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> absent) const {
  constexpr auto kind = "must be a text in quotes";
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  if (!value) return *absent;
  if (!value->is_string()) fail_at(*state_, key, *value, kind);
  if (value->as_string()->get().empty()) fail_at(*state_, key, *value, "must not be empty");
  return value->as_string()->get();
}

std::string TomlTable::path(std::string_view key) const {
  return path_from(state_->file, text(key));
}

std::string TomlTable::word(std::string_view key, const std::vector<std::string>& known,
                            std::optional<std::string> absent) const {
  const auto kind = (known.size() > 1 ? "must be one of " : "must be ") + in_quotes(known);
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  return value ? as_word(*state_, key, *value, known) : *absent;
}

std::vector<std::string> TomlTable::words(std::string_view key,
                                          const std::vector<std::string>& known,
                                          std::optional<std::vector<std::string>> absent) const {
  const auto kind = fmt::format("must be a list of words out of [{}]", in_quotes(known));
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  if (!value) return *absent;
  std::vector<std::string> words;
  for (const toml::node& element : as_list(*state_, key, *value, kind)) {
    const std::string word = as_word(*state_, key, element, known);
    if (std::find(words.begin(), words.end(), word) != words.end())
      fail_at(*state_, key, element, "must not be there twice");
    words.push_back(word);
  }
  return words;
}

std::vector<double> TomlTable::numbers(std::string_view key, const Interval& allowed) const {
  constexpr auto kind = "must be a list of numbers";
  const toml::node* value = find(*state_, key, false, kind);
  std::vector<double> numbers;
  for (const toml::node& element : as_list(*state_, key, *value, kind))
    numbers.push_back(as_number(*state_, key, element, allowed, kind));
  return numbers;
}

std::vector<double> TomlTable::grid(std::string_view key, const Interval& allowed,
                                    std::optional<std::vector<double>> absent) const {
  constexpr auto kind = "must be a number, a list of numbers, or a range { from, to, count }";
  const toml::node* value = find(*state_, key, absent.has_value(), kind);
  if (!value) return *absent;
  if (value->is_table()) return as_range(table(key), allowed);
  if (!value->is_array()) return {as_number(*state_, key, *value, allowed, kind)};
  std::vector<double> values;
  for (const toml::node& element : as_list(*state_, key, *value, kind)) {
    const double number = as_number(*state_, key, element, allowed, kind);
    if (std::find(values.begin(), values.end(), number) != values.end())
      fail_at(*state_, key, element, "must not be there twice");
    values.push_back(number);
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<axisym::Mode> TomlTable::modes(std::string_view key, int lowest, int highest) const {
  const auto kind =
      fmt::format("must be a list of pairs [degree, amplitude], the degree an integer in {} ... {}",
                  lowest, highest);
  const toml::node* value = find(*state_, key, false, kind);
  std::vector<axisym::Mode> modes;
  for (const toml::node& element : as_list(*state_, key, *value, kind)) {
    const auto* pair = element.as_array();
    if (!pair || pair->size() != 2) fail_at(*state_, key, element, kind);
    const int degree = as_integer(*state_, key, *pair->get(0), lowest, highest, kind);
    for (const axisym::Mode& earlier : modes)
      if (earlier.l == degree) fail_at(*state_, key, element, "degree must not be there twice");
    modes.push_back({degree, as_number(*state_, key, *pair->get(1), {}, kind)});
  }
  return modes;
}

std::vector<meshing::Harmonic> TomlTable::harmonics(std::string_view key, int highest) const {
  const auto kind = fmt::format(
      "must be a list of [l, m, amplitude], the degree l an integer in 0 ... {}, the order m in "
      "-l ... l",
      highest);
  const toml::node* value = find(*state_, key, false, kind);
  std::vector<meshing::Harmonic> modes;
  for (const toml::node& element : as_list(*state_, key, *value, kind)) {
    const auto* triple = element.as_array();
    if (!triple || triple->size() != 3) fail_at(*state_, key, element, kind);
    const int l = as_integer(*state_, key, *triple->get(0), 0, highest, kind);
    const int m = as_integer(*state_, key, *triple->get(1), -l, l, kind);
    for (const meshing::Harmonic& earlier : modes)
      if (earlier.l == l && earlier.m == m)
        fail_at(*state_, key, element, "a harmonic must not be there twice");
    modes.push_back({l, m, as_number(*state_, key, *triple->get(2), {}, kind)});
  }
  return modes;
}

TomlTable TomlTable::table(std::string_view key) const {
  TableState child{.file = state_->file, .document = state_->document, .section = state_->section};
  child.file_table = state_->file_table ? state_->file_table : state_;
  const toml::node* value = find(*state_, key);
  if (value && !value->is_table()) fail_at(*state_, key, *value, "must be a table");
  if (value) {
    child.table = value->as_table();
    child.line = line_of(*value);
  }
  if (value && child.table->is_inline())
    child.prefix = state_->prefix + shown_key(key) + ".";
  else
    child.section = section_name(*state_, key);
  return TomlTable(std::make_shared<TableState>(std::move(child)));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  constexpr const char* kind = "must be a list of tables, [{ ... }, ...]";
  const toml::node* value = find(*state_, key, false, kind);
  std::vector<TomlTable> all;
  for (const toml::node& element : as_list(*state_, key, *value, kind)) {
    if (!element.is_table()) fail_at(*state_, key, element, kind);
    TableState child{
        .file = state_->file, .document = state_->document, .section = state_->section};
    child.file_table = state_->file_table ? state_->file_table : state_;
    child.table = element.as_table();
    child.line = line_of(element);
    child.prefix = state_->prefix + shown_key(key) + ".";
    all.emplace_back(std::make_shared<TableState>(std::move(child)));
  }
  return all;
}

void TomlTable::refuse(std::string_view key, std::string_view reason) const {
  if (state_->table && state_->table->get(key)) fail(key, reason);
}

void TomlTable::refuse_word(std::string_view key, std::string_view word,
                            std::string_view reason) const {
  const toml::node* value = state_->table ? state_->table->get(key) : nullptr;
  if (!value || !value->is_array()) return;
  for (const toml::node& element : *value->as_array())
    if (element.value<std::string_view>() == word) fail_at(*state_, key, element, reason);
}

void TomlTable::reject_unknown_keys() const {
  if (!state_->table) return;
  const toml::key* first = nullptr;  // of the file; the table is in alphabetical order
  for (const auto& [key, value] : *state_->table)
    if (!asked_for(*state_, key.str())
        && (!first || key.source().begin.line < first->source().begin.line))
      first = &key;
  if (!first) return;
  const std::vector<std::string>& known = state_->asked;
  if (const auto place = place_of_key(*state_, first->str()))
    throw InputError(fmt::format("{} It has its place in [{}]. Known here: {}",
                                 unknown(*state_, *first, {}), *place, fmt::join(known, ", ")));
  throw InputError(fmt::format("{} Known: {}",
                               unknown(*state_, *first, nearest(first->str(), known)),
                               fmt::join(known, ", ")));
}

void TomlTable::refuse_misspelt(const std::vector<std::string>& keys) const {
  studies::refuse_misspelt(*state_, keys);
}

void TomlTable::fail(std::string_view key, std::string_view what) const {
  if (const toml::node* value = state_->table ? state_->table->get(key) : nullptr)
    fail_at(*state_, key, *value, what);
  refuse_misspelt({std::string(key)});
  throw InputError(
      fmt::format("{}: {}: {}", place(*state_, state_->line), full_name(*state_, key), what));
}

void TomlTable::fail_from(const std::invalid_argument& error) const {
  const std::string text = error.what();
  const std::string name = text.substr(0, text.find(" = "));
  const toml::node* value = state_->table ? state_->table->get(name) : nullptr;
  throw InputError(fmt::format("{}: [{}] {}",
                               place(*state_, value ? line_of(*value) : state_->line),
                               state_->section, text));
}

}  // namespace sbeh::studies

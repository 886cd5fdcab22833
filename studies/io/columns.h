// The columns of a table, each said once: its name, and what of a row it holds.
//
//   const Columns<FoldRow> columns{column("L", &FoldRow::L), column("branch", &FoldRow::branch)};
//
// From such a list follow the header, a row's line, and a row read back.
#pragma once

#include "model/names.h"
#include "studies/io/csv.h"
#include "studies/io/dimension.h"
#include "studies/io/output.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace sbeh::studies {

template <class Row>
struct Column {
  std::string name;
  std::function<std::string(const Row&)> write;  ///< the field
  /// Takes the value of the field over; false when it is none of this column.
  std::function<bool(Row&, const std::string&)> read;
};
template <class Row>
using Columns = std::vector<Column<Row>>;

// ---- fields -------------------------------------------------------------------------------------

inline std::string field_of(double value, const char* format) {
  return fmt::format(fmt::runtime(format), value);
}
inline std::string field_of(int value, const char*) { return std::to_string(value); }
inline std::string field_of(bool value, const char*) { return value ? "1" : "0"; }
inline std::string field_of(const std::string& value, const char*) { return csv_field(value); }
template <class E>
requires std::is_enum_v<E> std::string field_of(E value, const char*) { return name(value); }
template <class T>
std::string field_of(const std::optional<T>& value, const char* format) {
  return value ? field_of(*value, format) : "";
}

inline bool read_field(double& value, const std::string& field) {
  return parse_number(field, value);
}
inline bool read_field(int& value, const std::string& field) {
  double number = 0;
  if (!parse_number(field, number)) return false;
  value = int(number);
  return true;
}
inline bool read_field(bool& value, const std::string& field) {
  value = field == "1";
  return value || field == "0";
}
inline bool read_field(std::string& value, const std::string& field) { return value = field, true; }
template <class E>
requires std::is_enum_v<E>
bool read_field(E& value, const std::string& field) {
  const auto named = value_named<E>(field);
  if (named) value = *named;
  return named.has_value();
}
template <class T>
bool read_field(std::optional<T>& value, const std::string& field) {
  value.reset();
  return field.empty() || read_field(value.emplace(), field);
}

// ---- columns ------------------------------------------------------------------------------------

/// A member of a member (of a member …).
template <class... Members>
auto inside(Members... members) {
  return [=](auto& row) -> auto& { return (row.*....*members); };
}

/// `member`: a pointer to a member of a row, or a function that gives a reference to the value in it.
template <class Row, class Member>
Column<Row> column(std::string name, Member member, const char* format = "{}") {
  return {std::move(name),
          [=](const Row& row) { return field_of(std::invoke(member, row), format); },
          [=](Row& row, const std::string& field) {
            return read_field(std::invoke(member, row), field);
          }};
}
template <class Row, class Value>
Column<Row> column(std::string name, Value Row::*member, const char* format = "{}") {
  return column<Row, Value Row::*>(std::move(name), member, format);
}

/// A number that may be `not_known`; then its field is empty.
template <class Row, class Member>
Column<Row> known_column(std::string name, Member member, const char* format = "{}") {
  return {std::move(name),
          [=](const Row& row) {
            const double value = std::invoke(member, row);
            return std::isnan(value) ? "" : field_of(value, format);
          },
          [=](Row& row, const std::string& field) {
            double& value = std::invoke(member, row);
            value = not_known;
            return field.empty() || read_field(value, field);
          }};
}
template <class Row>
Column<Row> known_column(std::string name, double Row::*member, const char* format = "{}") {
  return known_column<Row, double Row::*>(std::move(name), member, format);
}

/// A value of a part that a row may not have: then the field is `none`. The first value read makes the part.
template <class Row, class Part, class Member>
Column<Row> part_column(std::string name, std::optional<Part> Row::*part, Member member,
                        std::string none, const char* format = "{}") {
  return {std::move(name),
          [=](const Row& row) {
            return row.*part ? field_of(std::invoke(member, *(row.*part)), format) : none;
          },
          [=](Row& row, const std::string& field) {
            if (!(row.*part)) {
              if (field == none) return true;
              (row.*part).emplace();
            }
            return read_field(std::invoke(member, *(row.*part)), field);
          }};
}

/// What follows from others, and is not read back.
template <class Row, class Text>
Column<Row> derived_column(std::string name, Text text) {
  return {std::move(name), text, [](Row&, const std::string&) { return true; }};
}

// ---- tables -------------------------------------------------------------------------------------

/// Throws std::logic_error for a column whose dimension (dimension.h) is not known.
template <class Row>
std::string header_of(const Columns<Row>& columns) {
  std::string line;
  for (const Column<Row>& column : columns) {
    if (!dimension_of(column.name))
      throw std::logic_error("dimension.cpp does not know the column " + column.name);
    line.append(line.empty() ? 0 : 1, ',') += column.name;
  }
  return line;
}

template <class Row>
std::string line_of(const Columns<Row>& columns, const Row& row) {
  std::string line = columns.front().write(row);
  for (std::size_t k = 1; k < columns.size(); ++k) line.append(1, ',') += columns[k].write(row);
  return line;
}

/// Header and rows.
template <class Row, class Rows>
std::string table_text(const Columns<Row>& columns, const Rows& rows) {
  std::string text = header_of(columns) + "\n";
  for (const Row& row : rows) text += line_of(columns, row) + "\n";
  return text;
}

/// From fields in the order of the columns; empty where one is damaged.
template <class Row>
std::optional<Row> row_of(const Columns<Row>& columns, const std::vector<std::string>& fields) {
  if (fields.size() != columns.size()) return {};
  Row row{};
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!columns[k].read(row, fields[k])) return {};
  return row;
}

/// The rows of a file in which the columns stand in any order, among others; those that it lacks, as
/// tables of other versions do, leave their values as they are in a new row. Throws OutputError like read_csv, and naming line and column
/// of a field that is damaged.
template <class Row>
std::vector<Row> read_rows(const Columns<Row>& columns, const std::filesystem::path& path) {
  const CsvTable table = read_csv(path);
  std::vector<Row> rows(table.rows.size());
  for (const Column<Row>& column : columns)
    if (const auto at = table.find(column.name))
      for (std::size_t k = 0; k < rows.size(); ++k)
        if (const std::string& field = table.rows[k][*at]; !column.read(rows[k], field))
          throw OutputError(fmt::format("{}:{}: {} = '{}' is damaged: compute it again",
                                        path.string(), k + 2, column.name, field));
  return rows;
}

}  // namespace sbeh::studies

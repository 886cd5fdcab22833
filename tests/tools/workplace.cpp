#include "tests/tools/workplace.h"

#include "studies/io/csv.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace sbeh::tools::test {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t index_of(const Table& table, const std::string& column) {
  const auto at = std::find(table.columns.begin(), table.columns.end(), column);
  if (at == table.columns.end()) throw std::runtime_error("no column " + column);
  return std::size_t(at - table.columns.begin());
}

}  // namespace

std::string Table::text(std::size_t row, const std::string& column) const {
  return rows.at(row).at(index_of(*this, column));
}

double Table::number(std::size_t row, const std::string& column) const {
  double value = std::nan("");
  if (!studies::parse_number(text(row, column), value))
    throw std::runtime_error(column + ": no number");
  return value;
}

std::vector<double> Table::numbers(const std::string& column) const {
  std::vector<double> values;
  for (std::size_t row = 0; row < rows.size(); ++row) values.push_back(number(row, column));
  return values;
}

std::size_t Table::find(const std::string& model, const std::string& reduced_volume,
                        const std::string& L) const {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (text(row, "model") == model && text(row, "reduced_volume") == reduced_volume
        && text(row, "L") == L)
      return row;
  throw std::runtime_error("no row " + model + " " + reduced_volume + " " + L);
}

std::string Table::without(const std::string& column) const {
  const std::size_t left_out = index_of(*this, column);
  std::string text;
  const auto add = [&](const std::vector<std::string>& fields) {
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (k != left_out) text += studies::csv_field(fields[k]) + ",";
    text += "\n";
  };
  add(columns);
  for (const auto& row : rows) add(row);
  return text;
}

Workplace::Workplace() : folder_(top_.path() / "work") { fs::create_directory(folder_); }

fs::path Workplace::write(const std::string& name, const std::string& text) const {
  fs::create_directories(path(name).parent_path());
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

std::string Workplace::read(const std::string& name) const { return text_of(path(name)); }

Contents Workplace::contents(const std::string& name) const {
  Contents contents;
  for (const auto& entry : fs::recursive_directory_iterator(path(name))) {
    const std::string relative = entry.path().lexically_relative(path(name)).string();
    if (entry.is_directory())
      contents[relative + "/"];
    else
      contents[relative] = text_of(entry.path());
  }
  return contents;
}

Table Workplace::table(const std::string& name) const {
  std::istringstream text(read(name));
  Table table;
  std::string line;
  if (std::getline(text, line)) table.columns = studies::split_csv(line);
  while (std::getline(text, line)) {
    table.rows.push_back(studies::split_csv(line));
    EXPECT_EQ(table.rows.back().size(), table.columns.size()) << name << ": " << line;
  }
  return table;
}

int Workplace::lines(const std::string& name) const {
  const std::string text = read(name);
  return int(std::count(text.begin(), text.end(), '\n'));
}

std::vector<std::string> Workplace::into(const std::string& results, const std::string& command,
                                         const std::string& file) {
  return {command, file, "-o", results, "--no-pictures"};
}

void Workplace::must(const std::vector<std::string>& arguments) const {
  const Ended ended = sbeh(arguments);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
}

void Workplace::must_refuse(const std::vector<std::string>& arguments,
                            const std::string& start) const {
  const Ended ended = sbeh(arguments);
  EXPECT_EQ(ended.exit_code, 2) << ended.err;
  EXPECT_TRUE(ended.err.starts_with("sbeh: " + start)) << ended.err << "instead of\n" << start;
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  EXPECT_EQ(ended.out, "");
}

}  // namespace sbeh::tools::test

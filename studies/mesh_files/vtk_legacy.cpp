// VTK's legacy files: a header of text, then sections by keyword, in text or in big-endian numbers. Not read by VTK
// itself, which does not survive damaged ones.
#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"
#include "studies/mesh_files/vtk_cells.h"

#include <fmt/format.h>
#include <vtkCellType.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace sbeh::studies {

namespace {

constexpr std::string_view space = " \t\v\f\r\n";

// Goes through the words and numbers of the file.
class Reader {
 public:
  Reader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  void expect_binary() { is_binary_ = true; }

  /// The rest of the line, without its end.
  std::string_view line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end;
    pass_end_of_line();
    return line;
  }
  /// In small letters; empty at the end.
  std::string word() {
    std::string word(raw_word());
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return word;
  }
  BinaryNumber type();
  long count(std::string_view what);
  std::vector<double> numbers(long count, const BinaryNumber& type, std::string_view what);
  std::vector<long> integers(long count, const BinaryNumber& type, std::string_view what);
  /// What VTK notes of an array, up to an empty line.
  void pass_metadata() {
    line();
    while (at_ < text_.size() && line().find_first_not_of(space) != std::string_view::npos) {
    }
  }
  /// With the line, where the file is text.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  void pass_end_of_line() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
  }
  std::string_view raw_word() {
    at_ = std::min(text_.find_first_not_of(space, at_), text_.size());
    const std::size_t end = std::min(text_.find_first_of(space, at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }
  double text_number(std::string_view what) {
    const std::string_view text = raw_word();
    double value = 0;
    if (text.empty()) fail(fmt::format("the file ends here, in the middle of {}", what));
    if (!parse_number(text, value))
      fail(fmt::format("{}: \"{}\": must be a number", what, text.substr(0, 40)));
    return value;
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  bool is_binary_ = false;
};

BinaryNumber Reader::type() {
  static const std::map<std::string_view, BinaryNumber> known{
      {"char", binary<std::int8_t>},
      {"unsigned_char", binary<std::uint8_t>},
      {"short", binary<std::int16_t>},
      {"unsigned_short", binary<std::uint16_t>},
      {"int", binary<std::int32_t>},
      {"unsigned_int", binary<std::uint32_t>},
      {"long", binary<std::int64_t>},
      {"unsigned_long", binary<std::uint64_t>},
      {"vtktypeint64", binary<std::int64_t>},
      {"vtktypeuint64", binary<std::uint64_t>},
      {"vtkidtype", binary<std::int32_t>},
      {"float", binary<float>},
      {"double", binary<double>}};
  const std::string name = word();
  const auto found = known.find(name);
  if (found == known.end()) fail(fmt::format("\"{}\": unknown type", name.substr(0, 40)));
  return found->second;
}

long Reader::count(std::string_view what) {
  constexpr double most = std::numeric_limits<int>::max();
  const double value = text_number(what);
  if (!(value >= 0 && value <= most && value == std::floor(value)))
    fail(fmt::format("{}: {}: must be an integer, 0 or more", what, value));
  return long(value);
}

std::vector<double> Reader::numbers(long count, const BinaryNumber& type, std::string_view what) {
  if (is_binary_) pass_end_of_line();
  // A number in a text has a letter at least. No memory is taken for what cannot be there.
  const std::size_t least = is_binary_ ? type.size : 1, wanted = std::size_t(count);
  if (wanted > (text_.size() - at_) / least)
    fail(fmt::format("is cut off: {} must have {} numbers", what, count));
  std::vector<double> values(wanted);
  for (double& value : values) {
    if (!is_binary_) {
      value = text_number(what);
      continue;
    }
    value = type.value(text_.substr(at_, type.size), std::endian::big);
    at_ += type.size;
  }
  return values;
}

std::vector<long> Reader::integers(long count, const BinaryNumber& type, std::string_view what) {
  constexpr double most = std::numeric_limits<int>::max();
  std::vector<long> integers;
  for (const double value : numbers(count, type, what)) {
    if (!(std::abs(value) <= most && value == std::floor(value)))
      fail(fmt::format("{}: {}: must be an integer", what, value));
    integers.push_back(long(value));
  }
  return integers;
}

void Reader::fail(std::string_view what) const {
  if (is_binary_) throw InputError(fmt::format("{}: {}", file_, what));
  const std::string_view before = text_.substr(0, at_);
  const char end = text_.find('\n') == std::string_view::npos ? '\r' : '\n';
  throw InputError(fmt::format("{}:{}: {}", file_, 1 + std::ranges::count(before, end), what));
}

using Cells = std::vector<std::vector<long>>;

// Each has its number of points before them, or, from version 5 on, all have an array of where they begin.
Cells read_cells(Reader& reader, bool with_offsets, const std::string& what) {
  const long count = reader.count(what), size = reader.count(what);
  Cells cells;
  if (with_offsets) {
    const auto array = [&](long length, std::string_view name) {
      if (reader.word() != name) reader.fail(fmt::format("{}: must have {}", what, name));
      return reader.integers(length, reader.type(), what);
    };
    const std::vector<long> offsets = array(count, "offsets"), points = array(size, "connectivity");
    for (std::size_t i = 1; i < offsets.size(); ++i) {
      if (offsets[i - 1] < 0 || offsets[i] < offsets[i - 1] || offsets[i] > size)
        reader.fail(fmt::format("{}: cell {}: begins at {} and ends at {}, of {} numbers", what,
                                i - 1, offsets[i - 1], offsets[i], size));
      cells.emplace_back(points.begin() + offsets[i - 1], points.begin() + offsets[i]);
    }
    return cells;
  }
  const std::vector<long> numbers = reader.integers(size, binary<std::int32_t>, what);
  auto at = numbers.begin();
  for (long i = 0; i < count; ++i) {
    if (at == numbers.end() || *at < 0 || *at >= numbers.end() - at)
      reader.fail(
          fmt::format("{}: cell {}: has more points than the {} numbers say", what, i, size));
    cells.emplace_back(at + 1, at + 1 + *at);
    at += 1 + *at;
  }
  if (at != numbers.end())
    reader.fail(
        fmt::format("{}: {} cells have fewer points than the {} numbers say", what, count, size));
  return cells;
}

// Arrays beside the geometry, which are not read.
void pass_fields(Reader& reader) {
  reader.word();  // the name
  const long count = reader.count("field");
  for (long i = 0; i < count; ++i) {
    std::string name = reader.word();
    if (name == "metadata") {
      reader.pass_metadata();
      name = reader.word();
    }
    const long components = reader.count(name), tuples = reader.count(name);
    reader.numbers(components * tuples, reader.type(), name);
  }
}

struct Sections {
  std::vector<double> points;
  std::map<std::string, Cells> cells;  // by keyword
  std::vector<long> types;
};

// Up to the data on points and cells.
Sections read_sections(Reader& reader, bool with_offsets) {
  Sections sections;
  for (std::string word = reader.word(); !word.empty(); word = reader.word()) {
    if (word == "point_data" || word == "cell_data") break;
    if (word == "points") {
      const long count = reader.count(word);
      sections.points = reader.numbers(3 * count, reader.type(), word);
    } else if (word == "cell_types") {
      sections.types = reader.integers(reader.count(word), binary<std::int32_t>, word);
    } else if (word == "metadata") {
      reader.pass_metadata();
    } else if (word == "field") {
      pass_fields(reader);
    } else if (word == "vertices" || word == "lines" || word == "polygons"
               || word == "triangle_strips" || word == "cells") {
      sections.cells[word] = read_cells(reader, with_offsets, word);
    } else {
      reader.fail(fmt::format("\"{}\": unknown keyword", word.substr(0, 40)));
    }
  }
  return sections;
}

int type_of_polygon(std::size_t corners) {
  return corners == 3 ? VTK_TRIANGLE : corners == 4 ? VTK_QUAD : VTK_POLYGON;
}

// In the order in which VTK counts them.
std::vector<VtkCell> poly_data_cells(Sections& sections) {
  std::vector<VtkCell> cells;
  const auto add = [&](const char* keyword, auto type_of) {
    for (std::vector<long>& points : sections.cells[keyword])
      cells.push_back({type_of(points.size()), std::move(points)});
  };
  add("vertices", [](std::size_t) { return VTK_POLY_VERTEX; });
  add("lines", [](std::size_t) { return VTK_POLY_LINE; });
  add("polygons", type_of_polygon);
  add("triangle_strips", [](std::size_t) { return VTK_TRIANGLE_STRIP; });
  return cells;
}

std::vector<VtkCell> grid_cells(Sections& sections, const Reader& reader) {
  Cells& points = sections.cells["cells"];
  if (points.size() != sections.types.size())
    reader.fail(
        fmt::format("has {} cells but the types of {}", points.size(), sections.types.size()));
  std::vector<VtkCell> cells;
  for (std::size_t t = 0; t < points.size(); ++t)
    cells.push_back({int(sections.types[t]), std::move(points[t])});
  return cells;
}

}  // namespace

MeshFile parse_vtk_legacy(std::string_view text, const std::string& file) {
  Reader reader(text, file);
  const std::string_view header = reader.line();
  const std::size_t version = header.find_first_of("0123456789");
  const bool with_offsets = version != std::string_view::npos && header[version] >= '5';
  reader.line();  // the title
  const std::string encoding = reader.word();
  if (encoding != "ascii" && encoding != "binary")
    reader.fail(fmt::format("\"{}\": must be ASCII or BINARY", encoding.substr(0, 40)));
  if (encoding == "binary") reader.expect_binary();
  if (reader.word() != "dataset") reader.fail("must go on with DATASET");
  const std::string kind = reader.word();
  if (kind != "polydata" && kind != "unstructured_grid")
    reader.fail(
        fmt::format("holds \"{}\", not POLYDATA or UNSTRUCTURED_GRID: export the surface alone",
                    kind.substr(0, 40)));
  Sections sections = read_sections(reader, with_offsets);
  const std::vector<VtkCell> cells =
      kind == "polydata" ? poly_data_cells(sections) : grid_cells(sections, reader);
  const Eigen::Map<const Eigen::Matrix3Xd> points(sections.points.data(), 3,
                                                  Eigen::Index(sections.points.size() / 3));
  return mesh_of(points, cells, file);
}

MeshFile parse_vtk(std::string_view text, const std::string& file) {
  constexpr std::string_view mark = "\xef\xbb\xbf";  // of UTF-8
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return is_word(text.substr(0, 5), "# vtk") ? parse_vtk_legacy(text, file)
                                             : parse_vtk_xml(text, file);
}

}  // namespace sbeh::studies

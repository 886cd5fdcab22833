// PLY: a header that says what follows; text or binary of either byte order.
#include "studies/io/errors.h"
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <optional>

namespace sbeh::studies {

namespace {

using Number = BinaryNumber;

std::optional<Number> number_of(std::string_view word) {
  static const std::map<std::string_view, Number> known{
      {"char", binary<std::int8_t>},     {"int8", binary<std::int8_t>},
      {"uchar", binary<std::uint8_t>},   {"uint8", binary<std::uint8_t>},
      {"short", binary<std::int16_t>},   {"int16", binary<std::int16_t>},
      {"ushort", binary<std::uint16_t>}, {"uint16", binary<std::uint16_t>},
      {"int", binary<std::int32_t>},     {"int32", binary<std::int32_t>},
      {"uint", binary<std::uint32_t>},   {"uint32", binary<std::uint32_t>},
      {"float", binary<float>},          {"float32", binary<float>},
      {"double", binary<double>},        {"float64", binary<double>}};
  const auto found = known.find(word);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

struct Property {
  std::string name;
  Number type{};
  std::optional<Number> count;  // of a list
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::optional<std::endian> order;  // none: text
  std::vector<Element> elements;
};

void read_property(const TextLines& lines, Header& header) {
  const auto& words = lines.words();
  if (header.elements.empty()) lines.fail("a property before the first element");
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) lines.fail("must be: property TYPE NAME");
  Property property{.name = std::string(words.back()), .count = {}};
  const auto type = [&](std::string_view word) {
    const auto number = number_of(word);
    if (!number) lines.fail(fmt::format("\"{}\": unknown type", word.substr(0, 40)));
    return *number;
  };
  property.type = type(words[words.size() - 2]);
  if (list) property.count = type(words[2]);
  header.elements.back().properties.push_back(property);
}

Header read_header(TextLines& lines) {
  lines.require_next("the header");
  if (!is_word(lines.words()[0], "ply")) lines.fail("must begin with ply");
  Header header;
  for (;;) {
    lines.require_next("the header");
    const auto& words = lines.words();
    if (words[0] == "end_header") return header;
    if (words[0] == "format") {
      const std::string_view format = words.size() > 1 ? words[1] : "";
      if (format == "binary_little_endian")
        header.order = std::endian::little;
      else if (format == "binary_big_endian")
        header.order = std::endian::big;
      else if (format != "ascii")
        lines.fail("unknown format; known: ascii, binary_*_endian");
    } else if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({std::string(words[1]), lines.integer(2), {}});
      if (header.elements.back().count < 0) lines.fail("a count must be >= 0");
    } else if (words[0] == "property") {
      read_property(lines, header);
    } else if (words[0] != "comment" && words[0] != "obj_info" && words[0] != "comments") {
      lines.fail(fmt::format("\"{}\": is not part of a PLY header", words[0].substr(0, 40)));
    }
  }
}

// The numbers of the body one after the other.
class Body {
 public:
  Body(TextLines& lines, const Header& header, std::string file)
      : bytes_(lines.rest()), lines_(lines), order_(header.order), file_(std::move(file)) {}

  void start(const Element& element, long index) {
    where_ = fmt::format("{} {} of {}", element.name, index, element.count);
    if (order_ || element.properties.empty()) return;
    lines_.require_next(where_);
    word_ = 0;
  }

  double number(const Number& type) {
    if (!order_) {
      lines_.require_words(word_ + 1, where_);
      return lines_.number(word_++);
    }
    if (bytes_.size() < type.size) fail("the file ends in the middle of it");
    const double value = type.value(bytes_, *order_);
    bytes_.remove_prefix(type.size);
    return value;
  }

  bool goes_on() { return order_ ? !bytes_.empty() : lines_.next(); }

  [[noreturn]] void fail(std::string_view what) const {
    if (!order_) lines_.fail(what);
    throw InputError(fmt::format("{}: {}: {}", file_, where_, what));
  }

 private:
  std::string_view bytes_;
  TextLines& lines_;
  std::optional<std::endian> order_;
  std::string file_, where_;
  std::size_t word_ = 0;
};

void skip(Body& body, const Property& property) {
  long count = property.count ? long(body.number(*property.count)) : 1;
  while (count-- > 0) body.number(property.type);
}

// 0, 1, 2 for x, y, z.
int axis_of(const Property& p) {
  constexpr std::string_view axes = "xyz";
  const auto at = p.name.size() == 1 && !p.count
                    ? axes.find(char(std::tolower(static_cast<unsigned char>(p.name[0]))))
                    : std::string_view::npos;
  return at == std::string_view::npos ? -1 : int(at);
}

void read_point(Body& body, const Element& element, MeshBuilder& mesh) {
  std::array<double, 3> x{};
  for (const Property& p : element.properties)
    if (const int axis = axis_of(p); axis >= 0)
      x[std::size_t(axis)] = body.number(p.type);
    else
      skip(body, p);
  mesh.add_point(x[0], x[1], x[2]);
}

bool is_corners(const Property& p) {
  return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
}

// The list of corners: by its name, or the only list there is; null if there is none.
const Property* corners_of(const Element& element) {
  const auto named = std::ranges::find_if(element.properties, is_corners);
  if (named != element.properties.end()) return &*named;
  const auto is_list = [](const Property& p) { return p.count.has_value(); };
  if (std::ranges::count_if(element.properties, is_list) != 1) return nullptr;
  return &*std::ranges::find_if(element.properties, is_list);
}

// Numbers of points, at most the last of them; -1, which ends a strip, where that is allowed.
std::vector<int> read_corners(Body& body, const Property& list, long points, bool strips) {
  std::vector<int> corners;
  for (long k = long(body.number(*list.count)); k > 0; --k) {
    const double value = body.number(list.type);
    if (!(value >= (strips ? -1 : 0) && value < double(points)))
      body.fail(fmt::format("corner {}: must be in 0 ... {}", value, points - 1));
    corners.push_back(int(value));
  }
  return corners;
}

// Each point with the two before it; every other triangle goes round the other way.
void add_strips(const std::vector<int>& strips, MeshBuilder& mesh) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (strips[i] < 0) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool even = (i - begin) % 2 == 0;
      mesh.add_face({strips[i - (even ? 2 : 1)], strips[i - (even ? 1 : 2)], strips[i]});
    }
  }
}

void read_face(Body& body, const Element& element, const Property& list, long points,
               MeshBuilder& mesh) {
  const bool strips = element.name == "tristrips";
  for (const Property& p : element.properties) {
    if (&p != &list) {
      skip(body, p);
      continue;
    }
    std::vector<int> corners = read_corners(body, p, points, strips);
    if (strips)
      add_strips(corners, mesh);
    else if (corners.size() < 3)
      body.fail(fmt::format("a face with {} corners: must have three", corners.size()));
    else
      mesh.add_face(std::move(corners));
  }
}

bool has_name(const Element& element, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, std::string_view(element.name)) != names.end();
}
bool has_points(const Element& element) { return has_name(element, {"vertex", "vertices"}); }
bool has_faces(const Element& element) { return has_name(element, {"face", "faces", "tristrips"}); }

// How many points there are, which faces may come before; all that is needed must be there.
long count_points(const Header& header, const TextLines& lines) {
  long points = 0;
  for (const Element& element : header.elements) {
    if (has_faces(element) && !corners_of(element))
      lines.fail(fmt::format("{}: must have a list vertex_indices", element.name));
    if (!has_points(element)) continue;
    points += element.count;
    for (int axis = 0; axis < 3; ++axis)
      if (std::ranges::count(element.properties, axis, axis_of) != 1)
        lines.fail(fmt::format("the points must have one property {}", "xyz"[axis]));
  }
  return points;
}

}  // namespace

MeshFile parse_ply(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const Header header = read_header(lines);
  const long points = count_points(header, lines);
  Body body(lines, header, file);
  MeshBuilder mesh;
  for (const Element& element : header.elements) {
    const Property* corners = has_faces(element) ? corners_of(element) : nullptr;
    for (long i = 0; i < element.count; ++i) {
      body.start(element, i);
      if (has_points(element))
        read_point(body, element, mesh);
      else if (corners)
        read_face(body, element, *corners, points, mesh);
      else
        for (const Property& p : element.properties) skip(body, p);
    }
  }
  MeshFile result{PlainFile{mesh.mesh()}, {}};
  if (body.goes_on())
    result.notes.emplace_back("what follows the last of the elements of its header left out");
  return result;
}

std::string ply_text(const meshing::TriangleMesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.point_count(), mesh.triangle_count());
  for (const double x : mesh.points.reshaped()) append_number(text, x);
  for (const auto c : mesh.triangles.colwise()) {
    append_number(text, std::uint8_t(3));
    for (const int corner : c) append_number(text, std::int32_t(corner));
  }
  return text;
}

}  // namespace sbeh::studies

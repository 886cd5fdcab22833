// PLY: a header that says what follows; text or binary of either byte order.
#include "studies/io/errors.h"
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>

namespace sbeh::studies {

namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Number> number_of(std::string_view word) {
  static const std::map<std::string_view, Number> known{
      {"char", Number::int8},      {"int8", Number::int8},       {"uchar", Number::uint8},
      {"uint8", Number::uint8},    {"short", Number::int16},     {"int16", Number::int16},
      {"ushort", Number::uint16},  {"uint16", Number::uint16},   {"int", Number::int32},
      {"int32", Number::int32},    {"uint", Number::uint32},     {"uint32", Number::uint32},
      {"float", Number::float32},  {"float32", Number::float32}, {"double", Number::float64},
      {"float64", Number::float64}};
  const auto found = known.find(word);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

struct Property {
  std::string name;
  Number type = Number::float32;
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
  if (lines.words()[0] != "ply") lines.fail("must begin with ply");
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
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      lines.fail(fmt::format("\"{}\": is not part of a PLY header", words[0].substr(0, 40)));
    }
  }
}

// The numbers of the body one after the other.
class Body {
 public:
  Body(std::string_view text, TextLines& lines, const Header& header, std::string file)
      : bytes_(text.substr(lines.position())),
        lines_(lines),
        order_(header.order),
        file_(std::move(file)) {}

  void start(const Element& element, long index) {
    where_ = fmt::format("{} {} of {}", element.name, index, element.count);
    if (order_) return;
    lines_.require_next(where_);
    word_ = 0;
  }

  double number(Number type) {
    if (!order_) return lines_.number(word_++);
    switch (type) {
      case Number::int8:
        return take<std::int8_t>();
      case Number::uint8:
        return take<std::uint8_t>();
      case Number::int16:
        return take<std::int16_t>();
      case Number::uint16:
        return take<std::uint16_t>();
      case Number::int32:
        return take<std::int32_t>();
      case Number::uint32:
        return take<std::uint32_t>();
      case Number::float32:
        return take<float>();
      case Number::float64:
        return take<double>();
    }
    return 0;
  }

  [[noreturn]] void fail(std::string_view what) const {
    if (!order_) lines_.fail(what);
    throw InputError(fmt::format("{}: {}: {}", file_, where_, what));
  }

 private:
  template <class T>
  double take() {
    if (bytes_.size() < sizeof(T)) fail("the file ends in the middle of it");
    const T value = number_from<T>(bytes_, *order_);
    bytes_.remove_prefix(sizeof(T));
    return double(value);
  }

  std::string_view bytes_;
  TextLines& lines_;
  std::optional<std::endian> order_;
  std::string file_, where_;
  std::size_t word_ = 0;
};

void read_point(Body& body, const Element& element, MeshBuilder& mesh) {
  std::array<double, 3> x{};
  for (const Property& p : element.properties) {
    if (p.count) {
      for (auto n = long(body.number(*p.count)); n > 0; --n) body.number(p.type);
      continue;
    }
    const double value = body.number(p.type);
    if (p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z')
      x[std::size_t(p.name[0] - 'x')] = value;
  }
  mesh.add_point(x[0], x[1], x[2]);
}

void read_face(Body& body, const Element& element, MeshBuilder& mesh) {
  for (const Property& p : element.properties) {
    const bool corners = p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
    const long count = p.count ? long(body.number(*p.count)) : 1;
    if (corners && count != 3)
      body.fail(fmt::format("a face with {} corners: must be a triangle", count));
    std::array<int, 3> corner{};
    for (long k = 0; k < count; ++k) {
      const double value = body.number(p.type);
      if (!corners) continue;
      if (!(value >= 0 && value < double(mesh.point_count())))
        body.fail(fmt::format("corner {}: must be in 0 ... {}", value, mesh.point_count() - 1));
      corner[std::size_t(k)] = int(value);
    }
    if (corners) mesh.add_triangle(corner[0], corner[1], corner[2]);
  }
}

}  // namespace

meshing::TriangleMesh parse_ply(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const Header header = read_header(lines);
  Body body(text, lines, header, file);
  MeshBuilder mesh;
  for (const Element& element : header.elements)
    for (long i = 0; i < element.count; ++i) {
      body.start(element, i);
      if (element.name == "vertex")
        read_point(body, element, mesh);
      else if (element.name == "face")
        read_face(body, element, mesh);
      else
        for (const Property& p : element.properties) {
          long count = p.count ? long(body.number(*p.count)) : 1;
          while (count-- > 0) body.number(p.type);
        }
    }
  return mesh.mesh();
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

#include "tools/picture/canvas/outlines.h"

#include "tools/picture/canvas/canvas.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <stdexcept>
#include <utility>

namespace sbeh::picture {
namespace {

// The font, in its own units: nothing is fitted to pixels.
FT_Face open_face() {
  static FT_Library library = nullptr;
  FT_Face face = nullptr;
  if (font_file().empty() || FT_Init_FreeType(&library) != 0
      || FT_New_Face(library, font_file().c_str(), 0, &face) != 0)
    throw std::runtime_error(
        "a PDF needs the font DejaVu Sans: install the package fonts-dejavu-core.");
  return face;
}

// The path of letters so far, and where the next one begins.
struct Pen {
  std::string path;
  double x = 0.0, scale = 1.0;
  std::array<double, 2> at{};

  std::array<double, 2> place(const FT_Vector* p) const {
    return {x + scale * double(p->x), scale * double(p->y)};
  }
  void add(const std::array<double, 2>& p) { path += fmt::format("{:.4f} {:.4f} ", p[0], p[1]); }
  void go(const FT_Vector* to, const char* how) {
    add(at = place(to));
    path += how;
  }
};

Pen& pen_of(void* user) { return *static_cast<Pen*>(user); }

int move_to(const FT_Vector* to, void* user) {
  pen_of(user).go(to, "m ");
  return 0;
}
int line_to(const FT_Vector* to, void* user) {
  pen_of(user).go(to, "l ");
  return 0;
}
// As a curve of third order.
int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  Pen& pen = pen_of(user);
  const auto middle = pen.place(control);
  for (const auto& end : {pen.at, pen.place(to)})
    pen.add({end[0] + 2.0 / 3 * (middle[0] - end[0]), end[1] + 2.0 / 3 * (middle[1] - end[1])});
  pen.go(to, "c ");
  return 0;
}
int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
  Pen& pen = pen_of(user);
  pen.add(pen.place(first));
  pen.add(pen.place(second));
  pen.go(to, "c ");
  return 0;
}

// Code points of UTF-8.
std::u32string code_points(const std::string& text) {
  std::u32string points;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if ((value & 0xC0u) == 0x80u && !points.empty())
      points.back() = points.back() << 6u | (value & 0x3Fu);
    else
      points += value < 0x80u ? value
              : value < 0xE0u ? value & 0x1Fu
              : value < 0xF0u ? value & 0x0Fu
                              : value & 0x07u;
  }
  return points;
}

}  // namespace

Outlines outlines_of(const std::string& text) {
  static FT_Face face = open_face();
  Pen pen{.path = {}, .x = 0.0, .scale = 1.0 / face->units_per_EM, .at = {}};
  const FT_Outline_Funcs ways{move_to, line_to, conic_to, cubic_to, 0, 0};
  for (const char32_t letter : code_points(text)) {
    if (FT_Load_Char(face, letter, FT_LOAD_NO_SCALE) != 0) continue;
    FT_Outline_Decompose(&face->glyph->outline, &ways, &pen);
    pen.x += pen.scale * double(face->glyph->advance.x);
  }
  return {std::move(pen.path), pen.x};
}

}  // namespace sbeh::picture

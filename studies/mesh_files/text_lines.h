// Going through the lines and words of a mesh file, with the place for messages.
#pragma once

#include "meshing/triangle_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

class TextLines {
 public:
  TextLines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next line that holds a word; `#` begins a comment. False at the end of the text.
  bool next();
  /// As `next`; at the end throws that the file ends within `what`.
  void require_next(std::string_view what);
  const std::vector<std::string_view>& words() const { return words_; }
  /// Bytes before the next line.
  std::size_t position() const { return position_; }

  /// The word as a number; `nan` and `inf` are numbers here. Throws for anything else and for words
  /// that are not there.
  double number(std::size_t word) const;
  long integer(std::size_t word) const;

  /// Throws InputError "file:line: what".
  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0;
  int line_ = 0;
  std::vector<std::string_view> words_;
};

/// Points and triangles as they come.
class MeshBuilder {
 public:
  void add_point(double x, double y, double z) { points_.insert(points_.end(), {x, y, z}); }
  void add_triangle(int a, int b, int c) { triangles_.insert(triangles_.end(), {a, b, c}); }
  long point_count() const { return long(points_.size() / 3); }
  long triangle_count() const { return long(triangles_.size() / 3); }
  meshing::TriangleMesh mesh() const;

 private:
  std::vector<double> points_;
  std::vector<int> triangles_;
};

}  // namespace sbeh::studies

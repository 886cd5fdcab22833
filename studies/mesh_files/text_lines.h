// Going through the lines and words of a mesh file, with the place for messages.
#pragma once

#include "meshing/polygon_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Lines end as they do on Unix, Windows or old Macs; `#` begins a comment; a mark of UTF-8 is passed over.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file);

  /// The next line that holds a word. False at the end of the text.
  bool next();
  /// As `next`; at the end throws that the file ends within `what`.
  void require_next(std::string_view what);
  /// Takes words of following lines until there are so many: for what may be wrapped.
  void require_words(std::size_t count, std::string_view what);
  const std::vector<std::string_view>& words() const { return words_; }
  /// The rest of the text after the line.
  std::string_view rest() const { return text_.substr(position_); }

  /// The word as a number; `nan` and `inf` are numbers here. Throws for anything else and for words
  /// that are not there.
  double number(std::size_t word) const;
  long integer(std::size_t word) const;

  /// Throws InputError "file:line: what".
  [[noreturn]] void fail(std::string_view what) const;

 private:
  bool append_next();

  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0;
  int line_ = 0;
  std::vector<std::string_view> words_;
};

/// Whether a word is this one, in capitals or not.
bool is_word(std::string_view word, std::string_view small_letters);

/// Points and faces as they come.
class MeshBuilder {
 public:
  void add_point(double x, double y, double z) { points_.insert(points_.end(), {x, y, z}); }
  void add_face(std::vector<int> corners) { faces_.push_back(std::move(corners)); }
  long point_count() const { return long(points_.size() / 3); }
  const std::vector<std::vector<int>>& faces() const { return faces_; }
  /// Numbers points and faces as they came.
  meshing::PolygonMesh mesh() const;

 private:
  std::vector<double> points_;
  std::vector<std::vector<int>> faces_;
};

}  // namespace sbeh::studies

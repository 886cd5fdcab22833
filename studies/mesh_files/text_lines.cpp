#include "studies/mesh_files/text_lines.h"

#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/io/spelling.h"

#include <fmt/format.h>

#include <charconv>

namespace sbeh::studies {

bool TextLines::next() {
  while (position_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    ++line_;
    line = line.substr(0, line.find('#'));
    words_.clear();
    constexpr std::string_view space = " \t\r\v\f";
    for (std::size_t at = line.find_first_not_of(space); at != std::string_view::npos;) {
      const std::size_t stop = std::min(line.find_first_of(space, at), line.size());
      words_.push_back(line.substr(at, stop - at));
      at = line.find_first_not_of(space, stop);
    }
    if (!words_.empty()) return true;
  }
  words_.clear();
  return false;
}

void TextLines::require_next(std::string_view what) {
  if (!next()) fail(fmt::format("the file ends here, in the middle of {}", what));
}

double TextLines::number(std::size_t word) const {
  if (word >= words_.size()) fail(fmt::format("has {} words, too few", words_.size()));
  double value = 0;
  std::string_view text = words_[word];
  if (text.starts_with('+')) text.remove_prefix(1);
  if (!parse_number(text, value))
    fail(fmt::format("{}: must be a number", in_quotes(words_[word].substr(0, 40))));
  return value;
}

long TextLines::integer(std::size_t word) const {
  if (word >= words_.size()) fail(fmt::format("has {} words, too few", words_.size()));
  const std::string_view text = words_[word];
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(fmt::format("{}: must be an integer", in_quotes(text.substr(0, 40))));
  return value;
}

void TextLines::fail(std::string_view what) const {
  throw InputError(fmt::format("{}:{}: {}", file_, line_, what));
}

meshing::TriangleMesh MeshBuilder::mesh() const {
  return {Eigen::Map<const Eigen::Matrix3Xd>(points_.data(), 3, point_count()),
          Eigen::Map<const Eigen::Matrix3Xi>(triangles_.data(), 3, triangle_count())};
}

}  // namespace sbeh::studies

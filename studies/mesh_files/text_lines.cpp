#include "studies/mesh_files/text_lines.h"

#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/io/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace sbeh::studies {

TextLines::TextLines(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

bool TextLines::append_next() {
  const std::size_t before = words_.size();
  while (position_ < text_.size()) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
    std::string_view line = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    if (position_ < text_.size() && text_[end] == '\r' && text_[position_] == '\n') ++position_;
    ++line_;
    line = line.substr(0, line.find('#'));
    constexpr std::string_view space = " \t\v\f\x1a";  // the last ends a text of DOS
    for (std::size_t at = line.find_first_not_of(space); at != std::string_view::npos;) {
      const std::size_t stop = std::min(line.find_first_of(space, at), line.size());
      words_.push_back(line.substr(at, stop - at));
      at = line.find_first_not_of(space, stop);
    }
    if (words_.size() > before) return true;
  }
  return false;
}

bool TextLines::next() {
  words_.clear();
  return append_next();
}

void TextLines::require_next(std::string_view what) {
  if (!next()) fail(fmt::format("the file ends here, in the middle of {}", what));
}

void TextLines::require_words(std::size_t count, std::string_view what) {
  while (words_.size() < count)
    if (!append_next()) fail(fmt::format("the file ends here, in the middle of {}", what));
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

bool is_word(std::string_view word, std::string_view small_letters) {
  return std::ranges::equal(word, small_letters,
                            [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

meshing::PolygonMesh MeshBuilder::mesh() const {
  return {Eigen::Map<const Eigen::Matrix3Xd>(points_.data(), 3, point_count()),
          faces_,
          {meshing::counted(int(point_count())), meshing::counted(int(faces_.size()))}};
}

}  // namespace sbeh::studies

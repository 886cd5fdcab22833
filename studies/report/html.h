// Pieces of a page of HTML that needs nothing but itself.
#pragma once

#include "studies/io/csv.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies::html {

/// The text with &, <, >, quotes as entities and control characters but line ends and tabs replaced.
std::string escaped(std::string_view text);

/// Base64 of these bytes.
std::string base64(std::string_view bytes);

/// A number with at most nine digits, its full text kept in the element; other text escaped.
std::string value(std::string_view text);

/// <NAME>escaped text</NAME>
std::string element(std::string_view name, std::string_view text);

/// Pairs of a name and a value in HTML.
struct Fact {
  std::string name;   ///< plain text
  std::string value;  ///< HTML
};
std::string facts(const std::vector<Fact>& facts);

/// The rows of a table, columns of numbers to the right; of more than `most` rows so many, evenly spread
/// with the first and the last, and a line that says so, with a link to `file`. Rows with the same `reduced_volume` are
/// shown together or not at all, but in histories (`time`); none where those of one are more than `most`.
std::string table(const CsvTable& table, std::size_t most, std::string_view file);

/// A figure with the picture inside the page. Throws OutputError when the file cannot be read.
std::string figure(const std::filesystem::path& picture, std::string_view caption);

/// A link to a file beside the page.
std::string link(std::string_view file);

/// <section> with a heading.
std::string section(std::string_view title, std::string_view content);

/// The whole page; `generator` is what a later report recognises it by.
std::string page(std::string_view title, std::string_view generator, std::string_view body);

}  // namespace sbeh::studies::html

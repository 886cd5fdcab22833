// What the script of a live page reads: named parts, packed into an element of the page.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Parts of text and of numbers. Packed they are a table of their names, types and sizes, an empty line, and their
/// bytes one after the other; of numbers first the lowest byte of each, then the next, which is shorter compressed.
class Bundle {
 public:
  void add(std::string_view name, std::string_view text);
  void add(std::string_view name, const std::vector<std::uint16_t>& numbers);
  void add(std::string_view name, const std::vector<std::uint32_t>& numbers);

  /// <script type="application/octet-stream" id="sbeh-data">, all of it as zlib's stream, with its checksum, in base64.
  std::string element() const;

 private:
  void add_bytes(std::string_view name, std::string_view type, const std::string& bytes);

  std::string index_ = "name,type,bytes\n", bytes_;
};

/// Numbers in 16 bits: 0 … 65534 from the least to the largest.
struct NumberRange {
  double low = 0, high = 0;
  bool empty = true;

  void include(double value);  ///< unless it is not finite
};
inline constexpr std::uint16_t quantised_unknown = 65535;
/// `quantised_unknown` of what is not finite.
std::uint16_t quantised(double value, const NumberRange& range);

/// Each but the first `stride` numbers less the one `stride` before it, modulo 65536.
std::vector<std::uint16_t> differences(const std::vector<std::uint16_t>& numbers,
                                       std::size_t stride);

}  // namespace sbeh::studies

// Numbers in binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

namespace sbeh::studies {

/// The number at the first bytes of `bytes`, which must hold that many.
template <class T>
T number_from(std::string_view bytes, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> copy;
  std::copy_n(bytes.begin(), sizeof(T), copy.begin());
  if (order != std::endian::native) std::reverse(copy.begin(), copy.end());
  T value;
  std::memcpy(&value, copy.data(), sizeof(T));
  return value;
}

/// How numbers of one type stand in a binary file.
struct BinaryNumber {
  std::size_t size;  ///< bytes
  double (*value)(std::string_view bytes, std::endian order);
};
template <class T>
constexpr BinaryNumber binary{sizeof(T), [](std::string_view bytes, std::endian order) {
                                return double(number_from<T>(bytes, order));
                              }};

/// Appends the bytes of a number, little-endian.
template <class T>
void append_number(std::string& bytes, T value) {
  std::array<char, sizeof(T)> copy;
  std::memcpy(copy.data(), &value, sizeof(T));
  if (std::endian::native != std::endian::little) std::reverse(copy.begin(), copy.end());
  bytes.append(copy.data(), copy.size());
}

}  // namespace sbeh::studies

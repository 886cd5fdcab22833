#include "studies/report/bundle.h"

#include "studies/report/html.h"

#include <fmt/format.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::studies {

namespace {

std::string compressed(const std::string& bytes) {
  vtkNew<vtkZLibDataCompressor> zlib;
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  std::string packed(zlib->GetMaximumCompressionSpace(bytes.size()), '\0');
  packed.resize(zlib->Compress(from, bytes.size(), reinterpret_cast<unsigned char*>(packed.data()),
                               packed.size()));
  if (packed.empty()) throw std::runtime_error("the data of the page cannot be compressed");
  return packed;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (std::size_t place = 0; place < sizeof(Number); ++place)
    for (const Number number : numbers) bytes += char(number >> (8 * place) & 0xff);
  return bytes;
}

}  // namespace

void Bundle::add_bytes(std::string_view name, std::string_view type, const std::string& bytes) {
  index_ += fmt::format("{},{},{}\n", name, type, bytes.size());
  bytes_ += bytes;
}

void Bundle::add(std::string_view name, std::string_view text) {
  add_bytes(name, "text", std::string(text));
}
void Bundle::add(std::string_view name, const std::vector<std::uint16_t>& numbers) {
  add_bytes(name, "u16", bytes_of(numbers));
}
void Bundle::add(std::string_view name, const std::vector<std::uint32_t>& numbers) {
  add_bytes(name, "u32", bytes_of(numbers));
}

std::string Bundle::element() const {
  return fmt::format("<script type=\"application/octet-stream\" id=\"sbeh-data\">{}</script>\n",
                     html::base64(compressed(index_ + "\n" + bytes_)));
}

void NumberRange::include(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

std::uint16_t quantised(double value, const NumberRange& range) {
  constexpr double steps = quantised_unknown - 1;
  if (!std::isfinite(value)) return quantised_unknown;
  const double width = range.high - range.low;
  const double part = width > 0 ? (value - range.low) / width : 0;
  return std::uint16_t(std::lround(steps * std::clamp(part, 0., 1.)));
}

std::vector<std::uint16_t> differences(const std::vector<std::uint16_t>& numbers,
                                       std::size_t stride) {
  std::vector<std::uint16_t> result = numbers;
  for (std::size_t k = stride; k < numbers.size(); ++k)
    result[k] = std::uint16_t(numbers[k] - numbers[k - stride]);
  return result;
}

}  // namespace sbeh::studies

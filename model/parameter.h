// Parameters that a user may set. Each has one line in the table of its struct, a function
//   for_each_parameter(struct, visit)   calls visit(Parameter, member) for every one, in the order of files,
// from which files are read, checked and written. Its default is the member's.
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace sbeh::model {

/// The finite numbers that are allowed.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not allowed

  bool contains(double value) const;
  /// As in "must be > 0 and <= 1".
  std::string text() const;
};
inline constexpr Interval any_number{};
constexpr Interval above(double low) { return {.low = low, .low_open = true}; }
constexpr Interval at_least(double low) { return {.low = low}; }
constexpr Interval between(double low, double high) { return {.low = low, .high = high}; }

struct Parameter {
  const char*
      name;  ///< in files; that of the member, but for powers that stand for a function of that name
  Interval allowed;     ///< of numbers
  const char* meaning;  ///< with its letter, and its unit where it has one
};

/// What the table of a struct takes: the struct, or a constant one.
template <class T, class Struct>
concept maybe_const = std::same_as<std::remove_const_t<T>, Struct>;
/// `Base`, constant where T is.
template <class Base, class T>  // NOLINTNEXTLINE(readability-identifier-naming): as in std
using const_as = std::conditional_t<std::is_const_v<T>, const Base, Base>;

/// Throws std::invalid_argument, "name = value: must be …", unless the number is finite and allowed.
void check(const Parameter& parameter, double value);

/// Checks all numbers of a struct that has a table.
template <class Struct>
void check_parameters(const Struct& of) {
  for_each_parameter(of, [](const Parameter& parameter, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::same_as<Value, double> || std::same_as<Value, int>)
      check(parameter, value);
    else if constexpr (std::same_as<Value, std::optional<double>>)
      if (value) check(parameter, *value);
  });
}

}  // namespace sbeh::model

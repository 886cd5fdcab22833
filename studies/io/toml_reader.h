// Strict reading of TOML files: values by key, with kind and allowed range; no key goes unread.
#pragma once

#include "axisym/start_shapes.h"
#include "meshing/spherical_harmonics.h"
#include "model/names.h"
#include "model/parameter.h"
#include "studies/io/errors.h"
#include "studies/io/scales.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

using model::above;
using model::at_least;
using model::between;
using model::Interval;
inline constexpr Interval reduced_volumes{.low = 0, .high = 1, .low_open = true};

enum class Spacing { linear, logarithmic };

/// `count` >= 1 values from `low` to `high`: the ends exact, those between rounded to 12 digits.
/// Logarithmic: equal ratios, `low` > 0. count = 1: just `low`.
std::vector<double> evenly_spaced(double low, double high, int count, Spacing spacing);

struct TableState;

/// One table of a file. A key that is absent gives `absent`; without `absent` it is an error.
/// Every function throws InputError at the line of what is wrong. Copies share their memory of
/// the keys that were asked for.
class TomlTable {
 public:
  explicit TomlTable(std::shared_ptr<TableState> state) : state_(std::move(state)) {}

  /// From now on numbers whose keys have a dimension (dimension_of_key) may be texts with a unit, as in "2 s".
  void measured_by(const std::optional<Scales>& scales) const;

  /// Whether the key is there, whatever its value; counts as asking for it.
  bool has(std::string_view key) const;

  /// A finite number, integers included.
  double number(std::string_view key, const Interval& allowed = {},
                std::optional<double> absent = {}) const;
  /// The same where it stands for another quantity, whose unit it may have.
  double number_as(std::string_view quantity, std::string_view key, const Interval& allowed) const;
  /// A number that may be infinite.
  double number_or_infinity(std::string_view key, const Interval& allowed) const;
  int integer(std::string_view key, int low, int high, std::optional<int> absent = {}) const;
  bool boolean(std::string_view key, std::optional<bool> absent = {}) const;
  /// A text that is not empty.
  std::string text(std::string_view key, std::optional<std::string> absent = {}) const;
  /// The text as a path, from where `path_from` finds it.
  std::string path(std::string_view key) const;
  /// One of the known words.
  std::string word(std::string_view key, const std::vector<std::string>& known,
                   std::optional<std::string> absent = {}) const;
  /// A list of known words in the order of the file, not empty, none twice.
  std::vector<std::string> words(std::string_view key, const std::vector<std::string>& known,
                                 std::optional<std::vector<std::string>> absent = {}) const;
  /// The value of an enumeration (model/names.h) with that name, out of `known`.
  template <class Known, class E = typename Known::value_type>
  E choice(std::string_view key, const Known& known, std::optional<E> absent = {}) const {
    const auto absent_word = absent ? std::optional<std::string>(name(*absent)) : std::nullopt;
    return *value_named<E>(word(key, names_of(known), absent_word));
  }
  /// The same for a list, not empty, none twice.
  template <class Known, class E = typename Known::value_type>
  std::vector<E> choices(std::string_view key, const Known& known,
                         std::optional<std::vector<E>> absent = {}) const {
    if (absent && !has(key)) return *absent;
    std::vector<E> values;
    for (const std::string& one : words(key, names_of(known)))
      values.push_back(*value_named<E>(one));
    return values;
  }
  /// A list of numbers in the order of the file, not empty.
  std::vector<double> numbers(std::string_view key, const Interval& allowed = {}) const;
  /// Values to go through, ascending, none twice: a number, a list, or a range
  /// `{ from = 0.6, to = 0.8, count = 21 }` with optional `spacing = "log"`. A range contains its
  /// ends exactly; the values between are rounded to 12 digits.
  std::vector<double> grid(std::string_view key, const Interval& allowed = {},
                           std::optional<std::vector<double>> absent = {}) const;
  /// The keys that are there, in the order of the file; of a table that is not inline "table.key" of each of its own.
  std::vector<std::string> keys() const;
  /// One of them, in the table in which it stands.
  struct Place;
  Place place_of(const std::string& key) const;
  /// A list of values of any kind, each as it stands in files; not empty.
  std::vector<std::string> list(std::string_view key) const;
  /// The same with none twice, or a range as in `grid`.
  std::vector<std::string> values(std::string_view key) const;
  /// Amplitudes by degree, `[[2, 0.04], [3, 0.02]]`: not empty, no degree twice.
  std::vector<axisym::Mode> modes(std::string_view key, int lowest, int highest) const;
  /// Amplitudes of spherical harmonics, `[[5, 3, 0.5], [2, -1, 0.01]]`: degree l, order m in −l … l,
  /// amplitude; not empty, none twice.
  std::vector<meshing::Harmonic> harmonics(std::string_view key, int highest) const;
  /// A table in this one. One that is absent is empty: what it requires is then missing.
  TomlTable table(std::string_view key) const;
  /// A list of tables, not empty.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// For keys which have no place here: throws if the key is there, for this reason.
  void refuse(std::string_view key, std::string_view reason) const;
  /// The same for a word that has no place in the list.
  void refuse_word(std::string_view key, std::string_view word, std::string_view reason) const;
  /// Throws for the first key that nobody asked for; names the nearest known one and lists all.
  void reject_unknown_keys() const;

  /// Throws where a key that nobody asked for is nearly one of these: before something is said of their absence.
  void refuse_misspelt(const std::vector<std::string>& keys) const;

  /// Throws at the key, with its value when it is there.
  [[noreturn]] void fail(std::string_view key, std::string_view what) const;
  /// Throws what a validate() says, "name = value: constraint": at the key `name` when it is
  /// there, else at the table.
  [[noreturn]] void fail_from(const std::invalid_argument& error) const;

 private:
  static std::vector<std::string> names_of(const auto& values) {
    std::vector<std::string> names;
    names.reserve(std::size(values));
    for (const auto value : values) names.emplace_back(name(value));
    return names;
  }

  std::shared_ptr<TableState> state_;
};

struct TomlTable::Place {
  TomlTable table;
  std::string key;
};

/// A value of a file: where it stands, as in "material.L", and as what.
struct TomlValue {
  std::string key, value;
};

struct TomlFile {
  /// The table of the whole file. Throws InputError if it cannot be read or is not TOML.
  static TomlTable parse(const std::filesystem::path& path);
  /// The same with these values in place of its own, or added, and without the table `left_out`. Throws InputError where a
  /// key leads through what is no table.
  static TomlTable parse_with(const std::filesystem::path& path,
                              const std::vector<TomlValue>& values, std::string_view left_out);
};

}  // namespace sbeh::studies

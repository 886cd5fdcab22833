// What dimensionless numbers are in physical units, and physical values as such numbers.
#pragma once

#include "studies/io/dimension.h"

#include <optional>
#include <string>
#include <string_view>

namespace sbeh::studies {

/// The units of length, energy and time; those that are not known leave what needs them without physical units.
struct Scales {
  double length = 1;               ///< R, m
  std::optional<double> energy{};  ///< E₀, J
  std::optional<double> time{};    ///< T, s
  double thermal = 0;              ///< k_BT, J
  bool in_kT = true;               ///< whether energies are told in k_BT, or in J

  /// What a number of that dimension is multiplied by to be in `unit`. Where the time is not known, it stays in T. The
  /// energy must be known.
  double factor(const Dimension& dimension) const;
  /// "µm", "kT", "1/s", "N/m", "Pa"; empty for a pure number.
  std::string unit(const Dimension& dimension) const;
  /// The same as the end of a column's name: "_um", "_kT", "_per_s", "_N_per_m"; empty for a pure number.
  std::string suffix(const Dimension& dimension) const;
};

/// The number that a text such as "3.9 um", "-0.2 1/um", "5 ms" or "1 kT" stands for, to 15 digits. Throws std::invalid_argument with what must be,
/// where it is no such text of that dimension, or needs a scale that is not known.
double number_in(const Scales& scales, std::string_view text, const Dimension& dimension);

}  // namespace sbeh::studies

// Finite groups of turns and mirrors about the origin.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::meshing {

/// A turn, a mirror or both: an orthogonal matrix.
using Operation = Eigen::Matrix3d;

/// A point group by Schoenflies' symbol. The axis of most turns is z, as in "C3"; the mirrors of C_nv, D_nh, D_nd contain or are that of y →
/// −y, which leaves all Y_lm with m >= 0 as they are; the mirror of Cs, C_nh, D_nh is that of z → −z. Where there are
/// no mirrors D_n turns about x, too. T, Td, Th, O, Oh have turns of two or four about x, y, z, and the mirrors of Td are
/// those of x → y; I and Ih turn by a fifth about z, and y → −y is a mirror of Ih.
class PointGroup {
 public:
  PointGroup() : PointGroup("C1") {}
  /// "C1", "Cs" or "mirror", "Ci"; C, D with n = 2 … 12 and v, h or d; S with an even n = 4 … 24; T, Td, Th, O, Oh, I, Ih.
  /// Throws std::invalid_argument for any other.
  explicit PointGroup(std::string_view symbol);

  const std::string& symbol() const { return symbol_; }
  const std::vector<Operation>& operations() const { return operations_; }  ///< the identity first
  bool is_trivial() const { return operations_.size() == 1; }
  bool has(const Operation& operation) const;
  /// Whether each operation of the other is one of this.
  bool contains(const PointGroup& other) const;

  /// Those operations of which this is true, if they are a group, else C1. Its symbol is "part of D4h", say, unless it is all of it.
  PointGroup part(const std::function<bool(const Operation&)>& is_in) const;

  bool operator==(const PointGroup& other) const {
    return symbol_ == other.symbol_ && operations_ == other.operations_;
  }

 private:
  std::string symbol_;
  std::vector<Operation> operations_;
};

/// All operations that these lead to, the identity first. Throws std::invalid_argument for more than 120.
std::vector<Operation> group_of(const std::vector<Operation>& generators);

}  // namespace sbeh::meshing

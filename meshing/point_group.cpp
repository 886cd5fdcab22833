#include "meshing/point_group.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

using Eigen::Vector3d;
constexpr int most_turns = 12;

// Sines and cosines that are 0, ±½ or ±1 are so to the last bit.
Operation exact(Operation operation) {
  for (double& entry : operation.reshaped())
    if (std::abs(2 * entry - std::round(2 * entry)) < 1e-14) entry = std::round(2 * entry) / 2 + 0.;
  return operation;
}
Operation turn(const Vector3d& axis, int n) {
  return exact(Eigen::AngleAxisd(2 * std::numbers::pi / n, axis.normalized()).toRotationMatrix());
}
Operation mirror(const Vector3d& normal) {
  const Vector3d n = normal.normalized();
  return exact(Operation::Identity() - 2 * n * n.transpose());
}
const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ(),
               diagonal = Vector3d::Ones();
const Operation inversion = -Operation::Identity();

bool same(const Operation& a, const Operation& b) { return (a - b).cwiseAbs().maxCoeff() < 1e-9; }
bool is_among(const std::vector<Operation>& operations, const Operation& sought) {
  return std::any_of(operations.begin(), operations.end(),
                     [&](const Operation& o) { return same(o, sought); });
}

using Generators = std::vector<Operation>;

std::optional<Generators> without_number(std::string_view symbol) {
  const Generators T{turn(z, 2), turn(diagonal, 3)}, O{turn(z, 4), turn(diagonal, 3)},
      // From the vertex above to one of the upper ring of the icosahedron, whose edge it turns over.
      I{turn(z, 5), turn(Vector3d(2 / std::sqrt(5.), 0, 1 + 1 / std::sqrt(5.)), 2)};
  const auto with = [](Generators group, const Operation& one_more) {
    group.push_back(one_more);
    return group;
  };
  if (symbol == "C1") return Generators{};
  if (symbol == "Cs") return Generators{mirror(z)};
  if (symbol == "Ci") return Generators{inversion};
  if (symbol == "T") return T;
  if (symbol == "Td") return with(T, mirror(x - y));
  if (symbol == "Th") return with(T, inversion);
  if (symbol == "O") return O;
  if (symbol == "Oh") return with(O, inversion);
  if (symbol == "I") return I;
  if (symbol == "Ih") return with(I, inversion);
  return {};
}

std::optional<Generators> about_an_axis(std::string_view symbol) {
  int n = 0;
  const char *first = symbol.data() + 1, *last = symbol.data() + symbol.size();
  const auto [end, error] = std::from_chars(first, last, n);
  if (error != std::errc() || *first == '0') return {};
  const char kind = symbol[0];
  const std::string_view rest(end, std::size_t(last - end));
  if (kind == 'S' && rest.empty() && n >= 4 && n <= 2 * most_turns && n % 2 == 0)
    return Generators{turn(z, n) * mirror(z)};
  if ((kind != 'C' && kind != 'D') || n < 2 || n > most_turns) return {};
  const bool dihedral = kind == 'D';
  Generators generators{turn(z, n)};
  if (dihedral && rest != "d") generators.push_back(turn(x, 2));
  if (rest == "h") generators.push_back(mirror(z));
  if (rest == "v" && !dihedral) generators.push_back(mirror(y));
  if (rest == "d" && dihedral)
    generators.insert(generators.end(), {mirror(y), turn(z, 2 * n) * mirror(z)});
  const bool known =
      rest.empty() || rest == "h" || (rest == "v" && !dihedral) || (rest == "d" && dihedral);
  return known ? std::optional(generators) : std::nullopt;
}

}  // namespace

std::vector<Operation> group_of(const std::vector<Operation>& generators) {
  constexpr std::size_t most = 120;  // as many as Ih has
  std::vector<Operation> group{Operation::Identity()};
  for (std::size_t k = 0; k < group.size(); ++k)
    for (const Operation& generator : generators) {
      const Operation next = exact(generator * group[k]);
      if (is_among(group, next)) continue;
      if (group.size() == most)
        throw std::invalid_argument("a group of turns and mirrors: more than 120 of them");
      group.push_back(next);
    }
  return group;
}

PointGroup::PointGroup(std::string_view symbol) : symbol_(symbol == "mirror" ? "Cs" : symbol) {
  auto generators = without_number(symbol_);
  if (!generators && symbol_.size() > 1) generators = about_an_axis(symbol_);
  if (!generators)
    throw std::invalid_argument(fmt::format(
        "must be C1, Cs, Ci, Cn, Cnv, Cnh, Dn, Dnh, Dnd with n = 2 ... {}, Sn with an even "
        "n = 4 ... {}, T, Td, Th, O, Oh, I or Ih",
        most_turns, 2 * most_turns));
  operations_ = group_of(*generators);
}

bool PointGroup::has(const Operation& operation) const { return is_among(operations_, operation); }

bool PointGroup::contains(const PointGroup& other) const {
  return std::all_of(other.operations_.begin(), other.operations_.end(),
                     [this](const Operation& operation) { return has(operation); });
}

PointGroup PointGroup::part(const std::function<bool(const Operation&)>& is_in) const {
  std::vector<Operation> kept;
  std::ranges::copy_if(operations_, std::back_inserter(kept), is_in);
  if (kept.size() == operations_.size()) return *this;
  PointGroup group;
  if (kept.size() < 2 || group_of(kept).size() != kept.size()) return group;
  group.symbol_ = "part of " + symbol_;
  group.operations_ = kept;
  return group;
}

}  // namespace sbeh::meshing

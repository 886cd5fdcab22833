#include "studies/parameters/material_number.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

using model::Material;

namespace {

// What of a material has such members.
template <class M, class Value>
auto& part_with(M& material, Value Material::* /*member*/) {
  return material;
}
template <class M>
auto& part_with(M& material, double model::AreaDifference::* /*member*/) {
  return material.area_difference;
}

}  // namespace

const std::vector<MaterialNumber>& MaterialNumber::all() {
  static const std::vector<MaterialNumber> numbers = [] {
    constexpr std::size_t powers = 5;  // β⁰ … β⁴
    using Number = MaterialNumber;
    std::vector<Number> made{
        Number("L", "L1", "elastic constant L", &Material::L1, model::above(0)),
        Number("L2", "L2", "elastic constant L₂", &Material::L2, {}),
        Number("L3", "L3", "elastic constant L₃", &Material::L3, {}),
        Number("H0", "spontaneous_curvature", "spontaneous curvature H₀",
               &Material::spontaneous_curvature, {}),
        Number("k0", "residual_stiffness", "residual stiffness k₀", &Material::residual_stiffness,
               model::at_least(0)),
        Number("W2", "area_difference", "preferred W₂⁰", &model::AreaDifference::W2, {}),
        Number("mean_order", "mean_order", "mean order β̄", &Material::mean_order,
               model::between(-0.5, 1)),
    };
    const auto add = [&](const std::string& key, const char* letter, auto member,
                         std::size_t first) {
      for (std::size_t power = first; power < powers; ++power)
        made.push_back(Number(fmt::format("{}_{}", key, power), key,
                              fmt::format("coefficient of {}'s power {}", letter, power), member,
                              {}, power));
    };
    add("potential", "u", &Material::potential, 1);
    add("flexoelectric", "f", &Material::flexoelectric, 0);
    add("kappa", "κ", &Material::kappa_powers, 0);
    add("kappa_gauss", "κ_G", &Material::kappa_gauss_powers, 0);
    add("lipid_density", "n", &Material::lipid_density, 0);
    return made;
  }();
  return numbers;
}

const MaterialNumber* MaterialNumber::named(std::string_view name) {
  const auto found = std::ranges::find(all(), name, &MaterialNumber::name);
  return found == all().end() ? nullptr : &*found;
}

std::vector<std::string> MaterialNumber::names() {
  std::vector<std::string> names;
  for (const MaterialNumber& one : all()) names.push_back(one.name());
  return names;
}

double MaterialNumber::of(const Material& material) const {
  return std::visit(
      [&](auto member) {
        const auto& value = part_with(material, member).*member;
        if constexpr (std::same_as<std::decay_t<decltype(value)>, double>) {
          return value;
        } else if constexpr (std::same_as<std::decay_t<decltype(value)>, std::optional<double>>) {
          return value.value_or(0);
        } else {
          const auto& powers = value.coefficients();
          return power_ < powers.size() ? powers[power_] : 0;
        }
      },
      member_);
}

Material MaterialNumber::with(Material material, double value) const {
  std::visit(
      [&](auto member) {
        auto& there = part_with(material, member).*member;
        using Value = std::decay_t<decltype(there)>;
        if constexpr (std::same_as<Value, double> || std::same_as<Value, std::optional<double>>) {
          there = value;
        } else {
          auto powers = there.coefficients();
          powers.resize(std::max(powers.size(), power_ + 1));
          powers[power_] = value;
          there = Value(std::move(powers));
        }
      },
      member_);
  return material;
}

bool is_there(const MaterialNumber& number, const Material& material) {
  if (number.key() == "kappa") return !material.kappa_powers.empty();
  if (number.key() == "kappa_gauss") return !material.kappa_gauss_powers.empty();
  if (number.key() == "lipid_density") return material.has_lipid_density();
  if (number.key() == "mean_order") return material.conserves_order();
  return number.key() != "area_difference" || material.area_difference.is_there();
}

bool is_of_order(const MaterialNumber& number) {
  return number.name().starts_with(number.key() + "_") || number.key() == "mean_order";
}

}  // namespace sbeh::studies

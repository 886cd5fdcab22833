// The numbers of a material on which its rest states depend, one by one.
#pragma once

#include "model/material.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// One of them: L (which is L1), L2, L3, H0, k0, W2 (of area_difference), mean_order, or a coefficient of a power, as flexoelectric_1.
class MaterialNumber {
 public:
  /// Null where there is none of that name; lives for ever.
  static const MaterialNumber* named(std::string_view name);
  static std::vector<std::string> names();

  const std::string& name() const { return name_; }
  /// That of the parameter whose number it is: "flexoelectric" of flexoelectric_1.
  const std::string& key() const { return key_; }
  /// What the parameter's table allows; materials have bounds besides: Material::validate.
  const model::Interval& allowed() const { return allowed_; }
  /// For axes of pictures: letter and meaning.
  const std::string& title() const { return title_; }

  double of(const model::Material& material) const;
  model::Material with(model::Material material, double value) const;

 private:
  using Member = std::variant<double model::Material::*, model::Polynomial model::Material::*,
                              model::Potential model::Material::*, double model::AreaDifference::*,
                              std::optional<double> model::Material::*>;
  MaterialNumber(std::string name, std::string key, std::string title, Member member,
                 const model::Interval& allowed, std::size_t power = 0)
      : name_(std::move(name)),
        key_(std::move(key)),
        title_(std::move(title)),
        member_(member),
        allowed_(allowed),
        power_(power) {}
  static const std::vector<MaterialNumber>& all();

  std::string name_, key_, title_;
  Member member_;
  model::Interval allowed_;
  std::size_t power_;
};

/// Whether the number says how something depends on the order, which matters only where that is free.
bool is_of_order(const MaterialNumber& number);

/// Whether the material has it: κ, κ_G and n that are not given are no polynomials of the order, an area difference may not be there, and
/// the order may not be conserved.
bool is_there(const MaterialNumber& number, const model::Material& material);

}  // namespace sbeh::studies

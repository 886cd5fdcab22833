#include "studies/evolution/start_shape.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {
// Of ellipsoids with an axis, and of those that are meshed (meshing::ellipsoid).
constexpr double largest_aspect = 1000, largest_meshed_aspect = 100;
}  // namespace

meshing::PointGroup read_symmetry(const TomlTable& table, std::string_view key) {
  const std::string symbol = table.text(key, "C1");
  try {
    return meshing::PointGroup(symbol);
  } catch (const std::invalid_argument& error) {
    table.fail(key, error.what());
  }
}

Ellipsoid read_ellipsoid(const TomlTable& start, std::size_t count, std::string_view axes) {
  Ellipsoid ellipsoid;
  if (start.has("axes")) {
    start.refuse("reduced_volume", "must not be given together with axes");
    start.refuse("kind", "must not be given together with axes, which tell it");
    ellipsoid.axes = start.numbers("axes", above(0));
    if (ellipsoid.axes.size() != count) start.fail("axes", fmt::format("must be {}", axes));
    const auto [least, largest] = std::minmax_element(ellipsoid.axes.begin(), ellipsoid.axes.end());
    const double aspect = count == 3 ? largest_meshed_aspect : largest_aspect;
    if (*largest / aspect > *least)
      start.fail("axes", fmt::format("must not differ by more than a factor of {}", aspect));
  } else {
    start.refuse_misspelt({"axes"});
    ellipsoid.reduced_volume = start.number("reduced_volume", reduced_volumes);
  }
  ellipsoid.prolate = start.word("kind", {"oblate", "prolate"}, "oblate") == "prolate";
  return ellipsoid;
}

void write_shape(TomlText& toml, const Ellipsoid& ellipsoid) {
  if (ellipsoid.reduced_volume) {
    toml.value("reduced_volume", *ellipsoid.reduced_volume);
    toml.value("kind", std::string(ellipsoid.prolate ? "prolate" : "oblate"));
  } else {
    toml.value("axes", ellipsoid.axes);
  }
}

}  // namespace sbeh::studies

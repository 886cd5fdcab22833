#include "studies/parameters/input_kind.h"

#include <fmt/format.h>

namespace sbeh::studies {

InputKind kind_of(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  return file.has("sweep") ? InputKind::sweep : kind_in(file, path);
}

InputKind kind_in(const TomlTable& file, const std::filesystem::path& path) {
  const bool scan = file.has("scan"), relax = file.has("start"), run = file.has("surface"),
             compare = file.has("compare"), stability = file.has("stability"),
             modes = file.has("modes"), states = file.has("states"), diagram = file.has("diagram");
  const int count = scan + relax + run + compare + stability + modes + states + diagram;
  if (count == 0) {
    for (const char* known : {"model", "surface3d"}) file.has(known);
    file.refuse_misspelt({"scan", "start", "surface", "compare", "stability", "modes", "states",
                          "diagram", "sweep"});
  }
  file.refuse_misspelt({"sweep"});
  if (count != 1)
    throw InputError(fmt::format(
        "{}: must have {}[scan] (a scan), [start] (one axisymmetric evolution), [surface] (one "
        "3D run), [compare] (one case by several methods), [stability] (axisymmetric states, "
        "perturbed in 3D), [modes] (the modes of one state), [states] (rest states in "
        "3D), [diagram] (a classical phase diagram) or [sweep] (many runs of one of these){}",
        path.string(), count > 1 ? "only one of " : "a table ",
        count > 1 ? "" : "; it has none of them"));
  return scan      ? InputKind::scan
       : relax     ? InputKind::relax
       : run       ? InputKind::run
       : compare   ? InputKind::compare
       : stability ? InputKind::stability
       : modes     ? InputKind::modes
       : states    ? InputKind::states
                   : InputKind::diagram;
}

}  // namespace sbeh::studies

#include "surface3d/parallel.h"

#include <tbb/parallel_for.h>

namespace sbeh::surface3d {

void for_each_by_colour(const Triangulation& mesh, const std::function<void(int)>& visit) {
  for (const auto& patches : mesh.colours)
    tbb::parallel_for(std::size_t(0), patches.size(), [&](std::size_t k) {
      for (const int e : patches[k]) visit(e);
    });
}

}  // namespace sbeh::surface3d

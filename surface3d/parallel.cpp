#include "surface3d/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace sbeh::surface3d {

void in_parallel(int count, const std::function<void(int)>& visit) {
  constexpr int grain = 32;  // some 50 μs at least
  tbb::parallel_for(tbb::blocked_range<int>(0, count, count < grain ? 1 : grain),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int i = range.begin(); i < range.end(); ++i) visit(i);
                    });
}

void for_each_by_colour(const Triangulation& mesh, const std::function<void(int)>& visit) {
  for (const auto& patches : mesh.colours)
    tbb::parallel_for(std::size_t(0), patches.size(), [&](std::size_t k) {
      for (const int e : patches[k]) visit(e);
    });
}

}  // namespace sbeh::surface3d

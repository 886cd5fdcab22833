#include "surface3d/linear/in_parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace sbeh::surface3d {

void in_parallel(int count, const std::function<void(int)>& visit, int grain) {
  tbb::parallel_for(tbb::blocked_range<int>(0, count, count < grain ? 1 : grain),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int i = range.begin(); i < range.end(); ++i) visit(i);
                    });
}

}  // namespace sbeh::surface3d

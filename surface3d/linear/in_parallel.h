// A loop on all threads.
#pragma once

#include <functional>

namespace sbeh::surface3d {

/// Calls visit(i) for 0 … count − 1, from several threads and in any order; each thread takes `grain` calls or
/// more at once, unless there are fewer: some 50 μs at least.
void in_parallel(int count, const std::function<void(int)>& visit, int grain = 32);

}  // namespace sbeh::surface3d

// A loop on all threads.
#pragma once

#include <functional>

namespace sbeh::surface3d {

/// Calls visit(i) for 0 … count − 1, from several threads and in any order.
void in_parallel(int count, const std::function<void(int)>& visit);

}  // namespace sbeh::surface3d

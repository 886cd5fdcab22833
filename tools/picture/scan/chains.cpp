#include "tools/picture/scan/chains.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

struct Pair {
  double distance;
  std::size_t first, second;
};

std::vector<Pair> pairs_within(const Points& points, double farthest) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]);
      if (distance <= farthest) pairs.push_back({distance, j, i});
    }
  std::ranges::sort(pairs, {}, &Pair::distance);
  return pairs;
}

}  // namespace

std::vector<std::vector<std::size_t>> chains(
    const Points& points, double farthest,
    const std::function<bool(std::size_t, std::size_t)>& may_join) {
  using Chain = std::vector<std::size_t>;
  std::vector<Chain> all(points.size());
  std::vector<std::size_t> chain_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) all[chain_of[i] = i] = {i};
  const auto is_end = [&](std::size_t i) {
    const Chain& chain = all[chain_of[i]];
    return chain.front() == i || chain.back() == i;
  };
  for (const auto& [distance, i, j] : pairs_within(points, farthest)) {
    if (chain_of[i] == chain_of[j] || !is_end(i) || !is_end(j)) continue;
    if (may_join && !may_join(i, j)) continue;
    Chain &a = all[chain_of[i]], &b = all[chain_of[j]];
    if (a.back() != i) std::ranges::reverse(a);
    if (b.front() != j) std::ranges::reverse(b);
    for (const std::size_t k : b) chain_of[k] = chain_of[i];
    a.insert(a.end(), b.begin(), b.end());
    b.clear();
  }
  std::erase_if(all, [](const Chain& chain) { return chain.empty(); });
  return all;
}

}  // namespace sbeh::picture

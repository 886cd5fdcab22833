#include "tools/picture/scan/chains.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr std::size_t none = std::size_t(-1);

bool is_whole(double place) { return std::abs(place - std::round(place)) < 1e-9; }

// The cells, by their lower left corners, on whose border the crossing lies.
std::vector<std::pair<int, int>> cells_at(const std::array<double, 2>& crossing) {
  const auto beside = [](double place) {
    const int below = int(std::floor(place + 1e-9));
    return is_whole(place) ? std::vector{below - 1, below} : std::vector{below};
  };
  std::vector<std::pair<int, int>> cells;
  for (const int i : beside(crossing[0]))
    for (const int j : beside(crossing[1])) cells.emplace_back(i, j);
  return cells;
}

bool on_one_side(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  for (const int c : {0, 1})
    if (is_whole(a[c]) && is_whole(b[c]) && std::round(a[c]) == std::round(b[c])) return true;
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> chains(const Points& crossings) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    for (const auto& cell : cells_at(crossings[i])) cells[cell].push_back(i);
  std::vector<std::array<std::size_t, 2>> next(crossings.size(), {none, none});
  const auto has_room = [&](std::size_t i) { return next[i][1] == none; };
  for (const auto& [cell, members] : cells) {
    if (members.size() != 2) continue;
    const std::size_t i = members[0], j = members[1];
    if (on_one_side(crossings[i], crossings[j]) || !has_room(i) || !has_room(j)) continue;
    next[i][next[i][0] == none ? 0 : 1] = j;
    next[j][next[j][0] == none ? 0 : 1] = i;
  }
  std::vector<std::vector<std::size_t>> all;
  std::vector<bool> is_in(crossings.size(), false);
  const auto follow = [&](std::size_t from) {
    auto& chain = all.emplace_back();
    for (std::size_t at = from, before = none; at != none;) {
      chain.push_back(at);
      is_in[at] = true;
      const std::size_t onward = next[at][0] == before ? next[at][1] : next[at][0];
      before = std::exchange(at, onward != none && is_in[onward] ? none : onward);
    }
  };
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (!is_in[i] && has_room(i)) follow(i);  // the ends first
  for (std::size_t i = 0; i < crossings.size(); ++i)
    if (!is_in[i]) follow(i);  // closed ones
  return all;
}

}  // namespace sbeh::picture

#include "surface3d/linear/ranks.h"

#include <cstdlib>

namespace sbeh::surface3d {

Ranks Ranks::all() { return {}; }
bool Ranks::by_mpi() { return false; }

void Ranks::sum(std::span<double>) const {}
void Ranks::broadcast(std::span<std::byte>) const {}
void Ranks::gather(std::vector<int>&) const {}
bool Ranks::broadcast(bool value) const { return value; }
bool Ranks::any(bool value) const { return value; }

int Ranks::communicator() const {
  constexpr int world_of_sequential_mumps = -987654;
  return world_of_sequential_mumps;
}

void send_to_others(const Ranks&, const std::string&) {}
std::string await_first(const Ranks&) { return {}; }
void abandon(const Ranks&, int exit_code) { std::_Exit(exit_code); }
void part_with(const Ranks&) {}

}  // namespace sbeh::surface3d

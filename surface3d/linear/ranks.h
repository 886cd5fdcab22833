// The processes that compute a run together.
//
// All of them come to the same calls in the same order and hold the same numbers, to the last bit; what is
// large, matrices and factors, is parted among them. A program without MPI has one (ranks_alone.cpp), one
// with it those that mpirun started (ranks_mpi.cpp); which it is, is a matter of linking.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sbeh::surface3d {

class Ranks {
 public:
  /// This process alone.
  Ranks() = default;
  /// All that were started together.
  static Ranks all();
  /// Whether the program is linked with MPI.
  static bool by_mpi();

  int count() const { return count_; }
  int rank() const { return rank_; }  ///< 0 … count − 1
  bool is_first() const { return rank_ == 0; }
  bool is_alone() const { return count_ == 1; }

  // Each of these is called by all ranks.

  /// The sums over the ranks, in their place, on all of them.
  void sum(std::span<double> numbers) const;
  /// Those of the first rank, on all of them.
  void broadcast(std::span<std::byte> bytes) const;
  bool broadcast(bool value) const;
  /// On the first rank: those of all ranks, one after the other; elsewhere none.
  void gather(std::vector<int>& numbers) const;
  /// Whether it is so on any of them.
  bool any(bool value) const;

  /// MPI's communicator as MUMPS takes it.
  int communicator() const;

 private:
  Ranks(int count, int rank) : count_(count), rank_(rank) {}
  int count_ = 1, rank_ = 0;
};

/// From the first rank to the others, which wait for it.
void send_to_others(const Ranks& ranks, const std::string& message);
/// Waits, asleep, for what the first rank sends.
std::string await_first(const Ranks& ranks);
/// Leaves the others at once: after an error of which they do not know. Ends the program.
[[noreturn]] void abandon(const Ranks& ranks, int exit_code);
/// After which no rank calls any other; by all.
void part_with(const Ranks& ranks);

}  // namespace sbeh::surface3d

#include "surface3d/linear/ranks.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <numeric>
#include <thread>
#include <utility>

namespace sbeh::surface3d {

namespace {

constexpr int tag = 1;

// MPI counts with int.
template <class Number>
void in_pieces(std::span<Number> all, auto&& visit) {
  constexpr std::size_t most = std::size_t(1) << 28;
  for (std::size_t at = 0; at < all.size(); at += most) {
    const auto piece = all.subspan(at, std::min(most, all.size() - at));
    visit(piece.data(), int(piece.size()));
  }
}

}  // namespace

bool Ranks::by_mpi() { return true; }

Ranks Ranks::all() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun == 0) {
    int level = 0;  // one thread at a time calls MPI
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &level);
  }
  int count = 1, rank = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return {count, rank};
}

// Summed on one rank, so that the others have the same bits whatever the algorithm is.
void Ranks::sum(std::span<double> numbers) const {
  if (is_alone()) return;
  in_pieces(numbers, [&](double* data, int size) {
    MPI_Reduce(is_first() ? MPI_IN_PLACE : data, data, size, MPI_DOUBLE, MPI_SUM, 0,
               MPI_COMM_WORLD);
  });
  broadcast(std::as_writable_bytes(numbers));
}

void Ranks::broadcast(std::span<std::byte> bytes) const {
  if (is_alone()) return;
  in_pieces(bytes,
            [](std::byte* data, int size) { MPI_Bcast(data, size, MPI_BYTE, 0, MPI_COMM_WORLD); });
}

bool Ranks::broadcast(bool value) const {
  broadcast(std::as_writable_bytes(std::span(&value, 1)));
  return value;
}

void Ranks::gather(std::vector<int>& numbers) const {
  if (is_alone()) return;
  const int size = int(numbers.size());
  std::vector<int> sizes(std::size_t(count_), 0), starts(sizes);
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<int> all(is_first() ? std::size_t(starts.back()) + std::size_t(sizes.back()) : 0);
  MPI_Gatherv(numbers.data(), size, MPI_INT, all.data(), sizes.data(), starts.data(), MPI_INT, 0,
              MPI_COMM_WORLD);
  numbers = std::move(all);
}

bool Ranks::any(bool value) const {
  double count = value ? 1 : 0;
  sum({&count, 1});
  return count > 0;
}

int Ranks::communicator() const {
  return MPI_Comm_c2f(is_alone() ? MPI_COMM_SELF : MPI_COMM_WORLD);
}

void send_to_others(const Ranks& ranks, const std::string& message) {
  for (int other = 1; other < ranks.count(); ++other)
    MPI_Send(message.data(), int(message.size()), MPI_CHAR, other, tag, MPI_COMM_WORLD);
}

std::string await_first(const Ranks&) {
  MPI_Status status;
  for (int is_there = 0;;) {
    MPI_Iprobe(0, tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there != 0) break;
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string message(std::size_t(size), '\0');
  MPI_Recv(message.data(), size, MPI_CHAR, 0, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

void abandon(const Ranks&, int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

void part_with(const Ranks&) { MPI_Finalize(); }

}  // namespace sbeh::surface3d

// sbeh among the processes that mpirun starts.
#pragma once

#include "surface3d/linear/direct_solver.h"
#include "surface3d/linear/ranks.h"

#include <optional>
#include <string>

namespace sbeh::tools {

/// How many processes were started together, by what mpirun or srun tell each of them; 1 without.
int started_together();

/// Where more than one were: this program becomes sbeh-mpi, beside it, which knows of the others. Returns when it is that
/// one, or alone. Throws InputError where there is no such program.
void become_one_of_many(char** argv);

/// The ranks while the command runs. All but the first serve it, and have nothing left to do then.
class RanksAtWork {
 public:
  /// Starts MPI where there are others. Throws InputError where MPI does not know of them.
  RanksAtWork();
  ~RanksAtWork();
  RanksAtWork(const RanksAtWork&) = delete;
  RanksAtWork& operator=(const RanksAtWork&) = delete;

  bool is_first() const { return ranks_.is_first(); }
  /// Until the first one has done its work; by the others.
  void serve() const;
  /// By the first one, of the command that it runs. Throws InputError where there are others and the command has nothing
  /// for them to do.
  void begin(const std::string& command);

 private:
  surface3d::Ranks ranks_;
  std::optional<surface3d::SharedFactors> factors_;
};

}  // namespace sbeh::tools

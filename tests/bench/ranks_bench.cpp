// What the parts of a step cost that several ranks share, from few triangles to many; of the flow's system, the split
// scheme, factors in single precision, r = 1 + 0.2 Y₂² + 0.2 Y₃² (SSH).
//
//   mpirun -n RANKS ranks_bench TRIANGLES...
//
// A row for each number of triangles, the fastest of a few times; on the first rank, which waits for the others. Each rank
// has one thread. Seconds are wall-clock seconds: other work on the machine spoils them.

#include "meshing/shapes.h"
#include "meshing/spherical_harmonics.h"
#include "surface3d/coupled_system.h"
#include "surface3d/linear/gmres.h"

#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace {

using namespace sbeh;
using namespace sbeh::surface3d;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double fastest(int times, const std::function<void()>& part) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const double start = seconds();
    part();
    least = std::min(least, seconds() - start);
  }
  return least;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

void measure(int triangles, const Ranks& ranks) {
  const std::vector<meshing::Harmonic> modes{{2, 2, 0.2}, {3, 2, 0.2}};
  const meshing::CurvedMesh shape = meshing::harmonic_sphere(modes, {.triangles = triangles});
  const Triangulation mesh(Triangulation(shape), ranks);
  const State state{shape.nodes, Field::Constant(mesh.nodes, model::full_order)};
  const Curvature curvature = *curvature_of(mesh, state.X);
  const double curvatures = fastest(3, [&] { (void)curvature_of(mesh, state.X); });
  CoupledSystem system(mesh, {}, Scheme::split);
  const auto assemble = [&] {
    system.assemble(mesh, state, curvature, Field::Zero(mesh.nodes), {state.X, curvature.H}, 1e-3,
                    {0, 0, true, 4 * std::numbers::pi});
  };
  assemble();
  const double assembly = fastest(3, assemble);
  const SparseMatrix& matrix = system.flow().matrix;
  DirectSolver factors(Symmetry::general, Precision::single, ranks);
  const double start = seconds();
  if (!factors.factor(matrix)) std::puts("singular");
  const double first = seconds() - start;
  const double factoring = fastest(3, [&] { (void)factors.factor(matrix); });
  Eigen::MatrixXd x = system.flow().rhs;
  const double applying = fastest(5, [&] { factors.solve(x); });
  Eigen::VectorXd y = system.flow().rhs;
  const double multiplying = fastest(5, [&] {
    Eigen::VectorXd part = product(matrix, y);
    ranks.sum({part.data(), std::size_t(part.size())});
  });
  const double summing = fastest(5, [&] { ranks.sum({y.data(), std::size_t(y.size())}); });
  if (!ranks.is_first()) return;
  std::printf("%d,%d,%ld,%.4f,%.4f,%.4f,%.4f,%.3g,%.3g,%.5f,%.5f,%.5f,%.0f\n", mesh.count(),
              ranks.count(), long(system.flow().rhs.size()), curvatures, assembly, first, factoring,
              factors.flops(), factors.entries(), applying, multiplying, summing, peak_megabytes());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const Ranks ranks = Ranks::all();
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
  if (ranks.is_first())
    std::puts(
        "triangles,ranks,unknowns,curvature,assembly,first_factors,factors,operations,entries,"
        "application,product,sum,megabytes");
  for (int i = 1; i < argc; ++i) measure(std::atoi(argv[i]), ranks);
  part_with(ranks);
}

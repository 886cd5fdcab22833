#include "surface3d/stationary/symmetry_class.h"

#include "meshing/closest_point.h"
#include "surface3d/moments.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace sbeh::surface3d {

namespace {

using Operation = Eigen::Matrix3d;
constexpr int most_turns = 6;

Operation turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}
Operation mirror(const Eigen::Vector3d& normal) {
  return Operation::Identity() - 2 * normal * normal.transpose();
}

// A surface about its centre, prepared for trying operations.
class Symmetries {
 public:
  Symmetries(const Triangulation& mesh, const State& state)
      : moments_(moments_of(samples_of(mesh, state.X))),
        X_(state.X.colwise() - moments_.centre),
        beta_(state.beta),
        surface_({.order = 3, .triangles = mesh.triangles, .nodes = X_}),
        samples_(samples_of(mesh, X_)) {}

  const Moments& moments() const { return moments_; }
  bool has(const Operation& operation) const {
    constexpr Eigen::Index tried = 200;
    const Eigen::Index every = std::max<Eigen::Index>(1, X_.cols() / tried);
    double distances = 0, changes = 0;  // squares of them
    int count = 0;
    for (Eigen::Index i = 0; i < X_.cols(); i += every, ++count) {
      const Eigen::Vector3d x = operation * X_.col(i);
      const meshing::SurfacePlace place = surface_(x);
      distances += (surface_.point(place) - x).squaredNorm();
      changes += std::pow(surface_.value(beta_, place) - beta_[i], 2);
    }
    return std::sqrt(std::max(distances, changes) / count) < symmetry_tolerance;
  }
  // Where mirrors through an axis, and horizontal axes, of n turns can be: the phase of ∫ (x + iy)ⁿ.
  Eigen::Vector3d direction_across(const Eigen::Vector3d& axis, int n) const {
    const Eigen::Vector3d e1 = axis.unitOrthogonal(), e2 = axis.cross(e1);
    std::complex<double> sum = 0;
    for (Eigen::Index i = 0; i < samples_.points.cols(); ++i)
      sum += samples_.areas[i]
           * std::pow(std::complex(e1.dot(samples_.points.col(i)), e2.dot(samples_.points.col(i))),
                      n);
    const double angle = std::arg(sum) / n;
    return std::cos(angle) * e1 + std::sin(angle) * e2;
  }

 private:
  Moments moments_;
  Nodes X_;
  Field beta_;
  meshing::ClosestPoint surface_;
  SurfaceSamples samples_;
};

struct Axis {
  Eigen::Vector3d direction;
  int turns;
};
// Of a surface of revolution: turns by an angle that no other axis has.
bool is_axis_of_revolution(const Symmetries& symmetries, const Eigen::Vector3d& axis) {
  return symmetries.has(turn(axis, 1)) && symmetries.has(turn(axis, 2));
}
std::optional<Axis> main_axis(const Symmetries& symmetries) {
  for (int n = most_turns; n >= 2; --n)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = symmetries.moments().axes.col(k);
      if (symmetries.has(turn(axis, 2 * std::numbers::pi / n))) return Axis{axis, n};
    }
  return {};
}

std::string class_about(const Symmetries& symmetries, const Axis& axis) {
  const Eigen::Vector3d along = symmetries.direction_across(axis.direction, axis.turns),
                        across = axis.direction.cross(along);
  const double half = std::numbers::pi / axis.turns;
  // Planes and horizontal axes lie at multiples of π/n from the phase, the axes of D_nd between the planes.
  const bool vertical = symmetries.has(mirror(across)),
             level = symmetries.has(mirror(axis.direction));
  const auto is_axis = [&](double angle) {
    return symmetries.has(turn(turn(axis.direction, angle) * along, std::numbers::pi));
  };
  const bool dihedral = is_axis(0) || is_axis(half / 2);
  const std::string n = std::to_string(axis.turns);
  if (dihedral) return "D" + n + (level ? "h" : vertical ? "d" : "");
  return "C" + n + (level ? "h" : vertical ? "v" : "");
}

}  // namespace

std::string symmetry_class(const Triangulation& mesh, const State& state) {
  const Symmetries symmetries(mesh, state);
  const Eigen::Vector3d distinct = symmetries.moments().distinct_axis();
  if (is_axis_of_revolution(symmetries, distinct))
    return symmetries.has(mirror(distinct)) ? "Dooh" : "Coov";
  if (const auto axis = main_axis(symmetries)) return class_about(symmetries, *axis);
  for (int k = 0; k < 3; ++k)
    if (symmetries.has(mirror(symmetries.moments().axes.col(k)))) return "Cs";
  return symmetries.has(-Operation::Identity()) ? "Ci" : "C1";
}

}  // namespace sbeh::surface3d

// The circles of a surface of revolution that are measured.
#pragma once

#include "axisym/curve.h"

namespace sbeh::axisym {

/// A circle about the axis: its radius, and the nodal field H there.
struct Circle {
  double radius, H;
};

/// A point of the curve: its element, and where in it, 0 … 1.
struct CurvePlace {
  int element;
  double x;
};

/// Where r has its largest value, between the nodes as well; and the circle there.
CurvePlace widest_place(const Nodes& X);
Circle widest_circle(const Nodes& X, const Field& H);

/// That of an up-down symmetric curve in its plane of symmetry, of a dumbbell the waist; the widest where the
/// curve crosses itself and that plane more than once.
Circle middle_circle(const Nodes& X, const Field& H);

}  // namespace sbeh::axisym

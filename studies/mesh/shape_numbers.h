// What a shape that a formula gives has by itself, to see what its triangles make of it.
#pragma once

#include "studies/mesh/make_mesh.h"

#include <optional>

namespace sbeh::studies {

struct ShapeNumbers {
  double area, volume;
  double bending;  ///< ½∫H² dS, 8π on a sphere of any size
};

/// Of spheres, ellipsoids and harmonics up to l = 32, by quadrature with more and more points until ten digits stay; in the size that the
/// request asks for. Harmonics of a reduced volume: all amplitudes times the factor that gives it to the shape. Empty for other
/// shapes, and where 10⁵ points are not enough.
std::optional<ShapeNumbers> shape_numbers(const MeshRequest& request);

/// ½∫H² dS of curved triangles of order 3, as the 3D solver has it; empty of others.
std::optional<double> bending_of(const meshing::CurvedMesh& mesh);

}  // namespace sbeh::studies

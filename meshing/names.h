// What the points and triangles of a mesh are called in messages: by the numbers which the user's file has for
// them, never by those of a mesh that was made of it.
#pragma once

#include "meshing/triangle_mesh.h"

#include <string>
#include <vector>

namespace sbeh::meshing {

/// Numbers in the file, counted from 0. Where there is none (an empty list, or −1) a place is told instead.
struct Names {
  std::vector<int> points = {};
  std::vector<int> triangles = {};
};

/// Those of a mesh that is as the user has it.
Names own_numbers(const TriangleMesh& mesh);
/// 0, 1, … count − 1.
std::vector<int> counted(int count);

std::string point_name(const TriangleMesh& mesh, int point, const Names& names);
std::string edge_name(const TriangleMesh& mesh, int from, int to, const Names& names);
std::string triangle_name(const TriangleMesh& mesh, int triangle, const Names& names);
/// With its points.
std::string whole_triangle_name(const TriangleMesh& mesh, int triangle, const Names& names);

}  // namespace sbeh::meshing

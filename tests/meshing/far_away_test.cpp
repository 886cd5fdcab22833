// What is measured does not depend on where a surface lies.
#include "meshing/measures.h"
#include "meshing/shapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace sbeh::meshing {
namespace {

TEST(Measures, do_not_depend_on_the_place) {
  for (const int order : {1, 2, 3}) {
    const CurvedMesh here = ellipsoid({1, 1.3, 0.7}, {.triangles = 320, .order = order});
    for (const double way : {1., 1e3, 1e5, 1e7}) {
      CurvedMesh there = here;
      const Eigen::Vector3d shift = way * Eigen::Vector3d(1, 0.9, -0.8);
      there.nodes.colwise() += shift;
      // The coordinates themselves are rounded.
      const double rounding = 100 * way * std::numeric_limits<double>::epsilon();
      EXPECT_NEAR(volume(there), volume(here), rounding) << way;
      EXPECT_NEAR(area(there), area(here), rounding) << way;
      EXPECT_LT((centre(there) - centre(here) - shift).norm(), rounding) << way;
      EXPECT_LT(centre(here).norm(), 1e-12);
      if (order == 1) {
        const TriangleMesh near{here.nodes, here.triangles}, far{there.nodes, here.triangles};
        EXPECT_NEAR(volume(far), volume(near), rounding) << way;
      }
    }
  }
}

}  // namespace
}  // namespace sbeh::meshing

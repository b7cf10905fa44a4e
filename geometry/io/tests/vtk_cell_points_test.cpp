#include "geometry/io/vtk_cell_points.hpp"

#include <gtest/gtest.h>
#include <vtkHigherOrderHexahedron.h>

namespace isopatch::geometry {
namespace {

TEST(VtkCellPoints, AreInVtksOrder) {
  for (int p = 1; p <= 4; ++p)
    for (int q = 1; q <= 4; ++q)
      for (int r = 1; r <= 4; ++r) {
        const std::array<int, 3> degree = {p, q, r};
        for (int k = 0; k <= r; ++k)
          for (int j = 0; j <= q; ++j)
            for (int i = 0; i <= p; ++i)
              EXPECT_EQ(vtk_cell_point({i, j, k}, degree),
                        vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, degree.data()))
                  << p << q << r << " at " << i << j << k;
      }
}

}  // namespace
}  // namespace isopatch::geometry

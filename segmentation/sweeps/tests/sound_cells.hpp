#pragma once

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "geometry/brep/cell_solids.hpp"

namespace isopatch::segmentation::test {

/// Hexahedra that fill the solid and meet side to side; what lies on its faces has their areas, face by face.
/// @param off  share by which the solid itself is off
inline void expect_sound(const geometry::Brep& solid, const geometry::CellComplex& complex,
                         double off = 1e-9) {
  double volume = 0;
  std::map<FaceId, double> areas;
  std::map<FaceId, int> uses;
  const std::vector<geometry::Brep> cells = geometry::cell_solids(solid, complex);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    EXPECT_GT(cells[c].volume(), 0);
    volume += cells[c].volume();
    ASSERT_EQ(cells[c].faces().size(), 6U);
    ASSERT_EQ(cells[c].edges().size(), 12U);
    ASSERT_EQ(cells[c].vertices().cols(), 8);
    for (std::size_t f = 0; f < 6; ++f) {
      const FaceId face = complex.cells[c].faces[f].face;
      ++uses[face];
      if (const auto origin = complex.face(face).origin)
        areas[*origin] += cells[c].area(FaceId(static_cast<int>(f)));
    }
  }
  EXPECT_NEAR(volume, solid.volume(), off * solid.volume());
  for (const auto& [face, count] : uses) EXPECT_EQ(count, complex.face(face).origin ? 1 : 2);
  ASSERT_EQ(areas.size(), solid.faces().size());
  for (const auto& [face, area] : areas) EXPECT_NEAR(area, solid.area(face), off * solid.area());
}

}  // namespace isopatch::segmentation::test

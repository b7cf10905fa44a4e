#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "segmentation/decomposition/cutting/cut_cell.hpp"

namespace isopatch::segmentation::samples {

/// The cut of a hexahedral cell by a plane that crosses four of its edges and no corner.
inline CutAttempt cut_across(const geometry::Brep& source, const geometry::CellComplex& complex,
                             geometry::CellId cell, const geometry::PlaneSurface& plane) {
  const CellShapes shapes(source, complex);
  const CellSides sides = cell_sides(shapes, cell);
  const CellIncidence incidence(sides.graph);
  PlacedLoop loop;
  std::vector<LoopPlace> places;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t e = 0; e < sides.edges.size(); ++e) {
    const EdgeId edge = sides.edges[e].front().edge;
    const auto height = [&](double t) { return plane.normal().dot(shapes.point(edge, t) - plane.origin); };
    if (height(0) * height(1) > 0) continue;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double t = (low + high) / 2;
      ((height(t) < 0) == (height(0) < 0) ? low : high) = t;
    }
    places.push_back(LoopPlace::inside(EdgeId(static_cast<int>(e))));
    points.push_back(shapes.point(edge, low));
  }
  if (places.size() != 4) throw std::runtime_error("the plane does not cross four edges");
  std::vector<std::size_t> order = {0, 1, 2, 3};
  const auto share_a_side = [&](std::size_t a, std::size_t b) {
    const auto one = faces_at(incidence, places[a]), other = faces_at(incidence, places[b]);
    return std::any_of(one.begin(), one.end(), [&](FaceId face) {
      return std::find(other.begin(), other.end(), face) != other.end();
    });
  };
  const auto is_round = [&] {
    for (std::size_t i = 0; i < 4; ++i)
      if (!share_a_side(order[i], order[(i + 1) % 4])) return false;
    return true;
  };
  while (!is_round() && std::next_permutation(order.begin(), order.end())) {
  }
  std::vector<LoopPlace> around;
  for (const std::size_t i : order) {
    around.push_back(places[i]);
    loop.points.push_back(points[i]);
  }
  loop.loop = loop_through(sides.graph, incidence, around);
  return cut_cell(source, complex, cell, sides, loop);
}

}  // namespace isopatch::segmentation::samples

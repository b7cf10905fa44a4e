#include "segmentation/balls/ball_cells.hpp"

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "segmentation/balls/internal/ball_complex.hpp"
#include "segmentation/balls/internal/cube_sides.hpp"
#include "segmentation/balls/internal/seen_face.hpp"
#include "segmentation/sweeps/interpolate.hpp"
#include "segmentation/sweeps/require_all_of.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// Between the points that a side goes through, of which there are `spans + 5` along either direction.
double distance_between(const geometry::NurbsSurface& side, const SeenFace& face,
                        const std::array<int, 4>& corners, int spans) {
  constexpr int places = 7;
  double worst = 0;
  for (int i = 0; i < places; ++i)
    for (int j = 0; j < places; ++j) {
      const auto middle_of_a_span = [&](int k) {
        const int span = (2 * k + 1) * spans / (2 * places);
        return (span + 0.41) / spans;  // none of the points
      };
      const double u = middle_of_a_span(i), v = middle_of_a_span(j);
      worst = larger(
          worst, (side.point(geometry::Parameter<2>(u, v)) - face.point(on_sphere(corners, u, v))).norm());
    }
  return worst;
}

BallCells of_ball(const Brep& solid) {
  // Of the size: what is reached at the poles of a turned spline with 32 spans.
  constexpr double tolerance = 2e-6;
  const BallFrame frame = ball_frame(solid);
  const SeenFace face(solid, frame);
  for (const int spans : {8, 16, 32, 64}) {
    const auto side = [&](std::size_t s) {
      return interpolated([&](double u, double v) { return face.point(on_sphere(cube_sides[s], u, v)); },
                          spans);
    };
    const OuterSides outer = {side(0), side(1), side(2), side(3), side(4), side(5)};
    double worst = 0;
    for (std::size_t s = 0; s < outer.size(); ++s)
      worst = larger(worst, distance_between(outer[s], face, cube_sides[s], spans));
    if (worst <= tolerance * solid.size()) return {ball_complex(outer, frame.centre), spans};
  }
  throw Error(ErrorCode::unsupported, "its face has waves, or an edge or a tip somewhere");
}

}  // namespace

bool is_one_closed_face(const Brep& solid) {
  if (solid.faces().size() != 1) return false;
  const auto& edges = solid.edges();
  const bool seams = std::all_of(edges.begin(), edges.end(), [](const geometry::BrepEdge& edge) {
    return edge.faces.size() == 2 && edge.faces[0] == edge.faces[1];
  });
  // Euler's number of a sphere; a torus has 0.
  return seams && solid.vertices().cols() - static_cast<Eigen::Index>(edges.size()) + 1 == 2;
}

std::optional<BallCells> ball_cells(const Brep& solid) {
  if (!is_one_closed_face(solid)) return std::nullopt;
  BallCells result = of_ball(solid);
  require_all_of(solid, result.complex);
  return result;
}

}  // namespace isopatch::segmentation

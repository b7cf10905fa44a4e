#include "segmentation/sweeps/internal/roofed_cells.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/splines/coons.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/internal/column_complex.hpp"
#include "segmentation/sweeps/internal/divided_drawing.hpp"
#include "segmentation/sweeps/internal/roof.hpp"
#include "segmentation/sweeps/interpolate.hpp"
#include "segmentation/sweeps/require_all_of.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::NurbsCurve;

/// Cones that are roofs are floors, not walls.
SweepFrame with_roofs(SweepFrame frame, const std::vector<FaceId>& roofs) {
  const auto is_roof = [&](FaceId face) {
    return std::find(roofs.begin(), roofs.end(), face) != roofs.end();
  };
  std::erase_if(frame.walls, is_roof);
  std::erase_if(frame.inclined, is_roof);
  frame.floors.insert(frame.floors.end(), roofs.begin(), roofs.end());
  return frame;
}

using Lines = std::vector<std::array<Eigen::Vector3d, 2>>;

/// Straight up every cone from where its walls meet to its circle: so each wall has one quadrilateral there.
Lines spokes(const Brep& solid, const SweepFrame& frame, const std::vector<FaceId>& faces) {
  std::vector<std::array<Eigen::Vector2d, 2>> found;  // corner and foot
  for (const FaceId face : faces) {
    const Roof roof(solid, frame, face);
    for (const Eigen::Vector2d& corner : roof.corners(solid)) {
      const Eigen::Vector2d foot = roof.centre() + roof.radius() * (corner - roof.centre()).normalized();
      const auto known = std::find_if(found.begin(), found.end(), [&](const auto& spoke) {
        return (spoke[0] - corner).norm() < 1e-6 * solid.size();
      });
      if (known == found.end())
        found.push_back({corner, foot});
      else if ((foot - corner).norm() > ((*known)[1] - corner).norm())
        (*known)[1] = foot;
    }
  }
  Lines result;
  for (const auto& [corner, foot] : found) result.push_back({frame.point(corner, 0), frame.point(foot, 0)});
  return result;
}

class RoofedStack {
 public:
  RoofedStack(const Brep& solid, const SweepFrame& frame, const std::vector<FaceId>& faces,
              const Lines& lines, const QuadrangulationOptions& options,
              const std::vector<double>& heights = {})
      : solid_(solid),
        frame_(with_roofs(frame, faces)),
        divided_(divided_drawing(solid, frame_, lines, options)),
        moving_(solid, frame_, divided_.drawing, divided_.quads),
        layers_(layers(divided_.quads, divided_.drawing.slabs, moving_,
                       std::vector<std::vector<double>>(divided_.quads.quads.size(), heights),
                       1e-7 * solid.size())) {
    for (const FaceId face : faces) roofs_.emplace_back(solid, frame_, face);
  }

  SweptCells make() {
    for (std::size_t q = 0; q < divided_.quads.quads.size(); ++q)
      for (const Layer& layer : layers_.columns[q]) {
        if (const Roof* roof = roof_at(layer.bottom)) put_under(*roof, static_cast<int>(q), layer.low);
        if (const Roof* roof = roof_at(layer.top)) put_under(*roof, static_cast<int>(q), layer.high);
      }
    SweptCells result{column_complex(solid_, frame_, divided_.quads, moving_, layers_, rounding_),
                      frame_.along, static_cast<int>(divided_.quads.quads.size()),
                      static_cast<int>(layers_.levels.size())};
    require_all_of(solid_, result.complex);
    return result;
  }

 private:
  double height(int level) const { return layers_.levels[static_cast<std::size_t>(level)]; }

  const Roof* roof_at(std::optional<FaceId> face) const {
    for (const Roof& roof : roofs_)
      if (face && roof.face() == *face) return &roof;
    return nullptr;
  }

  /// A quadrilateral of a level goes to where the roof is.
  void put_under(const Roof& roof, int quad, int level) {
    const auto& sides = divided_.quads.quads[static_cast<std::size_t>(quad)].sides;
    std::array<NurbsCurve, 4> around;
    for (std::size_t i = 0; i < 4; ++i) {
      const int number = sides[i].edge.value;
      const QuadEdge& drawn = divided_.quads.edges[static_cast<std::size_t>(number)];
      const NurbsCurve curve =
          rounding_.level_edges
              .try_emplace({number, level}, roof.lifted(moving_.curve(number, height(level))))
              .first->second;
      move_to(drawn.start, level, curve.control_points().col(0));
      move_to(drawn.end, level, curve.control_points().rightCols(1));
      around[i] = sides[i].reversed ? reversed(curve, 0) : curve;
    }
    // Looks up; one that looks down begins at the same side, which it runs through the other way.
    if (!roof.looks_up())
      around = {reversed(around[0], 0), reversed(around[3], 0), reversed(around[2], 0),
                reversed(around[1], 0)};
    const geometry::NurbsSurface between = geometry::coons_surface(around);
    geometry::NurbsSurface surface = interpolated([&](double u, double v) -> Eigen::Vector3d {
      const Eigen::Vector2d flat = frame_.flat(between.point({u, v}));
      return frame_.point(flat, roof.height(flat));
    });
    // By its first edge as that is drawn.
    if (sides[0].reversed == roof.looks_up()) surface = reversed(surface, 0);
    rounding_.floors.insert_or_assign(
        {quad, level}, Rounding::Side{{sides[0].edge.value, level}, std::move(surface), roof.face()});
  }

  void move_to(int vertex, int level, const Eigen::Vector3d& place) {
    if ((place - moving_.place(vertex, height(level))).norm() > 1e-9 * solid_.size())
      rounding_.vertices[{vertex, level}] = place;
  }

  const Brep& solid_;
  SweepFrame frame_;
  DividedDrawing divided_;
  MovingDrawing moving_;
  Layers layers_;
  std::vector<Roof> roofs_;
  Rounding rounding_;
};

}  // namespace

bool has_roofs(const Brep& solid, const SweepFrame& frame) {
  return !roofs(solid, frame).empty();
}

SweptCells roofed_cells_with(const Brep& solid, const SweepFrame& frame, const Lines& lines,
                             const std::vector<double>& heights) {
  const std::vector<FaceId> faces = roofs(solid, frame);
  Lines all = spokes(solid, frame, faces);
  all.insert(all.end(), lines.begin(), lines.end());
  try {
    return RoofedStack(solid, frame, faces, all, {.thorough = true}, heights).make();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return RoofedStack(solid, frame, faces, lines, {}, heights).make();
  }
}

std::optional<SweptCells> roofed_cells(const Brep& solid, const QuadrangulationOptions& options) {
  for (const SweepFrame& frame : sweep_frames(solid)) {
    const std::vector<FaceId> faces = roofs(solid, frame);
    if (faces.empty()) continue;
    try {
      return RoofedStack(solid, frame, faces, spokes(solid, frame, faces), options).make();
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      return RoofedStack(solid, frame, faces, {}, options).make();
    }
  }
  return std::nullopt;
}

}  // namespace isopatch::segmentation

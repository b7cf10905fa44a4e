#include "segmentation/turned/internal/turned_complex.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"
#include "segmentation/turned/internal/surfaces.hpp"
#include "segmentation/turned/internal/turned_edges.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellFace;
using geometry::EdgeUse;
using geometry::NurbsCurve;
using geometry::PlaneSurface;
using geometry::SurfaceId;

/// Something of the drawing, and the number of its meridian or sector.
using Turned = std::pair<int, int>;

void turn_around(std::vector<EdgeUse>& loop) {
  std::reverse(loop.begin(), loop.end());
  for (EdgeUse& use : loop) use.reversed = !use.reversed;
}

/// Makes every face once.
class TurnedComplex {
 public:
  TurnedComplex(const Brep& solid, const TurnedFrame& frame, const TurnedDrawing& drawing, int sectors)
      : solid_(solid),
        frame_(frame),
        drawing_(drawing),
        sectors_(sectors),
        edges_(frame, drawing, sectors),
        beside_(drawing.curves.size(), 0) {
    for (const Quad& quad : drawing.quads.quads)
      for (const EdgeUse& side : quad.sides) ++beside_[static_cast<std::size_t>(side.edge.value)];
    for (const std::vector<int>& column : drawing.columns)
      for (const int edge : column) ++beside_[static_cast<std::size_t>(edge)];
  }

  CellComplex make() {
    for (int q = 0; q < static_cast<int>(drawing_.quads.quads.size()); ++q)
      for (int s = 0; s < sectors_; ++s) add_cell(q, s);
    for (const std::vector<int>& column : drawing_.columns)
      for (std::size_t i = 0; i < column.size(); ++i) {
        for (int r = 0; r < rungs() && frame_.is_whole(); ++r) add_column_cell(column[i], i == 0, r);
        for (int s = 0; s < sectors_ && !frame_.is_whole(); s += 2) add_corner_cell(column[i], i == 0, s);
      }
    return std::move(complex_);
  }

 private:
  const QuadEdge& drawn(int edge) const { return drawing_.quads.edges[static_cast<std::size_t>(edge)]; }
  const NurbsCurve& curve(int edge) const { return drawing_.curves[static_cast<std::size_t>(edge)]; }
  const Eigen::Vector2d& flat(int vertex) const { return drawing_.places[static_cast<std::size_t>(vertex)]; }
  double tolerance() const { return 1e-9 * solid_.size(); }
  bool is_outer(EdgeId edge) const { return beside_[static_cast<std::size_t>(edge.value)] == 1; }
  bool is_last(int meridian) const { return !frame_.is_whole() && meridian == sectors_; }

  /// The face of the solid at a place, of some.
  FaceId origin_at(const std::vector<FaceId>& faces, const Eigen::Vector3d& place) const {
    if (faces.size() == 1) return faces.front();
    for (const FaceId face : faces) {
      const geometry::FaceProjection nearest = solid_.project(face, place);
      if (nearest.distance < 1e-6 * solid_.size() && solid_.contains(face, nearest.uv)) return face;
    }
    throw Error(ErrorCode::unsupported, fmt::format("no face of the solid is at ({:.6g}, {:.6g}, {:.6g}) m",
                                                    place.x(), place.y(), place.z()));
  }

  /// Looks back, but the last one of what is no whole turn out of the solid.
  SurfaceId meridian_plane(int meridian) {
    const auto [plane, fresh] = planes_.try_emplace(meridian, SurfaceId(0));
    if (fresh) {
      const Eigen::Vector3d out = frame_.point({1, 0}, edges_.angle(meridian)) - frame_.origin;
      plane->second =
          complex_.add_surface(is_last(meridian) ? PlaneSurface{frame_.origin, frame_.along, out}
                                                 : PlaneSurface{frame_.origin, out, frame_.along});
    }
    return plane->second;
  }

  /// A face in a meridian's plane, with a loop that looks back and a point inside it.
  CellFace meridian_face(int meridian, std::vector<EdgeUse> loop, const Eigen::Vector2d& inside) {
    CellFace face{meridian_plane(meridian), std::move(loop), {}};
    if (is_last(meridian)) turn_around(face.loop);
    if (!frame_.is_whole() && (meridian == 0 || is_last(meridian)))
      face.origin =
          origin_at(meridian == 0 ? frame_.first : frame_.last, frame_.point(inside, edges_.angle(meridian)));
    return face;
  }

  /// The face between two sectors: a quadrilateral of the drawing at a meridian.
  FaceId section(int quad, int meridian) {
    const auto known = sections_.find({quad, meridian});
    if (known != sections_.end()) return known->second;
    std::vector<EdgeUse> loop;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const EdgeUse& side : drawing_.quads.quads[static_cast<std::size_t>(quad)].sides) {
      loop.push_back({edges_.meridian(side.edge.value, meridian), side.reversed});
      middle += frame_.flat(curve(side.edge.value).point(geometry::Parameter<1>(0.5))) / 2;
      middle -= flat(side.reversed ? drawn(side.edge.value).end : drawn(side.edge.value).start) / 4;
    }
    return sections_[{quad, meridian}] = complex_.add_face(meridian_face(meridian, std::move(loop), middle));
  }

  /// Between the axis and an edge of the column's side.
  FaceId axis_section(int edge, int meridian) {
    const auto known = axis_sections_.find({edge, meridian});
    if (known != axis_sections_.end()) return known->second;
    const int low = drawn(edge).start, high = drawn(edge).end;
    const Eigen::Vector2d middle = (flat(low) + flat(high)) / 2;
    return axis_sections_[{edge, meridian}] =
               complex_.add_face(meridian_face(meridian,
                                               {{edges_.radial(low, meridian), false},
                                                {edges_.meridian(edge, meridian), false},
                                                {edges_.radial(high, meridian), true},
                                                {edges_.axis(edge), true}},
                                               {middle[0] / 2, middle[1]}));
  }

  /// Over an edge of the drawing in a sector; looks to its right, or out of the solid.
  FaceId wall(EdgeUse side, int sector) {
    const int number = side.edge.value;
    const auto known = walls_.find({number, sector});
    if (known != walls_.end()) return known->second;
    const bool outer = is_outer(side.edge);
    const bool turned = outer && side.reversed;
    const int from = turned ? drawn(number).end : drawn(number).start;
    const int to = turned ? drawn(number).start : drawn(number).end;
    const EdgeId low = edges_.around(from, sector), high = edges_.around(to, sector);
    const EdgeId here = edges_.meridian(number, sector), there = edges_.meridian(number, edges_.next(sector));
    CellFace face{SurfaceId(0), {{low, false}, {there, turned}, {high, true}, {here, !turned}}, {}};
    const NurbsCurve along = turned ? geometry::reversed(curve(number), 0) : curve(number);
    if (outer) {
      const auto& faces =
          drawing_.half.outside.curves[static_cast<std::size_t>(drawn(number).profile_edge)].faces;
      Eigen::Vector2d middle = frame_.flat(along.point(geometry::Parameter<1>(0.5)));
      const double half = frame_.sweep / sectors_ / 2;
      if (edges_.has_chords(from) && edges_.has_chords(to) && !edges_.core_end(from) && !edges_.core_end(to))
        middle[0] *= std::cos(half);
      face.origin = origin_at(faces, frame_.point(middle, (2 * sector + 1) * half));
    }
    face.surface = wall_surface(along, {from, to}, {low, high, here, there}, turned, outer, sector);
    return walls_[{number, sector}] = complex_.add_face(std::move(face));
  }

  struct Around {
    EdgeId low, high, here, there;
  };

  SurfaceId wall_surface(const NurbsCurve& along, std::array<int, 2> ends, const Around& edges, bool turned,
                         bool outer, int sector) {
    const bool straight = along.degree(0) == 1 && along.size() == 2;
    const bool beside_core = edges_.is_core(ends[0]) || edges_.is_core(ends[1]);
    const bool turned_everywhere = !edges_.has_chords(ends[0]) && !edges_.has_chords(ends[1]);
    if (straight && std::abs(flat(ends[0])[1] - flat(ends[1])[1]) < tolerance()) {
      const bool up = flat(ends[0])[0] > flat(ends[1])[0];
      return complex_.add_surface(
          PlaneSurface{frame_.point({0, flat(ends[0])[1]}, 0), frame_.x, up ? frame_.y : -frame_.y});
    }
    if (outer && beside_core)
      return sphere_surface(edges_.is_core(ends[0]) ? ends[0] : ends[1],
                            {edges.low, edges.high, edges.here, edges.there});
    SurfaceId made(0);
    if (turned_everywhere) {
      made = complex_.add_surface(turned_surface(frame_.turned(along, edges_.angle(sector)), frame_.origin,
                                                 frame_.along, frame_.sweep / sectors_));
    } else {
      if (const auto plane = plane_through(edges)) return complex_.add_surface(*plane);
      made = complex_.add_surface(geometry::ruled(edges_.shape(edges.low), edges_.shape(edges.high)));
    }
    const double start = turned ? 1 : 0;
    complex_.add_trace({edges.low, false}, made, geometry::segment({0, 0, 0}, {1, 0, 0}));
    complex_.add_trace({edges.high, false}, made, geometry::segment({0, 1, 0}, {1, 1, 0}));
    complex_.add_trace({edges.here, false}, made, geometry::segment({0, start, 0}, {0, 1 - start, 0}));
    complex_.add_trace({edges.there, false}, made, geometry::segment({1, start, 0}, {1, 1 - start, 0}));
    return made;
  }

  /// Of chords below and above.
  std::optional<PlaneSurface> plane_through(const Around& edges) const {
    for (const EdgeId edge : {edges.low, edges.high})
      if (edges_.shape(edge).degree(0) != 1) return std::nullopt;
    const Eigen::Vector3d a = edges_.shape(edges.low).control_points().col(0),
                          b = edges_.shape(edges.low).control_points().col(1);
    const Eigen::Vector3d up = edges_.shape(edges.high).control_points().col(0) - a;
    const Eigen::Vector3d x = (b - a).normalized();
    return PlaneSurface{a, x, (up - up.dot(x) * x).normalized()};
  }

  /// The direction of the middle of what some edges bound, on the sphere that is stretched to a spheroid.
  Eigen::Vector3d middle_of(const Spheroid& spheroid, const std::vector<EdgeId>& edges) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const EdgeId edge : edges)
      sum += spheroid.unstretched(edges_.shape(edge).point(geometry::Parameter<1>(0.5))) - spheroid.centre;
    return sum.normalized();
  }

  static Eigen::Vector3d point_of(const Spheroid& spheroid, const Eigen::Vector3d& direction) {
    return spheroid.stretched(spheroid.centre + spheroid.radius * direction);
  }

  /// Around the middle of what some edges bound on the sphere at a corner of the column.
  SurfaceId sphere_surface(int corner, const std::vector<EdgeId>& edges) {
    const CoreEnd& end = *edges_.core_end(corner);
    const Eigen::Vector3d middle = middle_of(*end.sphere, edges);
    const geometry::FaceProjection on = solid_.project(end.faces.front(), point_of(*end.sphere, middle));
    const bool inwards = solid_.outward_normal(end.faces.front(), on.uv).dot(middle) < 0;
    const SpherePatch patch(*end.sphere, middle, inwards);
    std::vector<NurbsCurve> traces;
    double reach = 0;
    for (const EdgeId edge : edges) {
      traces.push_back(patch.trace(edges_.shape(edge)));
      reach = std::max(reach, traces.back().control_points().cwiseAbs().maxCoeff());
    }
    const SurfaceId made = complex_.add_surface(patch.surface(1.25 * reach));
    for (std::size_t i = 0; i < edges.size(); ++i)
      complex_.add_trace({edges[i], false}, made, std::move(traces[i]));
    return made;
  }

  /// Across the column at a corner of its side, what some edges bound, counterclockwise as seen from above.
  /// Looks up, or out of the solid at its low end.
  CellFace across(int corner, bool lowest, const std::vector<EdgeUse>& loop) {
    CellFace face{SurfaceId(0), loop, {}};
    if (lowest) turn_around(face.loop);
    const CoreEnd* end = edges_.core_end(corner);
    if (end && end->sphere && rungs() > 1)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} is round on the axis of a prism with more than four sides",
                              describe(solid_, end->faces.front())));
    std::vector<EdgeId> edges;
    for (const EdgeUse& use : loop) edges.push_back(use.edge);
    if (end && end->sphere)
      face.surface = sphere_surface(corner, edges);
    else
      face.surface = complex_.add_surface(PlaneSurface{frame_.point({0, flat(corner)[1]}, 0), frame_.x,
                                                       lowest ? Eigen::Vector3d(-frame_.y) : frame_.y});
    if (end) face.origin = origin_at(end->faces, inside(*end, edges));
    return face;
  }

  /// A point of the solid within what some edges bound at an end of the column.
  Eigen::Vector3d inside(const CoreEnd& end, const std::vector<EdgeId>& edges) const {
    if (end.sphere) return point_of(*end.sphere, middle_of(*end.sphere, edges));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const EdgeId edge : edges) sum += edges_.shape(edge).point(geometry::Parameter<1>(0.5));
    return sum / static_cast<double>(edges.size());
  }

  /// Hexahedra of a whole turn's column beside each other: between rungs across it, from one side to the
  /// opposite one.
  int rungs() const { return sectors_ / 2 - 1; }

  /// Between the corners of the column at meridians r + 1 and its mirror image; the outermost are sides.
  EdgeUse rung(int corner, int r) {
    const int low = (sectors_ - r) % sectors_, high = r + 1;
    if (r == 0) return {edges_.around(corner, 0), false};
    if (r == rungs()) return {edges_.around(corner, r + 1), true};
    return {edges_.rung(corner, low, high), false};
  }

  /// Between two rungs.
  FaceId square(int corner, bool lowest, int r) {
    const auto known = squares_.find({corner, r});
    if (known != squares_.end()) return known->second;
    const EdgeUse low = rung(corner, r), high = rung(corner, r + 1);
    const std::vector<EdgeUse> loop = {low,
                                       {edges_.around(corner, r + 1), false},
                                       {high.edge, !high.reversed},
                                       {edges_.around(corner, sectors_ - 1 - r), false}};
    return squares_[{corner, r}] = complex_.add_face(across(corner, lowest, loop));
  }

  /// In the column over a rung; looks towards the first side.
  FaceId rung_wall(int edge, int r) {
    const auto known = rung_walls_.find({edge, r});
    if (known != rung_walls_.end()) return known->second;
    const int low = drawn(edge).start, high = drawn(edge).end;
    const int here = (sectors_ - r) % sectors_, there = r + 1;
    const EdgeUse below = rung(low, r), above = rung(high, r);
    const EdgeId first = edges_.meridian(edge, here), last = edges_.meridian(edge, there);
    const Eigen::Vector3d from = complex_.vertex(complex_.from(below)),
                          way = complex_.vertex(complex_.to(below)) - from;
    const SurfaceId plane = complex_.add_surface(PlaneSurface{from, way.normalized(), frame_.along});
    return rung_walls_[{edge, r}] = complex_.add_face(
               {plane, {below, {last, false}, {above.edge, !above.reversed}, {first, true}}, {}});
  }

  /// Beside the axis in two sectors.
  FaceId corner_square(int corner, bool lowest, int sector) {
    const auto known = squares_.find({corner, sector});
    if (known != squares_.end()) return known->second;
    return squares_[{corner, sector}] =
               complex_.add_face(across(corner, lowest,
                                        {{edges_.radial(corner, sector), false},
                                         {edges_.around(corner, sector), false},
                                         {edges_.around(corner, sector + 1), false},
                                         {edges_.radial(corner, sector + 2), true}}));
  }

  static void add(geometry::Cell& cell, FaceId face, bool reversed) {
    cell.faces.push_back({face, reversed, static_cast<int>(cell.faces.size())});
  }

  void add_cell(int quad, int sector) {
    geometry::Cell cell;
    const int next = edges_.next(sector);
    add(cell, section(quad, sector), false);
    add(cell, section(quad, next), !is_last(next));
    for (const EdgeUse& side : drawing_.quads.quads[static_cast<std::size_t>(quad)].sides)
      add(cell, wall(side, sector), !is_outer(side.edge) && side.reversed);
    complex_.cells.push_back(std::move(cell));
  }

  /// Beside an edge of the column's side, which runs up, so that its right is outside of the column.
  void add_column_cell(int edge, bool lowest, int r) {
    geometry::Cell cell;
    const auto side = [&](int sector) { add(cell, wall({EdgeId(edge), false}, sector), false); };
    add(cell, square(drawn(edge).start, lowest, r), !lowest);
    add(cell, square(drawn(edge).end, false, r), false);
    if (r == 0)
      side(0);
    else
      add(cell, rung_wall(edge, r), false);
    side(r + 1);
    if (r + 1 == rungs())
      side(r + 2);
    else
      add(cell, rung_wall(edge, r + 1), true);
    side(sectors_ - 1 - r);
    complex_.cells.push_back(std::move(cell));
  }

  /// The same where the axis is an edge of it.
  void add_corner_cell(int edge, bool lowest, int sector) {
    geometry::Cell cell;
    add(cell, corner_square(drawn(edge).start, lowest, sector), !lowest);
    add(cell, corner_square(drawn(edge).end, false, sector), false);
    for (int s = sector; s < sector + 2; ++s) add(cell, wall({EdgeId(edge), false}, s), false);
    add(cell, axis_section(edge, sector), false);
    add(cell, axis_section(edge, sector + 2), !is_last(sector + 2));
    complex_.cells.push_back(std::move(cell));
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  const TurnedDrawing& drawing_;
  int sectors_;
  TurnedEdges edges_;
  CellComplex& complex_ = edges_.complex;
  std::vector<int> beside_;  // cells at edges of the drawing
  std::map<Turned, FaceId> sections_, axis_sections_, walls_, squares_, rung_walls_;
  std::map<int, SurfaceId> planes_;
};

}  // namespace

CellComplex turned_complex(const Brep& solid, const TurnedFrame& frame, const TurnedDrawing& drawing,
                           int sectors) {
  return TurnedComplex(solid, frame, drawing, sectors).make();
}

}  // namespace isopatch::segmentation

#include "segmentation/branches/internal/plan_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/branches/internal/frame_around.hpp"
#include "segmentation/profiles/quadrangulate.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;
using Uses = std::vector<EdgeUse>;

constexpr double right_angle = std::numbers::pi / 2;

Eigen::Vector3d on_ground(const Eigen::Vector2d& point) {
  return {point.x(), point.y(), 0};
}

/// Where a spline looks towards a corner of a square: shares of its parameters.
std::vector<double> turns_of(const geometry::NurbsCurve& spline) {
  const auto turn = [&](double t) {  // 0 where it looks at a corner
    const Eigen::Vector3d way = spline.jacobian(geometry::Parameter<1>(t));
    return std::sin(2 * (std::atan2(way.y(), way.x()) - right_angle / 2));
  };
  constexpr int steps = 256;
  std::vector<double> result;
  for (int i = 1; i < steps; ++i) {
    double low = static_cast<double>(i) / steps, high = static_cast<double>(i + 1) / steps;
    const bool rises = turn(low) < 0;
    if (i + 1 == steps || rises == (turn(high) < 0)) continue;
    for (int k = 0; k < 50; ++k) ((turn((low + high) / 2) < 0) == rises ? low : high) = (low + high) / 2;
    result.push_back(low);
  }
  return result;
}

std::vector<PlanCurve> spline_pieces(const PlanCurve& curve) {
  std::vector<double> shares = {0};
  for (const double share : turns_of(*curve.spline)) shares.push_back(share);
  shares.push_back(1);
  std::vector<PlanCurve> result;
  for (std::size_t i = 1; i < shares.size(); ++i)
    result.push_back(
        {curve.point(shares[i - 1]), curve.point(shares[i]), {}, 0, curve.piece(shares[i - 1], shares[i])});
  return result;
}

/// Divided where it looks towards corners of a square, so that a side faces no more than a right angle of it.
std::vector<PlanCurve> pieces_of(const PlanCurve& curve) {
  if (curve.spline) return spline_pieces(curve);
  if (curve.is_straight()) return {curve};
  const Eigen::Vector2d out = curve.from - curve.centre;
  const double start = std::atan2(out.y(), out.x()), sign = curve.sweep > 0 ? 1 : -1;
  std::vector<double> shares = {0};
  const double first =
      std::ceil((sign * start - right_angle / 2) / right_angle) * right_angle + right_angle / 2;
  for (double at = first; at < sign * start + std::abs(curve.sweep) - 1e-6; at += right_angle)
    if (const double share = (at - sign * start) / std::abs(curve.sweep); share > 1e-6)
      shares.push_back(share);
  shares.push_back(1);
  std::vector<PlanCurve> result;
  for (std::size_t i = 1; i < shares.size(); ++i)
    result.push_back({curve.point(shares[i - 1]), curve.point(shares[i]), curve.centre,
                      (shares[i] - shares[i - 1]) * curve.sweep});
  return result;
}

class Drafter {
 public:
  /// @param divided  outlines where they look towards corners
  Drafter(const std::array<Eigen::Vector2d, 4>& corners, const std::vector<Outline>& outlines, bool divided)
      : outlines_(outlines), parent_(nesting(outlines)) {
    if (std::count(parent_.begin(), parent_.end(), -1) != 1)
      throw Error(ErrorCode::unsupported, "a branch has several outlines beside each other");
    for (std::size_t i = 0; i < 4; ++i) {
      drawn_.curves.push_back({corners[i], corners[(i + 1) % 4]});
      drawn_.outline_of.push_back(-1);
      drawn_.quads.vertices.push_back(corners[i]);
      drawn_.quads.edges.push_back({static_cast<int>(i), static_cast<int>((i + 1) % 4), static_cast<int>(i)});
    }
    for (std::size_t o = 0; o < outlines.size(); ++o) rings_.push_back(ring(static_cast<int>(o), divided));
  }

  PlanDrawing make(const std::vector<bool>& wanted, const std::vector<PlanQuad>& inside) {
    for (std::size_t o = 0; o < rings_.size(); ++o) {
      profile_.regions.push_back({loops(static_cast<int>(o)), wanted[o]});
      drawn_.around.push_back(static_cast<int>(o));
    }
    drawn_.around.push_back(-1);
    if (!inside.empty())
      for (const PlanQuad& quad : inside) add(quad);
    else if (std::find(wanted.begin(), wanted.end(), true) == wanted.end())
      add(pieces_alone());
    else
      add(quadrangulate(profile_));
    add_frame(static_cast<int>(drawn_.around.size()) - 1, outer_ring(), drawn_.quads);
    return std::move(drawn_);
  }

 private:
  Uses ring(int outline, bool divided) {
    std::vector<PlanCurve> pieces;
    const std::vector<PlanCurve>& curves = outlines_[static_cast<std::size_t>(outline)].curves;
    const bool keeps_splines = curves.size() >= 4 && curves.size() % 2 == 0;
    for (const PlanCurve& curve : curves)
      for (PlanCurve& piece :
           divided && !(curve.spline && keeps_splines) ? pieces_of(curve) : std::vector{curve})
        pieces.push_back(std::move(piece));
    const int first = static_cast<int>(profile_.vertices.size()), count = static_cast<int>(pieces.size());
    Uses result;
    for (int i = 0; i < count; ++i) {
      PlanCurve& piece = pieces[static_cast<std::size_t>(i)];
      piece.to = pieces[static_cast<std::size_t>((i + 1) % count)].from;
      profile_.vertices.push_back(piece.from);
      ProfileEdge edge{first + i, first + (i + 1) % count, {}};
      const int steps = piece.is_straight() ? 1 : 24;
      for (int k = 0; k <= steps; ++k) edge.points.push_back(piece.point(static_cast<double>(k) / steps));
      edge.points.back() = piece.to;
      result.push_back({EdgeId(static_cast<int>(profile_.edges.size())), false});
      profile_.edges.push_back(std::move(edge));
      drawn_.curves.push_back(piece);
      drawn_.outline_of.push_back(outline);
    }
    return result;
  }

  /// With what lies directly inside, run the other way round.
  std::vector<Uses> loops(int number) const {
    std::vector<Uses> result = {rings_[static_cast<std::size_t>(number)]};
    for (std::size_t o = 0; o < rings_.size(); ++o) {
      if (parent_[o] != number) continue;
      Uses hole(rings_[o].rbegin(), rings_[o].rend());
      for (EdgeUse& use : hole) use.reversed = !use.reversed;
      result.push_back(std::move(hole));
    }
    return result;
  }

  /// Outlines with nothing between them.
  Quadrangulation pieces_alone() const {
    Quadrangulation result;
    result.vertices = profile_.vertices;
    for (std::size_t e = 0; e < profile_.edges.size(); ++e)
      result.edges.push_back({profile_.edges[e].start, profile_.edges[e].end, static_cast<int>(e)});
    return result;
  }

  /// Behind the corners and sides.
  void add(const Quadrangulation& inside) {
    drawn_.quads.vertices.insert(drawn_.quads.vertices.end(), inside.vertices.begin(), inside.vertices.end());
    for (QuadEdge edge : inside.edges) {
      edge.start += 4;
      edge.end += 4;
      if (edge.profile_edge >= 0) edge.profile_edge += 4;
      drawn_.quads.edges.push_back(edge);
    }
    for (Quad quad : inside.quads) {
      for (EdgeUse& side : quad.sides) side.edge = EdgeId(side.edge.value + 4);
      drawn_.quads.quads.push_back(quad);
    }
  }

  /// As it is given.
  void add(const PlanQuad& given) {
    Quad quad;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      quad.sides[i] = given_edge(given[i]);
      middle += at(given[i], 0.5) / 2 - at(given[i], 0) / 4;
    }
    for (std::size_t o = 0; o < outlines_.size(); ++o)
      if (outlines_[o].contains(middle) &&
          (quad.region < 0 ||
           outlines_[static_cast<std::size_t>(quad.region)].contains(outlines_[o].curves.front().point(0.3))))
        quad.region = static_cast<int>(o);
    if (quad.region < 0)
      throw Error(ErrorCode::unsupported, "what stands on a branch is wider than its outline");
    drawn_.quads.quads.push_back(quad);
  }

  static Eigen::Vector2d at(const geometry::NurbsCurve& curve, double t) {
    return curve.point(geometry::Parameter<1>(t)).head<2>();
  }

  bool is_same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    return (a - b).norm() < 1e-6 * (drawn_.curves[0].from - drawn_.curves[2].from).norm();
  }

  int given_vertex(const Eigen::Vector2d& place) {
    std::vector<Eigen::Vector2d>& vertices = drawn_.quads.vertices;
    for (std::size_t v = 4; v < vertices.size(); ++v)
      if (is_same(vertices[v], place)) return static_cast<int>(v);
    vertices.push_back(place);
    return static_cast<int>(vertices.size()) - 1;
  }

  /// A piece of an outline, a chord, or another arc.
  EdgeUse given_edge(const geometry::NurbsCurve& curve) {
    const int from = given_vertex(at(curve, 0)), to = given_vertex(at(curve, 1));
    const Eigen::Vector2d middle = at(curve, 0.5);
    for (std::size_t e = 4; e < drawn_.quads.edges.size(); ++e) {
      const QuadEdge& known = drawn_.quads.edges[e];
      if (std::minmax(known.start, known.end) == std::minmax(from, to) &&
          is_same(drawn_.curve(static_cast<int>(e)).point(geometry::Parameter<1>(0.5)).head<2>(), middle))
        return {EdgeId(static_cast<int>(e)), known.start != from};
    }
    QuadEdge edge{from, to};
    if (const auto piece = piece_of_outline(curve))
      edge = *piece;
    else if (curve.size() > 2)
      add_curve(curve, edge);
    drawn_.quads.edges.push_back(edge);
    return {EdgeId(static_cast<int>(drawn_.quads.edges.size()) - 1), edge.start != from};
  }

  /// Run as the outline is.
  std::optional<QuadEdge> piece_of_outline(const geometry::NurbsCurve& curve) {
    const Eigen::Vector2d middle = at(curve, 0.5);
    for (std::size_t c = 4; c < drawn_.curves.size(); ++c) {
      if (drawn_.outline_of[c] < 0) continue;
      const auto from = share_on(drawn_.curves[c], at(curve, 0)), half = share_on(drawn_.curves[c], middle),
                 to = share_on(drawn_.curves[c], at(curve, 1));
      if (!from || !half || !to) continue;
      double low = *from, high = *to;
      if (drawn_.curves[c].is_circle()) {
        low = *half + std::remainder(low - *half, 1);
        high = *half + std::remainder(high - *half, 1);
      }
      const bool along = low < high;
      if (!along) std::swap(low, high);
      const double turns = std::floor(low);
      return QuadEdge{given_vertex(at(curve, along ? 0 : 1)), given_vertex(at(curve, along ? 1 : 0)),
                      static_cast<int>(c), low - turns, high - turns};
    }
    return std::nullopt;
  }

  /// Where a point is on a curve, if it is.
  std::optional<double> share_on(const PlanCurve& curve, const Eigen::Vector2d& point) const {
    double share = 0;
    if (curve.spline)
      throw Error(ErrorCode::unsupported, "what stands on a branch has an outline other than lines and arcs");
    if (curve.is_straight()) {
      share = (point - curve.from).dot(curve.to - curve.from) / (curve.to - curve.from).squaredNorm();
    } else {
      const Eigen::Vector2d a = curve.point(0.5) - curve.centre, b = point - curve.centre;
      share = 0.5 + std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / curve.sweep;
    }
    if (std::abs(share) < 1e-7) share = 0;
    if (std::abs(share - 1) < 1e-7) share = 1;
    return share >= 0 && share <= 1 && is_same(curve.point(share), point) ? std::optional(share)
                                                                          : std::nullopt;
  }

  void add_curve(const geometry::NurbsCurve& curve, QuadEdge& edge) {
    const Eigen::Vector2d a = at(curve, 0), m = at(curve, 0.5), b = at(curve, 1), u = m - a, v = b - a;
    if (curve.size() != 3)
      throw Error(ErrorCode::unsupported, "what stands on a branch has curves other than arcs");
    if (!curve.is_rational()) {
      edge.apex = curve.control_points().col(1).head<2>();
      return;
    }
    const double twice_area = 2 * (u.x() * v.y() - u.y() * v.x());
    const Eigen::Vector2d centre = a + Eigen::Vector2d(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                                       u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                           twice_area;
    const Eigen::Vector2d from = a - centre, to = b - centre;
    edge.profile_edge = static_cast<int>(drawn_.curves.size());
    drawn_.curves.push_back({a, b, centre, std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to))});
    drawn_.outline_of.push_back(-1);
  }

  /// Edges on the outermost outline, counterclockwise.
  std::vector<int> outer_ring() const {
    const auto outer = std::find(parent_.begin(), parent_.end(), -1) - parent_.begin();
    std::vector<int> result;
    for (std::size_t e = 4; e < drawn_.quads.edges.size(); ++e)
      if (const int curve = drawn_.quads.edges[e].profile_edge;
          curve >= 4 && drawn_.outline_of[static_cast<std::size_t>(curve)] == outer)
        result.push_back(static_cast<int>(e));
    std::sort(result.begin(), result.end(), [&](int a, int b) {
      const QuadEdge &one = drawn_.quads.edges[static_cast<std::size_t>(a)],
                     &other = drawn_.quads.edges[static_cast<std::size_t>(b)];
      return std::pair(one.profile_edge, one.low) < std::pair(other.profile_edge, other.low);
    });
    return result;
  }

  const std::vector<Outline>& outlines_;
  std::vector<int> parent_;
  Profile profile_;
  PlanDrawing drawn_;
  std::vector<Uses> rings_;
};

}  // namespace

geometry::NurbsCurve PlanDrawing::curve(int edge) const {
  const QuadEdge& drawn = quads.edges[static_cast<std::size_t>(edge)];
  if (drawn.profile_edge >= 0)
    return curves[static_cast<std::size_t>(drawn.profile_edge)].piece(drawn.low, drawn.high);
  const Eigen::Vector3d from = on_ground(quads.vertices[static_cast<std::size_t>(drawn.start)]),
                        to = on_ground(quads.vertices[static_cast<std::size_t>(drawn.end)]);
  if (!drawn.apex) return geometry::segment(from, to);
  Eigen::Matrix3Xd points(3, 3);
  points << from, on_ground(*drawn.apex), to;
  return geometry::NurbsCurve({geometry::KnotVector(2, {0, 0, 0, 1, 1, 1})}, points);
}

std::vector<int> nesting(const std::vector<Outline>& outlines) {
  const auto contains = [&](int outer, std::size_t inner) {
    return outlines[static_cast<std::size_t>(outer)].contains(outlines[inner].curves.front().point(0.3));
  };
  std::vector<int> result(outlines.size(), -1);
  for (std::size_t of = 0; of < outlines.size(); ++of)
    for (int o = 0; o < static_cast<int>(outlines.size()); ++o)
      if (o != static_cast<int>(of) && contains(o, of) &&
          (result[of] < 0 || contains(result[of], static_cast<std::size_t>(o))))
        result[of] = o;
  return result;
}

PlanDrawing plan_drawing(const std::array<Eigen::Vector2d, 4>& corners, const std::vector<Outline>& outlines,
                         const std::vector<bool>& wanted, const std::vector<PlanQuad>& inside) {
  return Drafter(corners, outlines, inside.empty()).make(wanted, inside);
}

}  // namespace isopatch::segmentation

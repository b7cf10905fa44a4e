#include "segmentation/profiles/symmetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/quadrangulate.hpp"

namespace isopatch::segmentation {
namespace {

using Eigen::Vector2d;
using geometry::EdgeUse;
using planar::Curve;

/// Of the size of a drawing: what curves through points agree to, and how exactly lines must do.
constexpr double near_enough = 1e-5, near_enough_for_lines = 5e-7;

double extent_of(const Profile& profile) {
  Vector2d low = Vector2d::Constant(1e300), high = -low;
  for (const ProfileEdge& edge : profile.edges)
    for (const Vector2d& point : edge.points) low = low.cwiseMin(point), high = high.cwiseMax(point);
  return (high - low).norm();
}

Vector2d across(const MirrorLine& line) {
  return {-line.along.y(), line.along.x()};
}
/// Positive to the left.
double height_over(const MirrorLine& line, const Vector2d& p) {
  return (p - line.point).dot(across(line));
}
Vector2d image_of(const MirrorLine& line, const Vector2d& p) {
  return p - 2 * height_over(line, p) * across(line);
}

struct OnCurve {
  int edge;
  double at;
};

/// The edge of a profile nearest to a point.
class EdgeFinder {
 public:
  EdgeFinder(const Profile& profile, const std::vector<Curve>& curves, double tolerance)
      : profile_(profile), curves_(curves), tolerance_(tolerance) {
    for (const ProfileEdge& edge : profile.edges) {
      Vector2d low = edge.points.front(), high = low;
      for (const Vector2d& point : edge.points) low = low.cwiseMin(point), high = high.cwiseMax(point);
      const Vector2d margin = Vector2d::Constant(0.1 * (high - low).norm() + tolerance);
      boxes_.emplace_back(low - margin, high + margin);
    }
  }

  std::optional<OnCurve> at(const Vector2d& point) const {
    std::optional<OnCurve> best;
    double least = tolerance_;
    for (std::size_t e = 0; e < curves_.size(); ++e) {
      if ((point.array() < boxes_[e].first.array()).any() || (point.array() > boxes_[e].second.array()).any())
        continue;
      const double t = on(static_cast<int>(e), point), off = (curves_[e].at(t) - point).norm();
      const bool is_on = off < (curves_[e].straight() ? near_enough_for_lines / near_enough : 1) * tolerance_;
      if (is_on && off < least) best = OnCurve{static_cast<int>(e), t}, least = off;
    }
    return best;
  }

  double on(int edge, const Vector2d& point) const {
    const auto e = static_cast<std::size_t>(edge);
    const std::vector<Vector2d>& points = profile_.edges[e].points;
    if (points.size() > 2) return curves_[e].nearest(point, 0, 1);
    const Vector2d along = points[1] - points[0];
    return std::clamp((point - points[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  }

 private:
  const Profile& profile_;
  const std::vector<Curve>& curves_;
  double tolerance_;
  std::vector<std::pair<Vector2d, Vector2d>> boxes_;
};

// Finding lines.

std::vector<Vector2d> directions(const Profile& profile) {
  std::vector<Vector2d> result;
  const auto add = [&](const Vector2d& way) {
    constexpr std::size_t most = 20;
    if (way.norm() < 1e-12 || result.size() == most) return;
    const Vector2d unit = way.normalized();
    if (std::none_of(result.begin(), result.end(), [&](const Vector2d& known) {
          return std::abs(known.x() * unit.y() - known.y() * unit.x()) < 1e-6;
        }))
      result.push_back(unit);
  };
  const auto add_both = [&](const Vector2d& way) {
    add(way);
    add({-way.y(), way.x()});
  };
  add_both({1, 0});
  for (const ProfileEdge& edge : profile.edges)
    if (edge.points.size() == 2) add_both(edge.points[1] - edge.points[0]);
  std::vector<Vector2d> centres;
  for (const ProfileEdge& edge : profile.edges) {
    if (edge.start >= 0) continue;
    Vector2d sum = Vector2d::Zero();
    for (std::size_t i = 1; i < edge.points.size(); ++i) sum += edge.points[i];
    centres.push_back(sum / static_cast<double>(edge.points.size() - 1));
  }
  for (std::size_t i = 0; i < centres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) add_both(centres[i] - centres[j]);
  return result;
}

/// Half way between the outermost points across a direction: a symmetric drawing has its line there.
MirrorLine line_along(const Profile& profile, const std::vector<Curve>& curves, const Vector2d& along,
                      double size) {
  MirrorLine line{Vector2d::Zero(), along};
  double low = 1e300, high = -1e300;
  for (std::size_t e = 0; e < curves.size(); ++e) {
    const int pieces = static_cast<int>(profile.edges[e].points.size()) - 1;
    for (int i = 0; i < pieces; ++i) {
      const double from = static_cast<double>(i) / pieces, step = 1.0 / pieces;
      const double h0 = height_over(line, curves[e].at(from)),
                   h2 = height_over(line, curves[e].at(from + step)),
                   h1 = height_over(line, curves[e].at(from + step / 2));
      const double bend = h0 + h2 - 2 * h1, slope = h2 - h0;
      double peak = h1;  // of the parabola through the three
      if (std::abs(bend) > 1e-12 * size && std::abs(slope) < 2 * std::abs(bend))
        peak = h1 - slope * slope / (8 * bend);
      low = std::min({low, h0, h2, peak}), high = std::max({high, h0, h2, peak});
    }
  }
  line.point = (low + high) / 2 * across(line);
  return line;
}

bool is_symmetric(const Profile& profile, const std::vector<Curve>& curves, const EdgeFinder& find,
                  const MirrorLine& line) {
  for (const Curve& curve : curves)
    for (const double t : {0.0, 0.23, 0.5, 0.81})
      if (!find.at(image_of(line, curve.at(t)))) return false;
  return std::all_of(profile.vertices.begin(), profile.vertices.end(),
                     [&](const Vector2d& vertex) { return find.at(image_of(line, vertex)).has_value(); });
}

// Mirroring.

class Mirrorer {
 public:
  Mirrorer(const Profile& profile, const MirrorLine& line, const Quadrangulation& half)
      : profile_(profile),
        line_(line),
        tolerance_(near_enough * extent_of(profile)),
        curves_(planar::curves_of(profile)),
        find_(profile, curves_, tolerance_),
        made_(half),
        half_(half) {}

  Quadrangulation make() {
    for (const Quad& quad : half_.quads) {
      Quad image{image_of_region(quad.region), {}};
      for (std::size_t k = 0; k < 4; ++k) {
        const EdgeUse& side = quad.sides[3 - k];
        const EdgeUse other = image_of_edge(side.edge.value);
        image.sides[k] = {other.edge, other.reversed == side.reversed};
      }
      made_.quads.push_back(image);
    }
    return std::move(made_);
  }

 private:
  [[noreturn]] static void fail(const Vector2d& at) {
    throw Error(ErrorCode::unsupported,
                fmt::format("the drawing has no image of what is at ({:.6g}, {:.6g})", at.x(), at.y()));
  }

  bool is_on_line(const Vector2d& p) const { return std::abs(height_over(line_, p)) < tolerance_; }

  int image_of_vertex(int vertex) {
    const auto [known, fresh] = vertices_.try_emplace(vertex, vertex);
    if (!fresh) return known->second;
    const Vector2d at = half_.vertices[static_cast<std::size_t>(vertex)];
    if (is_on_line(at)) return vertex;
    const Vector2d there = image_of(line_, at);
    const auto off = [&](const Vector2d& p) { return (p - there).norm(); };
    const auto nearest =
        std::min_element(profile_.vertices.begin(), profile_.vertices.end(),
                         [&](const Vector2d& a, const Vector2d& b) { return off(a) < off(b); });
    if (nearest != profile_.vertices.end() && off(*nearest) < tolerance_)
      return known->second = static_cast<int>(nearest - profile_.vertices.begin());
    made_.vertices.push_back(there);
    return known->second = static_cast<int>(made_.vertices.size()) - 1;
  }

  /// Used as the image runs.
  EdgeUse image_of_edge(int number) {
    if (const auto known = edges_.find(number); known != edges_.end()) return known->second;
    const QuadEdge& edge = half_.edges[static_cast<std::size_t>(number)];
    QuadEdge image = edge;
    image.start = image_of_vertex(edge.start);
    image.end = image_of_vertex(edge.end);
    if (edge.apex) image.apex = image_of(line_, *edge.apex);
    bool turned = false;
    if (edge.profile_edge >= 0) turned = move_to_image(edge, image);
    const bool is_same = image.start == edge.start && image.end == edge.end &&
                         image.profile_edge == edge.profile_edge && std::abs(image.low - edge.low) < 1e-6 &&
                         (!edge.apex || is_on_line(*edge.apex));
    if (is_same && !turned) return edges_[number] = {EdgeId(number), false};
    made_.edges.push_back(image);
    return edges_[number] = {EdgeId(static_cast<int>(made_.edges.size()) - 1), turned};
  }

  /// @return  whether it runs against the image of the edge
  bool move_to_image(const QuadEdge& edge, QuadEdge& image) {
    const Curve& curve = curves_[static_cast<std::size_t>(edge.profile_edge)];
    const auto there = [&](double t) { return image_of(line_, curve.at(t)); };
    const Vector2d middle = there((edge.low + edge.high) / 2);
    const std::optional<OnCurve> found = find_.at(middle);
    if (!found) fail(middle);
    const Curve& other = curves_[static_cast<std::size_t>(found->edge)];
    double low = find_.on(found->edge, there(edge.low)), high = find_.on(found->edge, there(edge.high));
    if (other.closed()) {
      low += std::round(found->at - low);
      high += std::round(found->at - high);
    } else {
      const auto snapped = [](double t) { return t < 1e-6 ? 0 : t > 1 - 1e-6 ? 1 : t; };
      low = snapped(low), high = snapped(high);
    }
    image.profile_edge = found->edge;
    const bool turned = low > high;
    if (turned) {
      std::swap(low, high);
      std::swap(image.start, image.end);
    }
    if (other.closed() && low < 0) low += 1, high += 1;
    image.low = low, image.high = high;
    return turned;
  }

  /// The one on the other side of the image of one of its edges.
  int image_of_region(int region) {
    if (const auto known = regions_.find(region); known != regions_.end()) return known->second;
    const EdgeUse& side = profile_.regions[static_cast<std::size_t>(region)].loops.front().front();
    const Curve& curve = curves_[static_cast<std::size_t>(side.edge.value)];
    const Vector2d middle = image_of(line_, curve.at(0.5));
    const std::optional<OnCurve> found = find_.at(middle);
    if (!found) fail(middle);
    const Vector2d way = curve.derivative(0.5);
    const Vector2d turned_way = way - 2 * way.dot(across(line_)) * across(line_);
    const bool against =
        turned_way.dot(curves_[static_cast<std::size_t>(found->edge)].derivative(found->at)) < 0;
    const bool reversed = side.reversed == against;
    for (std::size_t r = 0; r < profile_.regions.size(); ++r)
      for (const auto& loop : profile_.regions[r].loops)
        for (const EdgeUse& use : loop)
          if (use.edge.value == found->edge && use.reversed == reversed)
            return regions_[region] = static_cast<int>(r);
    fail(middle);
  }

  const Profile& profile_;
  MirrorLine line_;
  double tolerance_;
  std::vector<Curve> curves_;
  EdgeFinder find_;
  Quadrangulation made_;
  const Quadrangulation& half_;
  std::map<int, int> vertices_, regions_;
  std::map<int, EdgeUse> edges_;
};

/// To the left of all lines, by its outer loop's middle.
bool is_left(const Profile& profile, const ProfileRegion& region, const std::vector<MirrorLine>& lines,
             double tolerance) {
  for (const MirrorLine& line : lines) {
    double low = 0, high = 0;
    for (const EdgeUse& use : region.loops.front())
      for (const Vector2d& point : profile.edges[static_cast<std::size_t>(use.edge.value)].points) {
        low = std::min(low, height_over(line, point));
        high = std::max(high, height_over(line, point));
      }
    if (low < -tolerance && high > tolerance)
      throw Error(ErrorCode::unsupported, "the drawing is not divided along its line of symmetry");
    if (low < -tolerance) return false;
  }
  return true;
}

}  // namespace

std::vector<MirrorLine> mirror_lines(const Profile& profile) {
  validate(profile);
  constexpr std::size_t most = 8;
  const double size = extent_of(profile);
  const std::vector<Curve> curves = planar::curves_of(profile);
  const EdgeFinder find(profile, curves, near_enough * size);
  std::vector<MirrorLine> result;
  for (const Vector2d& along : directions(profile)) {
    const MirrorLine line = line_along(profile, curves, along, size);
    if (result.size() < most && is_symmetric(profile, curves, find, line)) result.push_back(line);
  }
  return result;
}

Quadrangulation mirrored_quadrangulation(const Profile& profile, const std::vector<MirrorLine>& lines,
                                         const QuadrangulationOptions& options) {
  Profile part = profile;
  for (ProfileRegion& region : part.regions)
    region.wanted = region.wanted && is_left(profile, region, lines, near_enough * extent_of(profile));
  Quadrangulation result = quadrangulate(part, options);
  for (const MirrorLine& line : lines) result = Mirrorer(profile, line, result).make();
  return result;
}

}  // namespace isopatch::segmentation

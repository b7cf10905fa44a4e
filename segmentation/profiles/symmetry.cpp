#include "segmentation/profiles/symmetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
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

/// x -> turn x + shift: keeps lengths, and the sense of turning where det(turn) is 1.
struct Motion {
  Eigen::Matrix2d turn;
  Vector2d shift;

  Vector2d operator()(const Vector2d& p) const { return turn * p + shift; }
  bool mirrors() const { return turn.determinant() < 0; }
};

/// What mirroring about lines, again and again, makes of what lies where it is, that first.
/// @throws Error unsupported  lines that do not meet at a whole part of 180 degrees
std::vector<Motion> motions_of(const std::vector<MirrorLine>& lines) {
  constexpr std::size_t most = 32;
  std::vector<Motion> result = {{Eigen::Matrix2d::Identity(), Vector2d::Zero()}};
  const auto near = [&](const Motion& a, const Motion& b) {
    return (a.turn - b.turn).norm() < 1e-6;  // all of them keep the place where the lines meet
  };
  for (std::size_t done = 0; done < result.size(); ++done)
    for (const MirrorLine& line : lines) {
      const Vector2d n = across(line);
      const Eigen::Matrix2d mirror = Eigen::Matrix2d::Identity() - 2 * n * n.transpose();
      const Motion next{mirror * result[done].turn, image_of(line, result[done].shift)};
      if (std::any_of(result.begin(), result.end(), [&](const Motion& known) { return near(known, next); }))
        continue;
      if (result.size() == most)
        throw Error(ErrorCode::unsupported,
                    "lines of symmetry that do not meet at a whole part of 180 degrees");
      result.push_back(next);
    }
  return result;
}

/// All images of a part's quadrilaterals, in one; what is in one place is stored once.
class Mirrorer {
 public:
  Mirrorer(const Profile& profile, const Quadrangulation& part)
      : profile_(profile),
        tolerance_(near_enough * extent_of(profile)),
        curves_(planar::curves_of(profile)),
        find_(profile, curves_, tolerance_),
        part_(part) {
    made_.vertices = profile.vertices;
  }

  Quadrangulation make(const std::vector<Motion>& motions) {
    for (const Motion& motion : motions) add(motion);
    return std::move(made_);
  }

 private:
  [[noreturn]] static void fail(const Vector2d& at) {
    throw Error(ErrorCode::unsupported,
                fmt::format("the drawing has no image of what is at ({:.6g}, {:.6g})", at.x(), at.y()));
  }

  void add(const Motion& motion) {
    std::map<int, int> vertices, regions;
    std::map<int, EdgeUse> edges;
    const auto known = [](auto& places, int number, const auto& find) {
      const auto at = places.find(number);
      return at != places.end() ? at->second : places[number] = find();
    };
    const auto vertex = [&](int number) {
      return known(vertices, number,
                   [&] { return vertex_at(motion(part_.vertices[static_cast<std::size_t>(number)])); });
    };
    for (const Quad& quad : part_.quads) {
      Quad image{known(regions, quad.region, [&] { return image_of_region(motion, quad.region); }), {}};
      for (std::size_t k = 0; k < 4; ++k) {
        const EdgeUse& side = quad.sides[motion.mirrors() ? 3 - k : k];
        const EdgeUse other = known(edges, side.edge.value, [&] {
          const QuadEdge& edge = part_.edges[static_cast<std::size_t>(side.edge.value)];
          return image_of_edge(motion, edge, vertex(edge.start), vertex(edge.end));
        });
        image.sides[k] = {other.edge, other.reversed != (side.reversed != motion.mirrors())};
      }
      made_.quads.push_back(image);
    }
  }

  int vertex_at(const Vector2d& place) {
    for (std::size_t v = 0; v < made_.vertices.size(); ++v)
      if ((made_.vertices[v] - place).norm() < tolerance_) return static_cast<int>(v);
    made_.vertices.push_back(place);
    return static_cast<int>(made_.vertices.size()) - 1;
  }

  /// Used as the image runs.
  EdgeUse image_of_edge(const Motion& motion, const QuadEdge& edge, int start, int end) {
    QuadEdge image = edge;
    image.start = start;
    image.end = end;
    if (edge.apex) image.apex = motion(*edge.apex);
    bool turned = false;
    if (edge.profile_edge >= 0)
      turned = move_to_image(motion, edge, image);
    else if (start > end)
      std::swap(image.start, image.end), turned = true;
    for (std::size_t e = 0; e < made_.edges.size(); ++e)
      if (is_same(made_.edges[e], image)) return {EdgeId(static_cast<int>(e)), turned};
    made_.edges.push_back(image);
    return {EdgeId(static_cast<int>(made_.edges.size()) - 1), turned};
  }

  bool is_same(const QuadEdge& a, const QuadEdge& b) const {
    return a.start == b.start && a.end == b.end && a.profile_edge == b.profile_edge &&
           std::abs(a.low - b.low) < 1e-6 && a.apex.has_value() == b.apex.has_value() &&
           (!a.apex || (*a.apex - *b.apex).norm() < tolerance_);
  }

  /// @return  whether it runs against the image of the edge
  bool move_to_image(const Motion& motion, const QuadEdge& edge, QuadEdge& image) {
    const Curve& curve = curves_[static_cast<std::size_t>(edge.profile_edge)];
    const auto there = [&](double t) { return motion(curve.at(t)); };
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
  int image_of_region(const Motion& motion, int region) {
    const EdgeUse& side = profile_.regions[static_cast<std::size_t>(region)].loops.front().front();
    const Curve& curve = curves_[static_cast<std::size_t>(side.edge.value)];
    const Vector2d middle = motion(curve.at(0.5));
    const std::optional<OnCurve> found = find_.at(middle);
    if (!found) fail(middle);
    const Vector2d turned_way = motion.turn * curve.derivative(0.5);
    const bool against =
        turned_way.dot(curves_[static_cast<std::size_t>(found->edge)].derivative(found->at)) < 0;
    const bool reversed = (side.reversed != against) != motion.mirrors();
    for (std::size_t r = 0; r < profile_.regions.size(); ++r)
      for (const auto& loop : profile_.regions[r].loops)
        for (const EdgeUse& use : loop)
          if (use.edge.value == found->edge && use.reversed == reversed) return static_cast<int>(r);
    fail(middle);
  }

  const Profile& profile_;
  double tolerance_;
  std::vector<Curve> curves_;
  EdgeFinder find_;
  Quadrangulation made_;
  const Quadrangulation& part_;
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

/// Two lines next to each other of three or more at equal angles, turned so that the part between them is to
/// their left; none of others.
std::vector<MirrorLine> wedge_of(std::vector<MirrorLine> lines) {
  if (lines.size() < 3) return {};
  const auto angle = [](const MirrorLine& line) {
    const double result = std::atan2(line.along.y(), line.along.x());
    return result < -1e-9 ? result + std::numbers::pi : result > std::numbers::pi - 1e-9 ? 0 : result;
  };
  std::sort(lines.begin(), lines.end(),
            [&](const MirrorLine& a, const MirrorLine& b) { return angle(a) < angle(b); });
  const double step = std::numbers::pi / static_cast<double>(lines.size());
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    if (std::abs(angle(lines[i + 1]) - angle(lines[i]) - step) > 1e-6) return {};
  MirrorLine first = lines[0], second = lines[1];
  if (across(first).dot(second.along) < 0) second.along = -second.along;
  second.along = -second.along;
  return {first, second};
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

bool is_symmetric(const Profile& profile, const MirrorLine& line) {
  const std::vector<Curve> curves = planar::curves_of(profile);
  return is_symmetric(profile, curves, EdgeFinder(profile, curves, near_enough * extent_of(profile)), line);
}

std::vector<std::vector<MirrorLine>> ways_to_mirror(const std::vector<MirrorLine>& lines) {
  constexpr std::size_t most = 2;
  std::vector<std::vector<MirrorLine>> result;
  if (std::vector<MirrorLine> wedge = wedge_of(lines); !wedge.empty()) result.push_back(std::move(wedge));
  for (std::size_t j = 1; j < lines.size(); ++j)
    if (std::abs(lines[0].along.dot(lines[j].along)) < 1e-6) {
      result.push_back({lines[0], lines[j]});
      break;
    }
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) result.push_back({lines[i]});
  return result;
}

std::vector<MirrorLine> all_images(const std::vector<MirrorLine>& lines) {
  std::vector<MirrorLine> result;
  for (const Motion& motion : motions_of(lines))
    for (const MirrorLine& line : lines) {
      const MirrorLine image{motion(line.point), motion.turn * line.along};
      if (std::none_of(result.begin(), result.end(), [&](const MirrorLine& known) {
            return std::abs(across(known).dot(image.along)) < 1e-6;
          }))
        result.push_back(image);
    }
  return result;
}

Quadrangulation without_lines(const Profile& profile, const std::vector<MirrorLine>& lines,
                              Quadrangulation quads) {
  const double tolerance = near_enough * extent_of(profile);
  const std::vector<MirrorLine> all = all_images(lines);
  for (QuadEdge& edge : quads.edges) {
    if (edge.profile_edge < 0) continue;
    const ProfileEdge& drawn = profile.edges[static_cast<std::size_t>(edge.profile_edge)];
    const bool on_line = std::any_of(all.begin(), all.end(), [&](const MirrorLine& line) {
      return std::all_of(drawn.points.begin(), drawn.points.end(), [&](const Vector2d& point) {
        return std::abs(height_over(line, point)) < tolerance;
      });
    });
    if (on_line) edge = {edge.start, edge.end};
  }
  return quads;
}

Profile part_to_mirror(Profile profile, const std::vector<MirrorLine>& lines) {
  const double tolerance = near_enough * extent_of(profile);
  for (std::size_t r = 0; r < profile.regions.size(); ++r)
    if (profile.regions[r].wanted)
      profile.regions[r].wanted = is_left(profile, profile.regions[r], lines, tolerance);
  return profile;
}

Quadrangulation mirrored(const Profile& profile, const std::vector<MirrorLine>& lines, Quadrangulation part) {
  if (lines.empty()) return part;
  return Mirrorer(profile, part).make(motions_of(lines));
}

Quadrangulation mirrored_quadrangulation(const Profile& profile, const std::vector<MirrorLine>& lines,
                                         const QuadrangulationOptions& options) {
  return mirrored(profile, lines, quadrangulate(part_to_mirror(profile, lines), options));
}

}  // namespace isopatch::segmentation

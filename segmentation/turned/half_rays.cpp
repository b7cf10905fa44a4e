#include "segmentation/turned/internal/half_rays.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::EdgeUse;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

class RayDrawer {
 public:
  RayDrawer(const Brep& solid, const TurnedFrame& frame, CoredProfile& half)
      : solid_(solid), frame_(frame), half_(half), tolerance_(1e-7 * solid.size()) {}

  void draw(const TurnedRequest::Ray& ray) {
    const Eigen::Vector2d from = frame_.flat(ray.from);
    const Eigen::Vector3d out = frame_.point({1, 0}, frame_.angle(ray.from)) - frame_.origin;
    const Eigen::Vector2d along =
        Eigen::Vector2d(ray.along.dot(out), ray.along.dot(frame_.along)).normalized();
    HalfCurve line;
    line.start = vertex(first_hit(from, along, true));
    line.end = vertex(first_hit(from, along, false));
    if (!is_drawn(line)) curves().push_back(std::move(line));
  }

 private:
  struct Hit {
    std::size_t curve;
    double share, way;
  };

  std::vector<HalfCurve>& curves() { return half_.outside.curves; }

  Eigen::Vector2d at(std::size_t curve, double share) {
    return point(solid_, frame_, half_.outside, curves()[curve], share);
  }

  /// Whether it runs along a straight curve.
  bool is_drawn(const HalfCurve& line) const {
    return std::any_of(half_.outside.curves.begin(), half_.outside.curves.end(), [&](const HalfCurve& known) {
      return is_straight(solid_, known) &&
             std::minmax(known.start, known.end) == std::minmax(line.start, line.end);
    });
  }

  /// Where a ray begins, or what it meets next.
  Hit first_hit(const Eigen::Vector2d& from, const Eigen::Vector2d& along, bool at_its_start) {
    std::optional<Hit> best;
    for (std::size_t c = 0; c < curves().size(); ++c)
      for (const Hit& hit : hits(c, from, along))
        if ((at_its_start ? std::abs(hit.way) < tolerance_ : hit.way > tolerance_) &&
            (!best || hit.way < best->way))
          best = hit;
    if (!best)
      throw Error(ErrorCode::unsupported, fmt::format("no curve of its half profile is {} ({:.6g}, {:.6g}) m",
                                                      at_its_start ? "at" : "beyond", from.x(), from.y()));
    return *best;
  }

  /// Where a line meets a curve; the ends of both count.
  std::vector<Hit> hits(std::size_t curve, const Eigen::Vector2d& from, const Eigen::Vector2d& along) {
    const int pieces = is_straight(solid_, curves()[curve]) ? 1 : 48;
    const auto beside = [&](double share) { return cross(along, at(curve, share) - from); };
    std::vector<Hit> result;
    const auto add = [&](double share) {
      result.push_back({curve, share, along.dot(at(curve, share) - from)});
    };
    double before = beside(0);
    if (std::abs(before) < tolerance_) add(0);
    for (int i = 0; i < pieces; ++i) {
      double low = i / static_cast<double>(pieces), high = (i + 1) / static_cast<double>(pieces);
      const double after = beside(high);
      if (std::abs(after) < tolerance_)
        add(high);
      else if (std::abs(before) >= tolerance_ && (before > 0) != (after > 0)) {
        for (int step = 0; step < 60; ++step) {
          const double middle = (low + high) / 2;
          ((beside(middle) > 0) == (before > 0) ? low : high) = middle;
        }
        add((low + high) / 2);
      }
      before = after;
    }
    return result;
  }

  /// Divides the curve unless it ends there.
  int vertex(const Hit& hit) {
    const Eigen::Vector2d place = at(hit.curve, hit.share);
    for (std::size_t v = 0; v < half_.outside.vertices.size(); ++v)
      if ((half_.outside.vertices[v] - place).norm() < tolerance_) return static_cast<int>(v);
    const int made = static_cast<int>(half_.outside.vertices.size());
    half_.outside.vertices.push_back(place);
    HalfCurve rest = curves()[hit.curve];
    HalfCurve& first = curves()[hit.curve];
    if (first.start < 0)
      throw Error(ErrorCode::unsupported, "a curve of its half profile that is closed would be divided");
    first.high = rest.low = first.low + hit.share * (first.high - first.low);
    first.end = rest.start = made;
    const int number = static_cast<int>(curves().size());
    curves().push_back(std::move(rest));
    for (CoreStrip& strip : half_.strips) {
      const auto place_of = std::find(strip.line.begin(), strip.line.end(), static_cast<int>(hit.curve));
      if (place_of != strip.line.end()) strip.line.insert(place_of + 1, number);
    }
    return made;
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  CoredProfile& half_;
  double tolerance_;
};

/// Regions by turning left at every vertex.
class RegionWalk {
 public:
  RegionWalk(const Brep& solid, const TurnedFrame& frame, const HalfProfile& half)
      : solid_(solid), frame_(frame), half_(half), leaving_(half.vertices.size()) {
    for (std::size_t c = 0; c < half.curves.size(); ++c)
      for (const bool reversed : {false, true}) {
        const EdgeUse use{EdgeId(static_cast<int>(c)), reversed};
        if (half.curves[c].start < 0)
          throw Error(ErrorCode::unsupported, "its half profile has a hole, beside which nothing is drawn");
        leaving_[static_cast<std::size_t>(from(use))].push_back(use);
      }
    for (std::vector<EdgeUse>& uses : leaving_)
      std::sort(uses.begin(), uses.end(), [&](EdgeUse a, EdgeUse b) { return angle(a) < angle(b); });
  }

  std::vector<ProfileRegion> regions() {
    std::vector<ProfileRegion> result;
    std::vector<EdgeUse> done;
    int outsides = 0;
    for (const std::vector<EdgeUse>& uses : leaving_)
      for (const EdgeUse& first : uses) {
        if (std::find(done.begin(), done.end(), first) != done.end()) continue;
        std::vector<EdgeUse> loop;
        EdgeUse use = first;
        do {
          loop.push_back(use);
          use = next(use);
        } while (use != first);
        done.insert(done.end(), loop.begin(), loop.end());
        if (twice_area(loop) > 0)
          result.push_back({{std::move(loop)}, true});
        else
          ++outsides;
      }
    if (outsides != 1)
      throw Error(ErrorCode::unsupported,
                  "its half profile is not in one piece, beside which nothing is drawn");
    return result;
  }

 private:
  const HalfCurve& curve(EdgeUse use) const { return half_.curves[static_cast<std::size_t>(use.edge.value)]; }
  int from(EdgeUse use) const { return use.reversed ? curve(use).end : curve(use).start; }
  int to(EdgeUse use) const { return use.reversed ? curve(use).start : curve(use).end; }
  Eigen::Vector2d at(EdgeUse use, double share) const {
    return point(solid_, frame_, half_, curve(use), use.reversed ? 1 - share : share);
  }

  double angle(EdgeUse use) const {
    const Eigen::Vector2d way = at(use, 1.0 / 64) - at(use, 0);
    return std::atan2(way.y(), way.x());
  }

  /// The one that leaves most to the left of where a use arrives: the next clockwise from its own way back.
  EdgeUse next(EdgeUse use) const {
    const std::vector<EdgeUse>& uses = leaving_[static_cast<std::size_t>(to(use))];
    const auto back = std::find(uses.begin(), uses.end(), EdgeUse{use.edge, !use.reversed});
    return back == uses.begin() ? uses.back() : *(back - 1);
  }

  double twice_area(const std::vector<EdgeUse>& loop) const {
    double sum = 0;
    for (const EdgeUse& use : loop)
      for (int i = 0; i < 16; ++i) sum += cross(at(use, i / 16.0), at(use, (i + 1) / 16.0));
    return sum;
  }

  const Brep& solid_;
  const TurnedFrame& frame_;
  const HalfProfile& half_;
  std::vector<std::vector<EdgeUse>> leaving_;  // by vertex, counterclockwise
};

}  // namespace

void draw_rays(const Brep& solid, const TurnedFrame& frame, const std::vector<TurnedRequest::Ray>& rays,
               CoredProfile& half) {
  RayDrawer drawer(solid, frame, half);
  for (const TurnedRequest::Ray& ray : rays) drawer.draw(ray);
}

std::vector<ProfileRegion> half_regions(const Brep& solid, const TurnedFrame& frame,
                                        const HalfProfile& half) {
  return RegionWalk(solid, frame, half).regions();
}

}  // namespace isopatch::segmentation

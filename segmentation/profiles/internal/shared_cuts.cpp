#include "segmentation/profiles/internal/shared_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

#include "segmentation/profiles/internal/candidates.hpp"

namespace isopatch::segmentation::planar {

using std::numbers::pi;

namespace {

/// The regions on both sides of each edge, -1 where there is none that is wanted.
std::vector<std::array<int, 2>> regions_beside(const Profile& profile) {
  std::vector<std::array<int, 2>> result(profile.edges.size(), {-1, -1});
  for (std::size_t r = 0; r < profile.regions.size(); ++r)
    for (const auto& loop : profile.regions[r].loops)
      for (const geometry::EdgeUse& use : loop)
        if (profile.regions[r].wanted) result[use.edge.value][use.reversed ? 1 : 0] = static_cast<int>(r);
  return result;
}

/// Edges that lead from an odd region to another one or to one that can be made even by itself.
std::vector<int> way_to_even(const std::vector<std::array<int, 2>>& beside,
                             const std::vector<double>& weights, int from, const std::vector<bool>& free,
                             const std::vector<int>& corners) {
  std::vector<int> reached_by(free.size(), -2);
  std::deque<int> open = {from};
  reached_by[from] = -1;
  while (!open.empty()) {
    const int region = open.front();
    open.pop_front();
    if (region != from && (free[region] || corners[region] % 2 != 0)) {
      std::vector<int> result;
      for (int r = region; r != from;) {
        const int edge = reached_by[r];
        result.push_back(edge);
        r = beside[edge][0] == r ? beside[edge][1] : beside[edge][0];
      }
      return result;
    }
    std::vector<int> edges;
    for (std::size_t e = 0; e < beside.size(); ++e)
      if (beside[e][0] >= 0 && beside[e][1] >= 0 && (beside[e][0] == region) != (beside[e][1] == region))
        edges.push_back(static_cast<int>(e));
    std::sort(edges.begin(), edges.end(), [&](int a, int b) { return weights[a] > weights[b]; });
    for (const int edge : edges) {
      const int other = beside[edge][0] == region ? beside[edge][1] : beside[edge][0];
      if (reached_by[other] != -2) continue;
      reached_by[other] = edge;
      open.push_back(other);
    }
  }
  return {};
}

/// How many further cuts each edge needs for the parity of regions.
std::vector<int> cuts_for_parity(const Profile& profile, const std::vector<Curve>& curves,
                                 const CutPlaces& places) {
  const auto beside = regions_beside(profile);
  std::vector<bool> free(profile.regions.size(), false);
  std::vector<int> corners(profile.regions.size(), 0);
  std::vector<double> weights;
  for (std::size_t e = 0; e < beside.size(); ++e) {
    weights.push_back(curves[e].length() * (curves[e].straight() ? 1 : 3));
    const bool shared = beside[e][0] >= 0 && beside[e][1] >= 0;
    for (const int region : beside[e])
      if (region >= 0) {
        corners[region] += static_cast<int>(places[e].size()) + (curves[e].closed() ? 0 : 1);
        if (!shared) free[region] = true;
      }
  }
  std::vector<int> result(profile.edges.size(), 0);
  for (std::size_t r = 0; r < corners.size(); ++r) {
    if (!profile.regions[r].wanted || free[r] || corners[r] % 2 == 0) continue;
    for (const int edge : way_to_even(beside, weights, static_cast<int>(r), free, corners)) {
      ++result[edge];
      for (const int region : beside[edge]) ++corners[region];
    }
  }
  return result;
}

/// How much of a curve lies before each of its parameters: its length, and so much more where it bends.
class Weight {
 public:
  /// @param share of the length, where a right angle counts 1
  Weight(const Curve& curve, double share) : so_far_{0} {
    for (int i = 0; i < samples; ++i) {
      const double low = static_cast<double>(i) / samples, high = static_cast<double>(i + 1) / samples;
      const Eigen::Vector2d a = curve.derivative(low), b = curve.derivative(high);
      const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
      so_far_.push_back(so_far_.back() + turn / (pi / 2) +
                        share * (curve.at(high) - curve.at(low)).norm() / curve.length());
    }
  }
  double all() const { return so_far_.back(); }
  double before(double parameter) const {  // goes on beyond 1
    const double turns = std::floor(parameter), at = (parameter - turns) * samples;
    const auto i = static_cast<std::size_t>(std::min(at, samples - 1.0));
    return turns * all() + so_far_[i] + (at - static_cast<double>(i)) * (so_far_[i + 1] - so_far_[i]);
  }
  double parameter_at(double weight) const {
    const double turns = std::floor(weight / all());
    weight -= turns * all();
    const auto above = std::upper_bound(so_far_.begin() + 1, so_far_.end() - 1, weight);
    const double low = *(above - 1), part = (weight - low) / (*above - low);
    return turns + (static_cast<double>(above - so_far_.begin()) - 1 + part) / samples;
  }

 private:
  static constexpr int samples = 256;
  std::vector<double> so_far_;
};

/// Halves the stretches that are longest, bends counted.
void cut_further(const Curve& curve, std::vector<double>& places, int number) {
  if (number <= 0) return;
  const Weight weight(curve, 1);
  for (; number > 0; --number) {
    std::vector<double> ends = places;
    if (!curve.closed()) ends.insert(ends.begin(), 0.0);
    ends.push_back(curve.closed() ? ends.front() + 1 : 1.0);
    const auto between = [&](std::size_t i) { return weight.before(ends[i + 1]) - weight.before(ends[i]); };
    std::size_t longest = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (between(i) > between(longest) + 1e-9) longest = i;
    const double middle =
        weight.parameter_at((weight.before(ends[longest]) + weight.before(ends[longest + 1])) / 2);
    places.push_back(middle - std::floor(middle));
    std::sort(places.begin(), places.end());
  }
}

/// Cuts a curve with ends into pieces that bend alike: at most so much, and less where most of its bending is
/// within a quarter of it, since such sides fold quadrilaterals.
void cut_where_it_bends(const Curve& curve, std::vector<double>& places, double most) {
  const Weight weight(curve, 0.1);
  for (double at = 0; at < 0.75; at += 1.0 / 32)
    if (weight.before(at + 0.25) - weight.before(at) > 0.35 * weight.all())
      most = std::min(most, 80 * pi / 180);
  const int pieces = static_cast<int>(std::ceil(curve.turning() / most));
  for (int i = 1; i < pieces; ++i) places.push_back(weight.parameter_at(weight.all() * i / pieces));
}

/// Gives regions of two corners four, by cuts of shared edges: what lies between an arc and its chord.
void give_four_corners(const Profile& profile, const std::vector<Curve>& curves,
                       const std::vector<bool>& shared, CutPlaces& places) {
  for (const ProfileRegion& region : profile.regions) {
    if (!region.wanted || region.loops.size() > 1) continue;
    std::vector<int> edges;
    std::size_t corners = 0;
    for (const geometry::EdgeUse& use : region.loops.front()) {
      const auto e = static_cast<std::size_t>(use.edge.value);
      corners += shared[e] || curves[e].closed() ? places[e].size() + 1 : curves[e].straight() ? 1 : 2;
      if (shared[e] && !curves[e].closed()) edges.push_back(use.edge.value);
    }
    if (edges.empty() || corners > 2) continue;
    const auto stretch = [&](int edge) {
      return Weight(curves[edge], 1).all() / static_cast<double>(places[edge].size() + 1);
    };
    for (; corners < 4; ++corners) {
      const int longest = *std::max_element(edges.begin(), edges.end(),
                                            [&](int a, int b) { return stretch(a) < stretch(b); });
      cut_further(curves[longest], places[longest], 1);
    }
  }
}

}  // namespace

CutPlaces made_even(const Profile& profile, const std::vector<Curve>& curves, CutPlaces places) {
  const std::vector<int> further = cuts_for_parity(profile, curves, places);
  for (std::size_t e = 0; e < curves.size(); ++e) cut_further(curves[e], places[e], further[e]);
  return places;
}

namespace {

/// Enters the feet of points on a curve that are not close to its ends, its cuts and each other.
bool cut_at_feet(const Curve& curve, const std::vector<Eigen::Vector2d>& points,
                 std::vector<double>& places) {
  constexpr double apart = 0.08;
  bool any = false;
  for (const Eigen::Vector2d& point : points) {
    const double at = curve.nearest(point, 0, 1);
    const auto is_close = [&](double place) { return std::abs(at - place) < apart; };
    if (is_close(0) || is_close(1) || std::any_of(places.begin(), places.end(), is_close)) continue;
    places.push_back(at);
    any = true;
  }
  std::sort(places.begin(), places.end());
  return any;
}

/// Enters the feet of corners that point into a region, however close to the ends, if what lies beside is no
/// sliver.
bool cut_at_corners(const Curve& curve, const std::vector<Eigen::Vector2d>& corners,
                    std::vector<double>& places) {
  constexpr double sliver = 0.1;
  bool any = false;
  for (const Eigen::Vector2d& corner : corners) {
    const double at = curve.nearest(corner, 0, 1);
    const double apart = sliver * (curve.at(at) - corner).norm() / curve.length();
    const auto is_close = [&](double place) { return std::abs(at - place) <= apart; };
    if (is_close(0) || is_close(1) || std::any_of(places.begin(), places.end(), is_close)) continue;
    places.push_back(at);
    any = true;
  }
  std::sort(places.begin(), places.end());
  return any;
}

/// Corners of a loop that point into its region, by more than a few degrees.
std::vector<Eigen::Vector2d> corners_into(const std::vector<geometry::EdgeUse>& loop,
                                          const std::vector<Curve>& curves) {
  constexpr double blunt = 0.35;  // radians
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const geometry::EdgeUse &before = loop[i], &after = loop[(i + 1) % loop.size()];
    const Curve &in = curves[before.edge.value], &out = curves[after.edge.value];
    if (in.closed() || out.closed()) continue;
    const Eigen::Vector2d a = before.reversed ? Eigen::Vector2d(-in.derivative(0)) : in.derivative(1);
    const Eigen::Vector2d b = after.reversed ? Eigen::Vector2d(-out.derivative(1)) : out.derivative(0);
    if (std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) < -blunt)
      result.push_back(out.at(after.reversed ? 1 : 0));
  }
  return result;
}

Eigen::Vector2d middle_of(const Curve& curve) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < 16; ++i) sum += curve.at(i / 16.0) / 16;
  return sum;
}

}  // namespace

std::vector<bool> shared_edges(const Profile& profile) {
  std::vector<bool> result;
  for (const auto& regions : regions_beside(profile)) result.push_back(regions[0] >= 0 && regions[1] >= 0);
  return result;
}

CutPlaces shared_places(const Profile& profile, const std::vector<Curve>& curves, const SharedCuts& cuts) {
  constexpr double most = 110 * pi / 180;  // a little less than what a side may turn
  const std::vector<bool> shared = shared_edges(profile);
  CutPlaces result(curves.size());
  for (std::size_t e = 0; e < curves.size(); ++e) {
    if (!shared[e]) continue;
    if (curves[e].closed()) {
      result[e] = places_of_directions(curves[e], cuts.diagonal ? pi / 4 : 0, pi / 2);
      for (double& at : result[e]) at -= std::floor(at);
      std::sort(result[e].begin(), result[e].end());
    } else {
      cut_where_it_bends(curves[e], result[e], most);
    }
    if (result[e].empty() && curves[e].closed()) result[e] = {0, 0.25, 0.5, 0.75};
  }
  give_four_corners(profile, curves, shared, result);
  return made_even(profile, curves, std::move(result));
}

CutPlaces further_places(const Profile& profile, const std::vector<Curve>& curves, const CutPlaces& places,
                         const std::vector<int>& regions) {
  const std::vector<bool> shared = shared_edges(profile);
  CutPlaces result = places;
  for (const int region : regions) {
    std::vector<int> edges;
    std::vector<Eigen::Vector2d> bores;
    for (const auto& loop : profile.regions[region].loops)
      for (const geometry::EdgeUse& use : loop) {
        const Curve& curve = curves[use.edge.value];
        if (shared[use.edge.value]) edges.push_back(use.edge.value);
        if (curve.closed() && loop != profile.regions[region].loops.front())
          bores.push_back(middle_of(curve));
      }
    bool any = false;
    for (const int edge : edges) {
      std::vector<Eigen::Vector2d> points = bores;
      for (const int other : edges)
        for (const double at : places[other])
          if (other != edge) points.push_back(curves[other].at(at));
      if (curves[edge].straight()) any = cut_at_feet(curves[edge], points, result[edge]) || any;
    }
    if (any || edges.empty()) continue;
    std::vector<Eigen::Vector2d> corners;
    for (const auto& loop : profile.regions[region].loops)
      for (const Eigen::Vector2d& corner : corners_into(loop, curves)) corners.push_back(corner);
    for (const int edge : edges) any = cut_at_corners(curves[edge], corners, result[edge]) || any;
    if (any) continue;
    const auto stretch = [&](int edge) {
      return Weight(curves[edge], 1).all() / static_cast<double>(result[edge].size() + 1);
    };
    const int longest =
        *std::max_element(edges.begin(), edges.end(), [&](int a, int b) { return stretch(a) < stretch(b); });
    cut_further(curves[longest], result[longest], 1);
  }
  return made_even(profile, curves, std::move(result));
}

}  // namespace isopatch::segmentation::planar

#include "iga/spaces/matching_spaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::iga {
namespace {

using geometry::Interface;
using geometry::KnotVector;

// `target` with the knots of `source` (scaled to its range, turned around if flipped) that it lacks.
KnotVector with_knots_of(const KnotVector& target, const KnotVector& source, bool flipped, double tolerance) {
  const KnotVector scaled =
      geometry::rescaled(flipped ? geometry::reversed(source) : source, target.first(), target.last());
  const std::vector<double> breaks = target.breaks();
  const std::vector<int> multiplicities = target.multiplicities();
  const std::vector<double> wanted = scaled.breaks();
  const std::vector<int> wanted_multiplicities = scaled.multiplicities();
  std::vector<double> missing;
  for (std::size_t i = 1; i + 1 < wanted.size(); ++i) {
    const auto nearest = std::min_element(breaks.begin(), breaks.end(), [&](double x, double y) {
      return std::abs(x - wanted[i]) < std::abs(y - wanted[i]);
    });
    const bool present = std::abs(*nearest - wanted[i]) <= tolerance * target.length();
    const int have = present ? multiplicities[static_cast<std::size_t>(nearest - breaks.begin())] : 0;
    missing.insert(missing.end(), static_cast<std::size_t>(std::max(0, wanted_multiplicities[i] - have)),
                   present ? *nearest : wanted[i]);
  }
  return missing.empty() ? target : geometry::with_knots(target, missing);
}

void raise_degrees(const std::vector<int>& groups, DirectionKnots& knots) {
  std::vector<int> degree(knots.size(), 0);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    int& of_group = degree[static_cast<std::size_t>(groups[i])];
    of_group = std::max(of_group, knots[i].degree());
  }
  for (std::size_t i = 0; i < knots.size(); ++i)
    knots[i] = geometry::with_degree_raised(knots[i],
                                            degree[static_cast<std::size_t>(groups[i])] - knots[i].degree());
}

// Calls visit(local index on the first face, local index on the second) for all points of two matching faces.
template <class Visit>
void for_each_pair(const Interface& interface, const std::vector<std::array<int, 3>>& sizes, Visit visit) {
  const auto& a = sizes[static_cast<std::size_t>(interface.first.patch.value)];
  const auto& b = sizes[static_cast<std::size_t>(interface.second.patch.value)];
  const auto directions_a = geometry::tangents(interface.first.side);
  const auto directions_b = geometry::tangents(interface.second.side);
  const int m = a[static_cast<std::size_t>(directions_a[0])];
  const int n = a[static_cast<std::size_t>(directions_a[1])];
  const int m_b = b[static_cast<std::size_t>(directions_b[0])];
  const int n_b = b[static_cast<std::size_t>(directions_b[1])];
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      int s = interface.orientation.swapped ? j : i;
      int t = interface.orientation.swapped ? i : j;
      if (interface.orientation.flip_first) s = m_b - 1 - s;
      if (interface.orientation.flip_second) t = n_b - 1 - t;
      visit(i + m * j, s + m_b * t);
    }
  }
}

}  // namespace

std::array<TiedPair, 2> tied_pairs(const Interface& interface) {
  const auto a = geometry::tangents(interface.first.side);
  const auto b = geometry::tangents(interface.second.side);
  const auto& o = interface.orientation;
  const auto index = [](const geometry::PatchFace& face, int direction) {
    return static_cast<std::size_t>(3 * face.patch.value + direction);
  };
  const std::size_t a0 = index(interface.first, a[0]);
  const std::size_t a1 = index(interface.first, a[1]);
  const std::size_t b0 = index(interface.second, b[0]);
  const std::size_t b1 = index(interface.second, b[1]);
  // The orientation exchanges first and turns around afterwards, so its flips belong to the second face.
  if (o.swapped) return {TiedPair{a0, b1, o.flip_second}, TiedPair{a1, b0, o.flip_first}};
  return {TiedPair{a0, b0, o.flip_first}, TiedPair{a1, b1, o.flip_second}};
}

std::vector<int> tied_directions(const geometry::MultiPatch& model) {
  UnionFind directions(3 * model.patch_count());
  for (const Interface& interface : model.interfaces())
    for (const TiedPair& pair : tied_pairs(interface))
      directions.unite(static_cast<int>(pair.first), static_cast<int>(pair.second));
  std::vector<int> groups;
  for (int i = 0; i < 3 * model.patch_count(); ++i) groups.push_back(directions.find(i));
  return groups;
}

DirectionKnots matched(const geometry::MultiPatch& model, DirectionKnots knots) {
  raise_degrees(tied_directions(model), knots);
  // Knots propagate across interfaces until nothing is missing: a pair of directions is visited again when
  // one of the two has got more knots. Each visit carries them one interface further, so that as many visits
  // of each pair as there are directions are enough for any model.
  const double tolerance = model.tolerance().same_knot;
  std::vector<TiedPair> pairs;
  for (const Interface& interface : model.interfaces())
    for (const TiedPair& pair : tied_pairs(interface)) pairs.push_back(pair);
  std::vector<std::vector<std::size_t>> pairs_of(knots.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs_of[pairs[i].first].push_back(i);
    if (pairs[i].second != pairs[i].first) pairs_of[pairs[i].second].push_back(i);
  }
  std::deque<std::size_t> waiting(pairs.size());
  std::iota(waiting.begin(), waiting.end(), 0);
  std::vector<bool> waits(pairs.size(), true);
  const auto replace = [&](std::size_t direction, KnotVector more) {
    const bool changed = more.size() != knots[direction].size();
    knots[direction] = std::move(more);
    for (const std::size_t i : changed ? pairs_of[direction] : std::vector<std::size_t>{}) {
      if (!waits[i]) waiting.push_back(i);
      waits[i] = true;
    }
  };
  for (std::size_t looks = 0; looks <= (knots.size() + 1) * pairs.size(); ++looks) {
    if (waiting.empty()) return knots;
    const TiedPair& pair = pairs[waiting.front()];
    waits[waiting.front()] = false;
    waiting.pop_front();
    KnotVector second = with_knots_of(knots[pair.second], knots[pair.first], pair.flipped, tolerance);
    KnotVector first = with_knots_of(knots[pair.first], second, pair.flipped, tolerance);
    replace(pair.second, std::move(second));
    replace(pair.first, std::move(first));
  }
  throw Error(ErrorCode::not_conforming,
              "the knots of neighbouring patches cannot be matched: a patch meets itself with knots that no "
              "common refinement serves");
}

void check_traces(const geometry::MultiPatch& model, const std::vector<geometry::NurbsVolume>& patches) {
  const std::vector<std::array<int, 3>> sizes = sizes_of(patches);
  for (const Interface& interface : model.interfaces()) {
    const auto& a = patches[static_cast<std::size_t>(interface.first.patch.value)];
    const auto& b = patches[static_cast<std::size_t>(interface.second.patch.value)];
    const std::string faces = model.label(interface.first) + " and " + model.label(interface.second);
    const auto points_a = geometry::face_control_points(a.sizes(), interface.first.side);
    const auto points_b = geometry::face_control_points(b.sizes(), interface.second.side);
    if (points_a.size() != points_b.size())
      throw Error(ErrorCode::not_conforming, fmt::format("faces {} have traces of {} and {} functions", faces,
                                                         points_a.size(), points_b.size()));
    double low = 1e300;
    double high = 0;
    for_each_pair(interface, sizes, [&](int i, int j) {
      const int pa = points_a[static_cast<std::size_t>(i)];
      const int pb = points_b[static_cast<std::size_t>(j)];
      const double ratio = a.weights()[pa] / b.weights()[pb];
      low = std::min(low, ratio);
      high = std::max(high, ratio);
    });
    if (high - low > 1e-8 * high)
      throw Error(ErrorCode::not_conforming, fmt::format("the weights of faces {} are not proportional "
                                                         "(ratios {} to {}): the same surface with different "
                                                         "functions on it; give both the same weights",
                                                         faces, low, high));
  }
}

std::vector<std::pair<int, int>> matching_control_points(const Interface& interface,
                                                         const std::vector<std::array<int, 3>>& sizes) {
  const auto points_a = geometry::face_control_points(
      sizes[static_cast<std::size_t>(interface.first.patch.value)], interface.first.side);
  const auto points_b = geometry::face_control_points(
      sizes[static_cast<std::size_t>(interface.second.patch.value)], interface.second.side);
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(points_a.size());
  for_each_pair(interface, sizes, [&](int i, int j) {
    pairs.emplace_back(points_a[static_cast<std::size_t>(i)], points_b[static_cast<std::size_t>(j)]);
  });
  return pairs;
}

std::vector<std::array<int, 3>> sizes_of(const std::vector<geometry::NurbsVolume>& patches) {
  std::vector<std::array<int, 3>> sizes;
  for (const geometry::NurbsVolume& patch : patches) sizes.push_back(patch.sizes());
  return sizes;
}

}  // namespace isopatch::iga

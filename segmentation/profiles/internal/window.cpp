#include "segmentation/profiles/internal/window.hpp"

#include <algorithm>
#include <set>

#include "segmentation/profiles/internal/triangulate.hpp"

namespace isopatch::segmentation::planar {

namespace {

double chance(Random& random) {
  return static_cast<double>(random() - Random::min()) / (Random::max() - Random::min());
}

/// Sides inside a window that are no longer there: those of a tree of its cells.
std::set<SideKey> joined_sides(const CellMesh& mesh, const Neighbours& neighbours,
                               const std::vector<int>& cells, Random& random) {
  const std::set<int> inside(cells.begin(), cells.end());
  std::set<int> reached = {cells.front()};
  std::set<SideKey> result;
  std::vector<Side> open;
  const auto enter = [&](int cell) {
    for (int k = 0; k < mesh.cells[cell].count; ++k) open.push_back(mesh.cells[cell].sides[k]);
  };
  enter(cells.front());
  while (!open.empty()) {
    std::swap(open[random() % open.size()], open.back());
    const Side side = open.back();
    open.pop_back();
    const int other = neighbours.across(side);
    if (!inside.contains(other) || side.curve >= 0 || !reached.insert(other).second) continue;
    result.insert(key_of(side));
    result.insert(key_across(side));
    enter(other);
  }
  return result;
}

/// The sides around cells that are joined, in order.
std::vector<Side> walk_around(const CellMesh& mesh, const Neighbours& neighbours,
                              const std::vector<int>& cells, const std::set<SideKey>& joined) {
  const auto place_in = [&](int cell, const Side& side) {
    for (int k = 0; k < mesh.cells[cell].count; ++k)
      if (key_of(mesh.cells[cell].sides[k]) == key_of(side)) return k;
    return -1;
  };
  int cell = -1, at = 0;
  for (const int start : cells)
    for (int k = 0; k < mesh.cells[start].count && cell < 0; ++k)
      if (!joined.contains(key_of(mesh.cells[start].sides[k]))) {
        cell = start;
        at = k;
      }
  std::vector<Side> result;
  const SideKey first = key_of(mesh.cells[cell].sides[at]);
  do {
    const Side& side = mesh.cells[cell].sides[at];
    if (joined.contains(key_of(side))) {
      const Side back = turned(side);
      cell = neighbours.across(side);
      at = place_in(cell, back);
    } else {
      result.push_back(side);
    }
    at = (at + 1) % mesh.cells[cell].count;
  } while (key_of(mesh.cells[cell].sides[at]) != first);
  return result;
}

std::vector<Place> places_of(const CellMesh& mesh, const std::vector<Side>& walk,
                             const std::vector<bool>& shared) {
  std::map<int, int> times;
  for (const Side& side : walk) ++times[side.from];
  std::vector<Place> result;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const Side &before = walk[(i + walk.size() - 1) % walk.size()], &after = walk[i];
    const bool inside_curve = mesh.nodes[after.from].is_cut() && before.curve >= 0 &&
                              before.curve == after.curve && before.reversed == after.reversed &&
                              !shared[static_cast<std::size_t>(after.curve)];
    result.push_back({after.from, inside_curve && times[after.from] == 1, after});
  }
  return result;
}

/// Takes away ways to a node inside and back.
void leave_nodes_out(const CellMesh& mesh, std::vector<Side>& walk, double probability, Random& random) {
  std::set<int> kept;
  for (bool again = true; again && walk.size() > 2;) {
    again = false;
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const std::size_t next = (i + 1) % walk.size();
      const int tip = walk[i].to;
      if (walk[i].curve >= 0 || walk[next].to != walk[i].from || walk[next].curve >= 0) continue;
      if (!mesh.nodes[tip].is_inside() || kept.contains(tip)) continue;
      if (chance(random) >= probability) {
        kept.insert(tip);
        continue;
      }
      walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
      walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
      again = true;
      break;
    }
  }
}

}  // namespace

Neighbours::Neighbours(const CellMesh& mesh) : around_(mesh.nodes.size()) {
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < mesh.cells[c].count; ++k) {
      const Side& side = mesh.cells[c].sides[k];
      cells_[key_of(side)] = static_cast<int>(c);
      around_[static_cast<std::size_t>(side.from)].push_back(static_cast<int>(c));
    }
}

int Neighbours::across(const Side& side) const {
  const auto found = cells_.find(key_across(side));
  return found == cells_.end() ? -1 : found->second;
}

std::vector<int> window_around(const CellMesh& mesh, const Neighbours& neighbours, int cell, int room,
                               Random& random) {
  std::vector<int> result;
  std::set<int> seen = {cell};
  std::vector<std::pair<double, int>> open = {{0, cell}};
  const auto middle = [&](int c) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int k = 0; k < mesh.cells[c].count; ++k) sum += mesh.nodes[mesh.cells[c].sides[k].from].point;
    return Eigen::Vector2d(sum / mesh.cells[c].count);
  };
  const Eigen::Vector2d start = middle(cell);
  while (!open.empty()) {
    const auto nearest = std::min_element(open.begin(), open.end());
    const int next = nearest->second;
    open.erase(nearest);
    room -= mesh.cells[next].count - 2;
    if (room < 0 && !result.empty()) break;
    result.push_back(next);
    for (int k = 0; k < mesh.cells[next].count; ++k) {
      const Side& side = mesh.cells[next].sides[k];
      const int other = neighbours.across(side);
      if (other < 0 || side.curve >= 0 || !seen.insert(other).second) continue;
      open.emplace_back((middle(other) - start).norm() * (0.3 + chance(random)), other);
    }
  }
  return result;
}

std::vector<std::vector<Place>> loops_of(const std::vector<Curve>& curves, const CellMesh& mesh,
                                         const Neighbours& neighbours, const std::vector<int>& cells,
                                         const std::vector<bool>& shared) {
  const std::set<int> inside(cells.begin(), cells.end());
  std::map<int, Side> leaving;
  for (const int cell : cells)
    for (int k = 0; k < mesh.cells[cell].count; ++k) {
      const Side& side = mesh.cells[cell].sides[k];
      if (inside.contains(neighbours.across(side)) && side.curve < 0) continue;
      if (!leaving.try_emplace(side.from, side).second) return {};
    }
  std::vector<std::vector<Place>> result;
  while (!leaving.empty()) {
    std::vector<Side> loop;
    for (auto next = leaving.begin(); next != leaving.end(); next = leaving.find(loop.back().to)) {
      loop.push_back(next->second);
      leaving.erase(next);
    }
    double area = 0;
    for (const Side& side : loop) {
      const SideShape shape = side_shape(curves, mesh.nodes, side);
      for (int s = 0; s + 1 < SideShape::samples; ++s) {
        const Eigen::Vector2d a = shape.point(s), b = shape.point(s + 1);
        area += a.x() * b.y() - a.y() * b.x();
      }
    }
    result.push_back(places_of(mesh, loop, shared));
    if (area > 0) std::swap(result.front(), result.back());
  }
  return result;
}

namespace {

/// Whether a chord meets the sides of loops but at its ends.
bool is_free(const std::vector<Curve>& curves, const std::vector<Node>& nodes,
             const std::vector<std::vector<Place>>& loops, int a, int b) {
  for (const std::vector<Place>& loop : loops)
    for (const Place& place : loop) {
      const Side& side = place.link;
      if (side.from == a || side.from == b || side.to == a || side.to == b) continue;
      const SideShape shape = side_shape(curves, nodes, side);
      const int step = shape.straight ? SideShape::samples - 1 : (SideShape::samples - 1) / 2;
      for (int s = 0; s + 1 < SideShape::samples; s += step)
        if (segments_meet(nodes[a].point, nodes[b].point, shape.point(s), shape.point(s + step)))
          return false;
    }
  return true;
}

}  // namespace

std::vector<Place> joined_at_random(const std::vector<Curve>& curves, const std::vector<Node>& nodes,
                                    std::vector<std::vector<Place>> loops, Random& random) {
  constexpr std::size_t shortest = 24;  // of the pairs of places are tried
  struct Pair {
    double length;
    std::size_t loop, in_loop, at;
  };
  while (loops.size() > 1) {
    std::vector<Pair> pairs;
    for (std::size_t l = 1; l < loops.size(); ++l)
      for (std::size_t i = 0; i < loops[l].size(); ++i)
        for (std::size_t j = 0; j < loops.front().size(); ++j) {
          const double length = (nodes[loops[l][i].node].point - nodes[loops.front()[j].node].point).norm();
          pairs.push_back({length * (0.5 + chance(random)), l, i, j});
        }
    const auto last = pairs.begin() + static_cast<std::ptrdiff_t>(std::min(shortest, pairs.size()));
    std::partial_sort(pairs.begin(), last, pairs.end(),
                      [](const Pair& a, const Pair& b) { return a.length < b.length; });
    const auto found = std::find_if(pairs.begin(), last, [&](const Pair& pair) {
      return is_free(curves, nodes, loops, loops[pair.loop][pair.in_loop].node, loops.front()[pair.at].node);
    });
    if (found == last) return {};
    std::vector<Place> hole = loops[found->loop];
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(found->in_loop), hole.end());
    const int inner = hole.front().node, outer = loops.front()[found->at].node;
    hole.front().optional = false;
    loops.front()[found->at].optional = false;
    hole.insert(hole.begin(), {outer, false, Side{outer, inner}});
    hole.push_back({inner, false, Side{inner, outer}});
    loops.front().insert(loops.front().begin() + static_cast<std::ptrdiff_t>(found->at), hole.begin(),
                         hole.end());
    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(found->loop));
  }
  return loops.front();
}

std::vector<Place> outline_of(const CellMesh& mesh, const Neighbours& neighbours,
                              const std::vector<int>& cells, const std::vector<bool>& shared,
                              double leave_out, Random& random) {
  std::vector<Side> walk =
      walk_around(mesh, neighbours, cells, joined_sides(mesh, neighbours, cells, random));
  leave_nodes_out(mesh, walk, leave_out, random);
  return places_of(mesh, walk, shared);
}

}  // namespace isopatch::segmentation::planar

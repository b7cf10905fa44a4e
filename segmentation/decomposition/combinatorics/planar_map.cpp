#include "segmentation/decomposition/combinatorics/internal/planar_map.hpp"

#include <algorithm>

namespace isopatch::segmentation {
namespace {

int fan_size(const Darts& darts, int first) {
  int count = 0, dart = first;
  do {
    dart = darts.twin[darts.previous[dart]];
    ++count;
  } while (dart != first);
  return count;
}

bool is_one_shell(const PlanarMap& map, const Darts& darts) {
  std::vector<char> seen(map.faces());
  std::vector<int> open = {0};
  seen[0] = 1;
  int count = 1;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (int dart = map.begin[face]; dart < map.begin[face + 1]; ++dart) {
      const int other = darts.face[darts.twin[dart]];
      if (seen[other]) continue;
      seen[other] = 1;
      ++count;
      open.push_back(other);
    }
  }
  return count == map.faces();
}

// The vertices that the faces after one share with it, as many as three of each.
class SharedCorners {
 public:
  SharedCorners(const PlanarMap& map, const Darts& darts)
      : map_(map), darts_(darts), count_(map.faces()), edges_(map.faces()) {}

  // Whether a face shares no more with any other than a vertex or an edge.
  bool agrees(int face) {
    touched_.clear();
    for (int dart = map_.begin[face]; dart < map_.begin[face + 1]; ++dart) {
      ++edges_[darts_.face[darts_.twin[dart]]];
      const int vertex = map_.corners[dart];
      for (int k = darts_.out_begin[vertex]; k < darts_.out_begin[vertex + 1]; ++k)
        note(darts_.face[darts_.out[k]]);
    }
    bool good = count_[face] == map_.size(face) && edges_[face] == 0;
    for (const int other : touched_) {
      if (other != face && count_[other] > 1) good = good && count_[other] == 2 && edges_[other] == 1;
      count_[other] = edges_[other] = 0;
    }
    return good;
  }

 private:
  void note(int face) {
    if (count_[face]++ == 0) touched_.push_back(face);
  }

  const PlanarMap& map_;
  const Darts& darts_;
  std::vector<int> count_, edges_, touched_;
};

}  // namespace

PlanarMap planar_map(const CellGraph& graph) {
  PlanarMap map;
  map.vertices = graph.vertex_count;
  map.corners.reserve(2 * graph.edges.size());
  map.begin.reserve(graph.faces.size() + 1);
  for (const CellGraph::Corners& face : graph.faces) {
    for (const VertexId vertex : face) map.corners.push_back(vertex.value);
    map.end_face();
  }
  return map;
}

CellGraph cell_graph(const PlanarMap& map) {
  std::vector<std::vector<int>> faces;
  for (int f = 0; f < map.faces(); ++f)
    faces.emplace_back(map.corners.begin() + map.begin[f], map.corners.begin() + map.begin[f + 1]);
  return cell_graph(map.vertices, faces);
}

int Darts::between(const PlanarMap& map, int a, int b) const {
  for (int k = out_begin[a]; k < out_begin[a + 1]; ++k)
    if (map.corners[next[out[k]]] == b) return out[k];
  return -1;
}

Darts darts(const PlanarMap& map) {
  const int count = static_cast<int>(map.corners.size());
  Darts result;
  result.next.resize(count);
  result.previous.resize(count);
  result.face.resize(count);
  result.twin.resize(count);
  result.out.resize(count);
  result.out_begin.assign(map.vertices + 1, 0);
  for (int f = 0; f < map.faces(); ++f)
    for (int d = map.begin[f], last = map.begin[f + 1] - 1; d <= last; ++d) {
      const int next = d == last ? map.begin[f] : d + 1;
      result.next[d] = next;
      result.previous[next] = d;
      result.face[d] = f;
      ++result.out_begin[map.corners[d] + 1];
    }
  for (int v = 0; v < map.vertices; ++v) result.out_begin[v + 1] += result.out_begin[v];
  std::vector<int> filled(result.out_begin.begin(), result.out_begin.end() - 1);
  for (int d = 0; d < count; ++d) result.out[filled[map.corners[d]]++] = d;
  for (int d = 0; d < count; ++d)
    result.twin[d] = result.between(map, map.corners[result.next[d]], map.corners[d]);
  return result;
}

bool is_sphere(const PlanarMap& map, const Darts& darts) {
  const int count = static_cast<int>(map.corners.size());
  if (count == 0) return false;
  for (int d = 0; d < count; ++d)
    if (darts.twin[d] < 0 || darts.twin[darts.twin[d]] != d) return false;
  for (int v = 0; v < map.vertices; ++v) {
    const int degree = darts.out_begin[v + 1] - darts.out_begin[v];
    if (degree == 0 || fan_size(darts, darts.out[darts.out_begin[v]]) != degree) return false;
  }
  return map.vertices - count / 2 + map.faces() == 2 && is_one_shell(map, darts);
}

bool is_three_connected(const PlanarMap& map, const Darts& darts) {
  if (map.vertices < 4) return false;
  for (int v = 0; v < map.vertices; ++v)
    if (darts.out_begin[v + 1] - darts.out_begin[v] < 3) return false;
  SharedCorners shared(map, darts);
  for (int f = 0; f < map.faces(); ++f)
    if (!shared.agrees(f)) return false;
  return true;
}

}  // namespace isopatch::segmentation

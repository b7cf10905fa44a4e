#include "segmentation/decomposition/combinatorics/internal/map_cut.hpp"

#include <algorithm>

namespace isopatch::segmentation {
namespace {

enum class MapSide : char { unknown, left, right, both };

// What a loop makes of each face, and where it crosses those on both sides.
class MapCut {
 public:
  MapCut(const PlanarMap& map, const Darts& around, const std::vector<int>& loop)
      : map_(map), around_(around), loop_(loop), side_(map.faces()), crossing_(map.faces()) {
    for (std::size_t k = 0; k < loop.size(); ++k) mark(loop[k], loop[(k + 1) % loop.size()]);
    for (const int face : crossed_) spread_from_crossed(face);
    while (!open_.empty()) spread();
  }

  PlanarMap piece(MapSide of) const {
    PlanarMap result;
    result.corners.reserve(map_.corners.size());
    result.begin.reserve(map_.begin.size() + 1);
    for (int face = 0; face < map_.faces(); ++face) {
      if (side_[face] == of)
        result.corners.insert(result.corners.end(), map_.corners.begin() + map_.begin[face],
                              map_.corners.begin() + map_.begin[face + 1]);
      else if (side_[face] == MapSide::both)
        add_part(result, face, of);
      else
        continue;
      result.end_face();
    }
    if (of == MapSide::left)
      result.corners.insert(result.corners.end(), loop_.rbegin(), loop_.rend());
    else
      result.corners.insert(result.corners.end(), loop_.begin(), loop_.end());
    result.end_face();
    renumber(result);
    return result;
  }

 private:
  struct Crossing {
    int out = -1, in = -1;  // the face's darts that start where the loop enters it and where it leaves it
  };

  void mark(int a, int b) {
    if (const int dart = around_.between(map_, a, b); dart >= 0) {
      put(around_.face[dart], MapSide::left);
      put(around_.face[around_.twin[dart]], MapSide::right);
      return;
    }
    for (int k = around_.out_begin[a]; k < around_.out_begin[a + 1]; ++k)
      for (int m = around_.out_begin[b]; m < around_.out_begin[b + 1]; ++m) {
        const int face = around_.face[around_.out[k]];
        if (face != around_.face[around_.out[m]]) continue;
        side_[face] = MapSide::both;
        crossing_[face] = {around_.out[k], around_.out[m]};
        crossed_.push_back(face);
        return;
      }
  }

  void put(int face, MapSide side) {
    if (side_[face] != MapSide::unknown) return;
    side_[face] = side;
    open_.push_back(face);
  }

  void put_along(int from, int to, MapSide side) {
    for (int dart = from; dart != to; dart = around_.next[dart]) put(around_.face[around_.twin[dart]], side);
  }

  // From where the loop leaves the face to where it enters it, its side lies to the left.
  void spread_from_crossed(int face) {
    put_along(crossing_[face].in, crossing_[face].out, MapSide::left);
    put_along(crossing_[face].out, crossing_[face].in, MapSide::right);
  }

  void spread() {
    const int face = open_.back();
    open_.pop_back();
    for (int dart = map_.begin[face]; dart < map_.begin[face + 1]; ++dart)
      put(around_.face[around_.twin[dart]], side_[face]);
  }

  void add_part(PlanarMap& result, int face, MapSide of) const {
    int from = crossing_[face].in, to = crossing_[face].out;
    if (of == MapSide::right) std::swap(from, to);
    for (int dart = from; dart != to; dart = around_.next[dart]) result.corners.push_back(map_.corners[dart]);
    result.corners.push_back(map_.corners[to]);
  }

  void renumber(PlanarMap& result) const {
    std::vector<int> number(map_.vertices, -1);
    for (const int vertex : result.corners) number[vertex] = 0;
    for (int& value : number)
      if (value == 0) value = result.vertices++;
    for (int& vertex : result.corners) vertex = number[vertex];
  }

  const PlanarMap& map_;
  const Darts& around_;
  const std::vector<int>& loop_;
  std::vector<MapSide> side_;
  std::vector<Crossing> crossing_;
  std::vector<int> crossed_, open_;
};

}  // namespace

PlaceGraph vertex_places(const PlanarMap& map, const Darts& around) {
  PlaceGraph graph;
  graph.faces = map.faces();
  std::vector<int> seen(map.vertices, -1);
  for (int v = 0; v < map.vertices; ++v) {
    seen[v] = v;
    for (int k = around.out_begin[v]; k < around.out_begin[v + 1]; ++k) {
      const int face = around.face[around.out[k]];
      graph.face.push_back(face);
      for (int d = map.begin[face]; d < map.begin[face + 1]; ++d) {
        if (seen[map.corners[d]] == v) continue;
        seen[map.corners[d]] = v;
        graph.near.push_back(map.corners[d]);
      }
    }
    graph.face_begin.push_back(static_cast<int>(graph.face.size()));
    graph.near_begin.push_back(static_cast<int>(graph.near.size()));
  }
  return graph;
}

MapPieces cut(const PlanarMap& map, const Darts& around, const std::vector<int>& loop) {
  const MapCut result(map, around, loop);
  return {result.piece(MapSide::left), result.piece(MapSide::right)};
}

}  // namespace isopatch::segmentation

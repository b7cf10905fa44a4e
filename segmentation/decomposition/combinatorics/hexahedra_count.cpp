#include "segmentation/decomposition/combinatorics/hexahedra_count.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/internal/hexahedra_estimate.hpp"
#include "segmentation/decomposition/combinatorics/internal/map_code.hpp"
#include "segmentation/decomposition/combinatorics/internal/map_cut.hpp"

namespace isopatch::segmentation {
namespace {

struct CountedMap {
  PlanarMap map;
  Darts around;
  explicit CountedMap(PlanarMap given) : map(std::move(given)), around(darts(map)) {}
};

int degree(const Darts& around, int vertex) {
  return around.out_begin[vertex + 1] - around.out_begin[vertex];
}

// 1, 3, 4 for a hexahedron, a prism over a triangle and a tetrahedron, else 0.
int base_count(const CountedMap& counted) {
  const PlanarMap& map = counted.map;
  if (map.vertices == 4) return 4;
  const auto three = [&] {
    for (int v = 0; v < map.vertices; ++v)
      if (degree(counted.around, v) != 3) return false;
    return true;
  };
  if (map.vertices == 6 && map.faces() == 5 && three()) return 3;
  if (map.vertices != 8 || map.faces() != 6 || !three()) return 0;
  for (int f = 0; f < map.faces(); ++f)
    if (map.size(f) != 4) return 0;
  return 1;
}

// No fewer hexahedra are possible: a face with an odd number of corners has a triangle among its parts, and
// base solids make a hexahedron for each of their triangles, or more.
int lower_bound(const PlanarMap& map) {
  int odd = 0;
  for (int f = 0; f < map.faces(); ++f) odd += map.size(f) % 2;
  return std::max(odd, 1);
}

struct CountedCut {
  int bound;
  MapPieces pieces;
};

}  // namespace

struct HexahedraCount::Memory {
  std::unordered_map<std::u16string, int> known;

  int count(CountedMap counted) {
    if (const int base = base_count(counted)) return base;
    std::u16string code = map_code(counted.map, counted.around, {}, true);
    if (const auto found = known.find(code); found != known.end()) return found->second;
    const int result = least(counted);
    known.emplace(std::move(code), result);
    return result;
  }

  int least(const CountedMap& counted) {
    std::vector<CountedCut> cuts = all_cuts(counted);
    const int bound = std::max(2, lower_bound(counted.map));
    int best = 1000000000;
    for (CountedCut& cut : cuts) {
      if (cut.bound >= best) continue;
      const int right_bound = lower_bound(cut.pieces.right);
      const int left = count(CountedMap(std::move(cut.pieces.left)));
      if (left + right_bound >= best) continue;
      best = std::min(best, left + count(CountedMap(std::move(cut.pieces.right))));
      if (best <= bound) break;
    }
    return best;
  }

  // Those whose larger piece is smallest come first: they lead to a good bound soon.
  static std::vector<CountedCut> all_cuts(const CountedMap& counted) {
    std::vector<CountedCut> cuts;
    const PlaceGraph places = vertex_places(counted.map, counted.around);
    LoopWalk(places, counted.map.vertices, [&](const std::vector<int>& loop) {
      MapPieces pieces = cut(counted.map, counted.around, loop);
      if (pieces.left.vertices > pieces.right.vertices) std::swap(pieces.left, pieces.right);
      const int bound = lower_bound(pieces.left) + lower_bound(pieces.right);
      cuts.push_back({bound, std::move(pieces)});
      return true;
    }).all();
    std::stable_sort(cuts.begin(), cuts.end(), [](const CountedCut& a, const CountedCut& b) {
      return std::pair(a.bound, a.pieces.right.vertices) < std::pair(b.bound, b.pieces.right.vertices);
    });
    return cuts;
  }
};

HexahedraCount::HexahedraCount() : memory_(std::make_unique<Memory>()) {}
HexahedraCount::~HexahedraCount() = default;
HexahedraCount::HexahedraCount(HexahedraCount&&) noexcept = default;
HexahedraCount& HexahedraCount::operator=(HexahedraCount&&) noexcept = default;

int HexahedraCount::minimum(const CellGraph& graph) {
  CountedMap counted(planar_map(graph));
  if (!is_sphere(counted.map, counted.around) || !is_three_connected(counted.map, counted.around))
    throw Error(ErrorCode::not_three_connected,
                "the hexahedra of a cell are counted where it is 3-connected and bounds a ball");
  return memory_->count(std::move(counted));
}

double HexahedraCount::estimate(const CellGraph& graph, int exact_up_to) {
  if (graph.vertex_count <= exact_up_to) return minimum(graph);
  const auto base = base_solid(graph);
  return base ? template_hexahedra(base->kind, base->sides) : hexahedra_estimate(graph);
}

int HexahedraCount::remembered() const {
  return static_cast<int>(memory_->known.size());
}

}  // namespace isopatch::segmentation

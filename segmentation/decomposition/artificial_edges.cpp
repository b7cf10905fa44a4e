#include "segmentation/decomposition/artificial_edges.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"
#include "segmentation/decomposition/cutting/chord.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellId;

/// More would be needed by solids of many branches only, which are better cut in the CAD program.
constexpr int most_edges = 8;

/// Pairs of faces that share more than a vertex or an edge.
std::vector<std::pair<FaceId, FaceId>> conflicts(const CellGraph& graph) {
  std::vector<std::set<VertexId>> corners;
  for (const CellGraph::Corners& face : graph.faces) corners.emplace_back(face.begin(), face.end());
  const CellIncidence incidence(graph);
  std::set<std::pair<FaceId, FaceId>> neighbours;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    neighbours.insert(std::minmax(incidence.left(EdgeId(e)), incidence.right(EdgeId(e))));
  std::vector<std::pair<FaceId, FaceId>> result;
  for (int f = 0; f < static_cast<int>(corners.size()); ++f)
    for (int g = f + 1; g < static_cast<int>(corners.size()); ++g) {
      const auto& one = corners[static_cast<std::size_t>(f)];
      const auto common = std::count_if(one.begin(), one.end(), [&](VertexId v) {
        return corners[static_cast<std::size_t>(g)].contains(v);
      });
      const std::pair<FaceId, FaceId> pair(f, g);
      if (common > (neighbours.contains(pair) ? 2 : 1)) result.push_back(pair);
    }
  return result;
}

struct Candidate {
  CellComplex complex;
  std::size_t conflicts;
  double length;
};

/// The edge across one side that leaves the fewest conflicts, the shortest of those.
class EdgeChoice {
 public:
  EdgeChoice(const Brep& source, const CellComplex& complex) : source_(source), complex_(complex) {}

  std::optional<Candidate> best() {
    const CellSides sides = cell_sides(CellShapes(source_, complex_), CellId(0));
    const auto pairs = conflicts(sides.graph);
    std::set<FaceId> involved;
    for (const auto& [one, other] : pairs) involved.insert({one, other});
    for (const FaceId face : involved) try_face(sides, face);
    if (best_ && best_->conflicts < pairs.size()) return std::move(best_);
    return std::nullopt;
  }

 private:
  void try_face(const CellSides& sides, FaceId id) {
    const auto& side = sides.faces[static_cast<std::size_t>(id.value)];
    if (side.size() != 1 || !CellShapes(source_, complex_).is_plane(complex_.face(side.front().face).surface))
      return;
    const CellGraph::Corners& corners = sides.graph.face(id);
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = i + 2; j < corners.size() && !(i == 0 && j + 1 == corners.size()); ++j)
        try_edge(side.front().face, sides.vertices[static_cast<std::size_t>(corners[i].value)],
                 sides.vertices[static_cast<std::size_t>(corners[j].value)]);
  }

  void try_edge(FaceId face, VertexId from, VertexId to) {
    const double length = (complex_.vertex(from) - complex_.vertex(to)).norm();
    Candidate candidate{complex_, 0, length};
    if (!add_chord(source_, candidate.complex, {face}, from, to, {1e-9 * source_.size()})) return;
    std::vector<geometry::CellFaceUse>& faces = candidate.complex.cells.front().faces;
    int most = 0;
    for (const geometry::CellFaceUse& use : faces) most = std::max(most, use.side);
    faces.back().side = most + 1;
    candidate.conflicts =
        conflicts(cell_sides(CellShapes(source_, candidate.complex), CellId(0)).graph).size();
    const auto rank = [](const Candidate& c) { return std::pair(c.conflicts, c.length); };
    if (!best_ || rank(candidate) < rank(*best_)) best_ = std::move(candidate);
  }

  const Brep& source_;
  const CellComplex& complex_;
  std::optional<Candidate> best_;
};

}  // namespace

std::optional<CellComplex> with_artificial_edges(const Brep& source, const CellComplex& complex) {
  CellComplex result = complex;
  for (int i = 0; i < most_edges; ++i) {
    if (is_three_connected(cell_sides(CellShapes(source, result), CellId(0)).graph)) return result;
    auto next = EdgeChoice(source, result).best();
    if (!next) return std::nullopt;
    result = std::move(next->complex);
  }
  return std::nullopt;
}

}  // namespace isopatch::segmentation

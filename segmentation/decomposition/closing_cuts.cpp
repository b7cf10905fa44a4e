#include "segmentation/decomposition/closing_cuts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/cutting/plane_section.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

class ClosingCell {
 public:
  ClosingCell(const CellShapes& shapes, CellId cell, const CellSides& sides, const CutOptions& options)
      : shapes_(shapes), complex_(shapes.complex()), cell_(cell), sides_(sides), options_(options) {}

  ClosingCuts through(const std::vector<Chord>& chords, int most) {
    result_.refusal = "no loop runs along them";
    const bool plane = is_polyhedral(shapes_, cell_);
    if (!plane || !options_.keep_plane)
      for (const Chord& chord : chords)
        if (chord.across && add_sheet(chord)) {
          if (!plane) return std::move(result_);
          break;
        }
    for (const Chord& chord : chords) {
      std::vector<PlacedLoop> loops;
      if (chord.across) loops = loops_through(chord, most);
      for (SpacedLoop& section : sections_through(chord))
        loops.push_back({std::move(section.loop), {}, std::move(section.places)});
      for (const PlacedLoop& loop : loops) add(loop, options_);
      if (!result_.cuts.empty()) break;
    }
    return std::move(result_);
  }

  ClosingCuts at_vertices() {
    const CellIncidence incidence(sides_.graph);
    for (int v = 0; v < sides_.graph.vertex_count; ++v) {
      const std::vector<EdgeId>& around = incidence.edges_at(VertexId(v));
      if (around.size() < 4) continue;
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 2; j < around.size() && !(i == 0 && j + 1 == around.size()); ++j)
          if (auto loop = section_through(VertexId(v), around[i], around[j]))
            add({std::move(loop->loop), {}, std::move(loop->places)}, options_);
    }
    return std::move(result_);
  }

 private:
  bool add(const PlacedLoop& loop, const CutOptions& options) {
    CutAttempt attempt = cut_cell(shapes_.source(), complex_, cell_, sides_, loop, options);
    if (attempt.cut)
      result_.cuts.push_back(std::move(*attempt.cut));
    else
      result_.refusal = attempt.refusal;
    return attempt.cut.has_value();
  }

  /// Cuts a hexahedron in two across four parallel edges; the ends of a chord say where on two of them.
  bool add_sheet(const Chord& chord) {
    const auto base = base_solid(sides_.graph);
    const auto from = place_of(complex_, sides_, chord.from), to = place_of(complex_, sides_, chord.to);
    if (!base || base->kind != BaseKind::hexahedron || !from || !to || !from->auxiliary() || !to->auxiliary())
      return false;
    const CellIncidence incidence(sides_.graph);
    PlacedLoop loop;
    EdgeId edge = from->edge;
    FaceId side(chord.side);
    do {
      const std::vector<EdgeId>& around = incidence.sides(side);
      const auto at =
          static_cast<std::size_t>(std::find(around.begin(), around.end(), edge) - around.begin());
      if (around.size() != 4 || at == 4) return false;
      loop.loop.places.push_back(LoopPlace::inside(edge));
      loop.loop.steps.push_back(LoopStep::across(side));
      loop.at.push_back(edge == from->edge ? chord.from : edge == to->edge ? chord.to : VertexId());
      edge = around[(at + 2) % 4];
      side = incidence.left(edge) == side ? incidence.right(edge) : incidence.left(edge);
    } while (edge != from->edge && loop.loop.length() < 5);
    if (loop.loop.length() != 4 || loop.loop.places[1].edge != to->edge) return false;
    CutOptions options = options_;
    options.keep_plane = false;
    return add(loop, options);
  }

  /// Plane sections through a chord: by the planes of the cuts that made it, and by one across its side.
  std::vector<SpacedLoop> sections_through(const Chord& chord) const {
    const Eigen::Vector3d middle = shapes_.point(chord.first, 0.5),
                          along = complex_.vertex(chord.to) - complex_.vertex(chord.from);
    std::set<FaceId> own;
    for (const CellFaceUse& use : sides_.faces[static_cast<std::size_t>(chord.side)]) own.insert(use.face);
    std::vector<SpacedLoop> result;
    const auto add = [&](const Eigen::Vector3d& normal) {
      if (auto loop = plane_section(shapes_, sides_, FaceId(chord.side), middle, along, normal, same_point()))
        result.push_back(std::move(*loop));
    };
    for (std::size_t f = 0; f < complex_.faces.size(); ++f) {
      const geometry::CellFace& face = complex_.faces[f];
      const auto* plane = std::get_if<geometry::PlaneSurface>(&complex_.surface(face.surface));
      if (plane == nullptr || own.contains(FaceId(static_cast<int>(f)))) continue;
      if (std::any_of(face.loop.begin(), face.loop.end(),
                      [&](const EdgeUse& use) { return use.edge == chord.first; }))
        add(plane->normal());
    }
    for (const Eigen::Vector3d& point : aims()) {
      const Eigen::Vector3d normal = along.cross(point - middle);
      if (normal.norm() > same_point() * along.norm()) add(normal);
    }
    const CellFaceUse side = sides_.faces[static_cast<std::size_t>(chord.side)].front();
    const EdgeId edge = complex_.face(side.face).loop.front().edge;
    add(along.cross(shapes_.normal(side.face, shapes_.domain_point(side.face, edge, 0.5))));
    return result;
  }

  /// Points away from a chord that a plane through it may be led through: vertices, and middles of undivided
  /// edges.
  std::vector<Eigen::Vector3d> aims() const {
    std::vector<Eigen::Vector3d> result;
    for (const VertexId vertex : sides_.vertices) result.push_back(complex_.vertex(vertex));
    for (const auto& chain : sides_.edges) {
      if (chain.size() == 1) result.push_back(shapes_.point(chain.front().edge, 0.5));
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        result.push_back(complex_.vertex(complex_.to(chain[i])));
    }
    return result;
  }

  std::vector<PlacedLoop> loops_through(const Chord& chord, int most) const {
    const auto start = place_of(complex_, sides_, chord.from), end = place_of(complex_, sides_, chord.to);
    if (!start || !end) return {};
    const LoopPlace from = *start, to = *end;
    std::vector<std::pair<double, PlacedLoop>> found;
    LoopOptions options{.max_length = 5, .max_loops = 20000, .may_be_split = {}};
    for (std::size_t e = 0; e < sides_.graph.edges.size(); ++e)
      options.may_be_split.emplace_back(static_cast<int>(e));
    for (CuttingLoop& loop : valid_loops(sides_.graph, options).loops) {
      const std::size_t n = loop.places.size();
      for (std::size_t k = 0; k < n; ++k) {
        const LoopPlace a = loop.places[k], b = loop.places[(k + 1) % n];
        if (!((a == from && b == to) || (a == to && b == from))) continue;
        if (loop.steps[k].face != FaceId(chord.side)) continue;
        PlacedLoop placed{loop, std::vector<VertexId>(n)};
        for (std::size_t i = 0; i < n; ++i) {
          if (loop.places[i] == from && from.auxiliary()) placed.at[i] = chord.from;
          if (loop.places[i] == to && to.auxiliary()) placed.at[i] = chord.to;
        }
        found.emplace_back(price(placed), std::move(placed));
        break;
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<PlacedLoop> result;
    for (auto& [price, loop] : found)
      if (static_cast<int>(result.size()) < most) result.push_back(std::move(loop));
    return result;
  }

  /// Few places, and those that are there already.
  double price(const PlacedLoop& loop) const {
    double sum = std::abs(double(loop.loop.places.size()) - 4);
    for (const LoopPlace& place : loop.loop.places)
      if (place.auxiliary())
        sum += sides_.edges[static_cast<std::size_t>(place.edge.value)].size() > 1 ? 0.1 : 0.5;
    for (const LoopStep& step : loop.loop.steps)
      if (step.auxiliary()) sum += std::abs(double(sides_.graph.face(step.face).size()) - 4) > 0 ? 0.4 : 0.1;
    return sum;
  }

  /// By the plane of two edges at a vertex.
  std::optional<SpacedLoop> section_through(VertexId vertex, EdgeId first, EdgeId second) const {
    const auto other_end = [&](EdgeId id) {
      const CellGraph::Edge& edge = sides_.graph.edge(id);
      const VertexId end = edge.start == vertex ? edge.end : edge.start;
      return complex_.vertex(sides_.vertices[static_cast<std::size_t>(end.value)]);
    };
    const Eigen::Vector3d at = complex_.vertex(sides_.vertices[static_cast<std::size_t>(vertex.value)]);
    const Eigen::Vector3d into = other_end(second) - at, normal = (other_end(first) - at).cross(into);
    return plane_section(shapes_, sides_, first, normal, into, same_point());
  }

  double same_point() const { return 1e-7 * shapes_.source().size(); }

  const CellShapes& shapes_;
  const CellComplex& complex_;
  CellId cell_;
  const CellSides& sides_;
  const CutOptions& options_;
  ClosingCuts result_;
};

}  // namespace

ClosingCuts closing_cuts(const CellShapes& shapes, CellId cell, const CellSides& sides,
                         const std::vector<Chord>& chords, const CutOptions& options, int most) {
  return ClosingCell(shapes, cell, sides, options).through(chords, most);
}

ClosingCuts cuts_at_vertices(const CellShapes& shapes, CellId cell, const CellSides& sides,
                             const CutOptions& options) {
  return ClosingCell(shapes, cell, sides, options).at_vertices();
}

}  // namespace isopatch::segmentation

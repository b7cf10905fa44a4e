#include "segmentation/decomposition/conforming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/loop_enumeration.hpp"
#include "segmentation/decomposition/cutting/plane_section.hpp"
#include "segmentation/decomposition/simple_cell.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

/// Edges inside a side, straight one after the other, from its outline to its outline or as far as they go.
struct Chord {
  int side = 0;  ///< by face of the graph
  VertexId from, to;
  EdgeId first;         ///< of them
  bool across = false;  ///< ends on the outline
};

/// Chords of a side by the edges inside it, those across it first.
std::vector<Chord> chords_of(const CellShapes& shapes, const CellSides& sides) {
  const CellComplex& complex = shapes.complex();
  std::vector<Chord> result;
  for (std::size_t s = 0; s < sides.faces.size(); ++s) {
    if (sides.faces[s].size() < 2) continue;
    std::map<EdgeId, int> uses;
    for (const CellFaceUse& face : sides.faces[s])
      for (const EdgeUse& use : complex.face(face.face).loop) ++uses[use.edge];
    std::set<VertexId> outline;
    std::map<VertexId, std::vector<EdgeUse>> inside;
    for (const auto& [edge, count] : uses) {
      const VertexId start = complex.edge(edge).start, end = complex.edge(edge).end;
      if (count == 1) {
        outline.insert({start, end});
        continue;
      }
      inside[start].push_back({edge, false});
      inside[end].push_back({edge, true});
    }
    const auto direction = [&](EdgeUse use, double t) -> Eigen::Vector3d {
      const Eigen::Vector3d d = shapes.tangent(use.edge, use.reversed ? 1 - t : t).normalized();
      return use.reversed ? Eigen::Vector3d(-d) : d;
    };
    for (const auto& [vertex, out] : inside) {
      if (!outline.contains(vertex)) continue;
      for (EdgeUse use : out) {
        const EdgeId first = use.edge;
        std::size_t steps = 0;
        while (!outline.contains(complex.to(use)) && ++steps < 100) {
          const auto& next = inside.at(complex.to(use));
          const auto ahead =
              std::max_element(next.begin(), next.end(), [&](const EdgeUse& a, const EdgeUse& b) {
                return direction(a, 0).dot(direction(use, 1)) < direction(b, 0).dot(direction(use, 1));
              });
          if (direction(*ahead, 0).dot(direction(use, 1)) < 1 - 1e-6) break;
          use = *ahead;
        }
        const bool across = outline.contains(complex.to(use));
        if (!across || vertex < complex.to(use))
          result.push_back({static_cast<int>(s), vertex, complex.to(use), first, across});
      }
    }
  }
  std::stable_partition(result.begin(), result.end(), [](const Chord& chord) { return chord.across; });
  return result;
}

class Conformer {
 public:
  Conformer(const Brep& source, CellComplex complex, const DecompositionOptions& options,
            DecompositionReport& report, const Progress& progress)
      : source_(source),
        complex_(std::move(complex)),
        options_(options),
        cut_options_(options.cut),
        report_(report),
        progress_(progress) {
    cut_options_.smallest_angle = Angle::degrees(1);
    cut_options_.shortest_edge /= 10;
  }

  CellComplex make() {
    progress_("letting parts meet side to side", 0);
    bool first = true;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t c = 0; c < complex_.cells.size(); ++c) {
        const CellId cell(static_cast<int>(c));
        CellSides sides = sides_of(cell);
        const std::vector<Chord> chords = chords_of(shapes(), sides);
        if (first) report_.t_joints += static_cast<int>(chords.size());
        if (!chords.empty())
          cut_along(cell, sides, chords);
        else if (!is_simple(sides.graph))
          cut_at_vertex(cell, sides);
        else
          continue;
        changed = true;
        first = false;
        if (static_cast<int>(complex_.cells.size()) > options_.max_cells)
          throw Error(
              ErrorCode::unsupported,
              fmt::format("more than {} cells would be needed for them to meet side to side; raise max_cells",
                          options_.max_cells));
      }
      first = false;
    }
    return std::move(complex_);
  }

 private:
  CellShapes shapes() const { return CellShapes(source_, complex_); }
  CellSides sides_of(CellId cell) const { return cell_sides(shapes(), cell, options_.cut.sides); }

  /// The place of a vertex on a cell's graph.
  static std::optional<LoopPlace> place_of(const CellComplex& complex, const CellSides& sides,
                                           VertexId vertex) {
    for (std::size_t v = 0; v < sides.vertices.size(); ++v)
      if (sides.vertices[v] == vertex) return LoopPlace::at(VertexId(static_cast<int>(v)));
    for (std::size_t e = 0; e < sides.edges.size(); ++e)
      for (const EdgeUse& use : sides.edges[e])
        if (complex.to(use) == vertex) return LoopPlace::inside(EdgeId(static_cast<int>(e)));
    return std::nullopt;
  }

  double same_point() const { return 1e-7 * source_.size(); }

  /// Cuts a cell through an edge that lies in one of its sides.
  void cut_along(CellId cell, const CellSides& sides, const std::vector<Chord>& chords) {
    refusal_ = "no loop runs along them";
    for (const Chord& chord : chords) {
      if (chord.across && cut_as_sheet(cell, sides, chord)) return;
    }
    for (const Chord& chord : chords) {
      std::vector<PlacedLoop> loops;
      if (chord.across) loops = loops_through(sides, chord);
      for (SpacedLoop& section : sections_through(sides, chord))
        loops.push_back({std::move(section.loop), {}, std::move(section.places)});
      if (cut_best(cell, loops)) return;
    }
    throw Error(ErrorCode::unsupported,
                fmt::format("cell {} cannot be cut along the edges that its neighbours put on its sides: {}",
                            cell.value, refusal_));
  }

  /// Cuts a hexahedron into two through four opposite edges, two of which the ends of a chord divide.
  bool cut_as_sheet(CellId cell, const CellSides& sides, const Chord& chord) {
    const auto base = base_solid(sides.graph);
    const auto from = place_of(complex_, sides, chord.from), to = place_of(complex_, sides, chord.to);
    if (!base || base->kind != BaseKind::hexahedron || !from || !to || !from->auxiliary() || !to->auxiliary())
      return false;
    const CellIncidence incidence(sides.graph);
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
    CutOptions options = cut_options_;
    options.keep_plane = false;
    CutAttempt attempt = cut_cell(source_, complex_, cell, sides, loop, options);
    if (!attempt.cut || !price_of(*attempt.cut)) return false;
    complex_ = std::move(attempt.cut->complex);
    ++report_.further_cuts;
    return true;
  }

  /// By the planes of the cuts that made the edge, and one across the side.
  std::vector<SpacedLoop> sections_through(const CellSides& sides, const Chord& chord) const {
    const Eigen::Vector3d middle = shapes().point(chord.first, 0.5),
                          along = complex_.vertex(chord.to) - complex_.vertex(chord.from);
    std::set<FaceId> own;
    for (const CellFaceUse& use : sides.faces[static_cast<std::size_t>(chord.side)]) own.insert(use.face);
    std::vector<SpacedLoop> result;
    const auto add = [&](const Eigen::Vector3d& normal) {
      if (auto loop = plane_section(shapes(), sides, FaceId(chord.side), middle, along, normal, same_point()))
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
    const CellFaceUse side = sides.faces[static_cast<std::size_t>(chord.side)].front();
    const EdgeId edge = complex_.face(side.face).loop.front().edge;
    add(along.cross(shapes().normal(side.face, shapes().domain_point(side.face, edge, 0.5))));
    return result;
  }

  /// Makes the cut of which the fewest hexahedra come.
  bool cut_best(CellId cell, const std::vector<PlacedLoop>& loops) {
    std::optional<CutCell> best;
    double least = 0;
    for (const PlacedLoop& loop : loops) {
      CellComplex complex = complex_;
      CellSides sides = cell_sides(CellShapes(source_, complex), cell, options_.cut.sides);
      CutAttempt attempt = cut_cell(source_, std::move(complex), cell, sides, loop, cut_options_);
      if (!attempt.cut) {
        refusal_ = attempt.refusal;
        continue;
      }
      const std::optional<double> pieces = price_of(*attempt.cut);
      if (!pieces) continue;
      const double price = *pieces + loop.loop.auxiliary_vertices();
      if (!best || price < least) least = price, best = std::move(attempt.cut);
      if (least <= 4) break;
    }
    if (!best) return false;
    complex_ = std::move(best->complex);
    ++report_.further_cuts;
    return true;
  }

  std::optional<double> price_of(const CutCell& cut) const {
    double sum = 0;
    try {
      for (const CellId piece : {cut.left, cut.right}) {
        const CellSides sides = cell_sides(CellShapes(source_, cut.complex), piece, options_.cut.sides);
        if (!is_three_connected(sides.graph)) return std::nullopt;
        sum += hexahedra_of(sides.graph);
      }
    } catch (const Error&) {
      return std::nullopt;
    }
    return sum;
  }

  std::vector<PlacedLoop> loops_through(const CellSides& sides, const Chord& chord) const {
    const auto start = place_of(complex_, sides, chord.from), end = place_of(complex_, sides, chord.to);
    if (!start || !end) return {};
    const LoopPlace from = *start, to = *end;
    std::vector<std::pair<double, PlacedLoop>> found;
    LoopOptions options{.max_length = 5, .max_loops = 20000, .may_be_split = {}};
    for (std::size_t e = 0; e < sides.graph.edges.size(); ++e)
      options.may_be_split.emplace_back(static_cast<int>(e));
    for (CuttingLoop& loop : valid_loops(sides.graph, options).loops) {
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
        found.emplace_back(price(sides, placed), std::move(placed));
        break;
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<PlacedLoop> result;
    for (auto& [price, loop] : found)
      if (result.size() < 12) result.push_back(std::move(loop));
    return result;
  }

  /// Few places, and those that are there already.
  static double price(const CellSides& sides, const PlacedLoop& loop) {
    double sum = std::abs(double(loop.loop.places.size()) - 4);
    for (const LoopPlace& place : loop.loop.places)
      if (place.auxiliary())
        sum += sides.edges[static_cast<std::size_t>(place.edge.value)].size() > 1 ? 0.1 : 0.5;
    for (const LoopStep& step : loop.loop.steps)
      if (step.auxiliary()) sum += std::abs(double(sides.graph.face(step.face).size()) - 4) > 0 ? 0.4 : 0.1;
    return sum;
  }

  /// Cuts a cell through a vertex with more than three edges.
  void cut_at_vertex(CellId cell, const CellSides& sides) {
    const CellIncidence incidence(sides.graph);
    std::vector<SpacedLoop> loops;
    for (int v = 0; v < sides.graph.vertex_count; ++v) {
      const std::vector<EdgeId>& around = incidence.edges_at(VertexId(v));
      if (around.size() < 4) continue;
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 2; j < around.size() && !(i == 0 && j + 1 == around.size()); ++j)
          if (auto loop = section_through(sides, VertexId(v), around[i], around[j]))
            loops.push_back(std::move(*loop));
    }
    std::vector<PlacedLoop> placed;
    for (SpacedLoop& loop : loops) placed.push_back({std::move(loop.loop), {}, std::move(loop.places)});
    if (!cut_best(cell, placed))
      throw Error(ErrorCode::unsupported,
                  fmt::format("cell {} cannot be cut where more than three of its edges meet: {}", cell.value,
                              refusal_));
  }

  /// By the plane of two edges at a vertex.
  std::optional<SpacedLoop> section_through(const CellSides& sides, VertexId vertex, EdgeId first,
                                            EdgeId second) const {
    const auto other_end = [&](EdgeId id) {
      const CellGraph::Edge& edge = sides.graph.edge(id);
      const VertexId end = edge.start == vertex ? edge.end : edge.start;
      return complex_.vertex(sides.vertices[static_cast<std::size_t>(end.value)]);
    };
    const Eigen::Vector3d at = complex_.vertex(sides.vertices[static_cast<std::size_t>(vertex.value)]);
    const Eigen::Vector3d into = other_end(second) - at, normal = (other_end(first) - at).cross(into);
    return plane_section(shapes(), sides, first, normal, into, same_point());
  }

  const Brep& source_;
  CellComplex complex_;
  const DecompositionOptions& options_;
  CutOptions cut_options_;  // others than those of the search: what must be cut must
  DecompositionReport& report_;
  const Progress& progress_;
  std::string refusal_;
};

}  // namespace

CellComplex conforming(const Brep& source, CellComplex complex, const DecompositionOptions& options,
                       DecompositionReport& report, const Progress& progress) {
  return Conformer(source, std::move(complex), options, report, progress).make();
}

}  // namespace isopatch::segmentation

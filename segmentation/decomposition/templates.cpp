#include "segmentation/decomposition/templates.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"
#include "segmentation/decomposition/cutting/cutting_surface.hpp"
#include "segmentation/decomposition/cutting/divide.hpp"
#include "segmentation/decomposition/divided_edges.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Cell;
using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

/// A side as it was before anything was divided: its corners, and its edges from each corner to the next.
struct OldFace {
  std::vector<VertexId> corners;
  std::vector<EdgeId> edges;
};

struct OldCell {
  std::vector<CellFaceUse> faces;
  std::set<VertexId> corners;
};

class Templates {
 public:
  Templates(const Brep& source, CellComplex complex, double tolerance)
      : source_(source), complex_(std::move(complex)), tolerance_(tolerance) {}

  CellComplex make() {
    const std::vector<CellSides> cells = base_cells();
    const DividedEdges divided(complex_, cells);
    remember();
    std::set<EdgeId> used;
    for (const auto& [id, face] : faces_) used.insert(face.edges.begin(), face.edges.end());
    for (const EdgeId edge : used)
      if (divided.contains(edge))
        middle_[edge] = divide_edge(complex_, edge, middle_parameter(edge), middle_point(edge));
    for (const auto& [id, face] : faces_) divide_face(id, face);
    std::vector<Cell> result;
    for (const OldCell& cell : cells_) divide_cell(cell, result);
    complex_.cells = std::move(result);
    return std::move(complex_);
  }

 private:
  CellShapes shapes() const { return CellShapes(source_, complex_); }

  std::vector<CellSides> base_cells() const {
    std::vector<CellSides> result;
    for (std::size_t c = 0; c < complex_.cells.size(); ++c) {
      result.push_back(cell_sides(shapes(), CellId(static_cast<int>(c))));
      const CellSides& sides = result.back();
      if (!simple_solid(sides.graph))
        throw Error(ErrorCode::unsupported,
                    fmt::format("more than three edges meet at a vertex of cell {}", c));
      const bool whole = std::all_of(sides.faces.begin(), sides.faces.end(),
                                     [](const auto& side) { return side.size() == 1; }) &&
                         std::all_of(sides.edges.begin(), sides.edges.end(),
                                     [](const auto& edge) { return edge.size() == 1; });
      if (!whole)
        throw Error(ErrorCode::unsupported, fmt::format("cell {} meets its neighbours in parts of sides", c));
    }
    return result;
  }

  void remember() {
    for (const Cell& cell : complex_.cells) {
      OldCell old;
      old.faces = cell.faces;
      for (const CellFaceUse& use : cell.faces) {
        OldFace& face = faces_[use.face];
        face = {};
        for (const EdgeUse& edge : complex_.face(use.face).loop) {
          face.corners.push_back(complex_.from(edge));
          face.edges.push_back(edge.edge);
          old.corners.insert(face.corners.back());
        }
      }
      cells_.push_back(std::move(old));
    }
    for (const geometry::CellEdge& edge : complex_.edges) ends_.emplace_back(edge.start, edge.end);
  }

  /// Of half the length; of half the angle of an arc, so that on a cylinder the middles of opposite edges lie
  /// on one ruling.
  double middle_parameter(EdgeId edge) const {
    if (shapes().is_arc(edge)) return shoulder(edge);
    constexpr int pieces = 64;
    std::vector<double> length = {0};
    for (int i = 1; i <= pieces; ++i)
      length.push_back(
          length.back() +
          (shapes().point(edge, double(i) / pieces) - shapes().point(edge, double(i - 1) / pieces)).norm());
    int i = 1;
    while (length[static_cast<std::size_t>(i)] < length.back() / 2) ++i;
    const double before = length[static_cast<std::size_t>(i) - 1],
                 after = length[static_cast<std::size_t>(i)];
    return (i - 1 + (length.back() / 2 - before) / (after - before)) / pieces;
  }
  /// Where an arc of a circle or an ellipse runs parallel to its chord.
  double shoulder(EdgeId edge) const {
    const Eigen::Vector3d start = shapes().point(edge, 0), chord = shapes().point(edge, 1) - start;
    Eigen::Vector3d up = shapes().point(edge, 0.5) - start;
    up -= chord * (chord.dot(up) / chord.squaredNorm());
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double t = (low + high) / 2;
      (shapes().tangent(edge, t).dot(up) > 0 ? low : high) = t;
    }
    return (low + high) / 2;
  }
  Eigen::Vector3d middle_point(EdgeId edge) const { return shapes().point(edge, middle_parameter(edge)); }

  bool is_divided(EdgeId edge) const { return middle_.contains(edge); }

  /// Corners that no divided edge separates belong to one part.
  static std::map<VertexId, VertexId> parts(const std::set<VertexId>& corners,
                                            const std::vector<std::pair<VertexId, VertexId>>& whole_edges) {
    std::vector<VertexId> list(corners.begin(), corners.end());
    const auto index = [&](VertexId v) {
      return static_cast<int>(std::lower_bound(list.begin(), list.end(), v) - list.begin());
    };
    UnionFind groups(static_cast<int>(list.size()));
    for (const auto& [a, b] : whole_edges) groups.unite(index(a), index(b));
    std::map<VertexId, VertexId> result;
    for (const VertexId v : list) result[v] = list[static_cast<std::size_t>(groups.find(index(v)))];
    return result;
  }

  void divide_face(FaceId id, const OldFace& face) {
    std::vector<EdgeId> split;
    for (const EdgeId edge : face.edges)
      if (is_divided(edge)) split.push_back(edge);
    if (split.size() == 2) {
      auto curve = auxiliary_curve(shapes(), id, middle_.at(split[0]), middle_.at(split[1]), tolerance_);
      if (!curve) curve = bent_curve(shapes(), id, middle_.at(split[0]), middle_.at(split[1]), tolerance_);
      if (!curve)
        throw Error(ErrorCode::unsupported, "the middles of a side's edges cannot be joined inside it");
      const EdgeId chord = segmentation::divide_face(complex_, id, middle_.at(split[0]), middle_.at(split[1]),
                                                     complex_.add_curve(curve->curve));
      chords_[id] = chord;
      const FaceId added = last_face();
      assign_part(id, face, id);
      assign_part(id, face, added);
    } else if (!split.empty()) {
      divide_by_star(id, face);
    } else {
      assign_part(id, face, id);
    }
  }

  FaceId last_face() const { return FaceId(static_cast<int>(complex_.faces.size()) - 1); }

  /// Remembers which old corners a part of a face has.
  void assign_part(FaceId whole, const OldFace& face, FaceId part) {
    for (const EdgeUse& use : complex_.face(part).loop)
      if (std::find(face.corners.begin(), face.corners.end(), complex_.from(use)) != face.corners.end())
        parts_[whole].push_back({complex_.from(use), part});
  }

  void divide_by_star(FaceId id, const OldFace& face) {
    const geometry::CellFace whole = complex_.face(id);
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    for (const EdgeUse& use : whole.loop)
      centre += shapes().domain_point(id, use.edge, use.reversed ? 1 : 0) / double(whole.loop.size());
    const VertexId middle = complex_.add_vertex(shapes().point(whole.surface, centre));
    centres_[id] = middle;
    // From the middle of each edge to the centre.
    std::map<VertexId, EdgeId> spokes;
    for (const EdgeId edge : face.edges) {
      const VertexId from = middle_.at(edge);
      const Eigen::Vector2d uv = domain_point(id, whole.loop, from);
      const EdgeId spoke =
          complex_.add_edge(curve_in_domain(shapes(), whole.surface, {uv, complex_.vertex(from)},
                                            {centre, complex_.vertex(middle)}, tolerance_),
                            from, middle);
      spokes[from] = spoke;
      spokes_[{id, edge}] = spoke;
    }
    std::vector<EdgeUse> loop = whole.loop;
    const auto first = std::find_if(loop.begin(), loop.end(),
                                    [&](const EdgeUse& use) { return spokes.contains(complex_.from(use)); });
    std::rotate(loop.begin(), first, loop.end());
    std::vector<FaceId> made;
    for (std::size_t i = 0; i < loop.size();) {
      geometry::CellFace part = whole;
      part.loop = {{spokes.at(complex_.from(loop[i])), true}};
      do part.loop.push_back(loop[i++]);
      while (!spokes.contains(complex_.to(part.loop.back())));
      part.loop.push_back({spokes.at(complex_.to(part.loop.back())), false});
      if (made.empty()) {
        complex_.faces[static_cast<std::size_t>(id.value)] = std::move(part);
        made.push_back(id);
      } else {
        made.push_back(complex_.add_face(std::move(part)));
      }
    }
    for (const FaceId part : made) assign_part(id, face, part);
  }

  Eigen::Vector2d domain_point(FaceId face, const std::vector<EdgeUse>& loop, VertexId vertex) const {
    for (const EdgeUse& use : loop)
      if (complex_.from(use) == vertex) return shapes().domain_point(face, use.edge, use.reversed ? 1 : 0);
    throw Error(ErrorCode::internal, "a vertex is not on the outline of its face");
  }

  /// A path of edges inside a cell, from the middle of one divided edge over chords to another, or to a
  /// centre.
  struct Inner {
    std::vector<EdgeUse> walk;
    VertexId below, above;   ///< old corners on both sides of it: the ends of one of its divided edges
    std::vector<EdgeId> of;  ///< the divided edges
  };

  EdgeUse use_from(EdgeId edge, VertexId from) const { return {edge, complex_.edge(edge).start != from}; }

  void divide_cell(const OldCell& cell, std::vector<Cell>& result) {
    std::set<EdgeId> edges;
    std::vector<VertexId> centres;
    for (const CellFaceUse& use : cell.faces) {
      edges.insert(faces_.at(use.face).edges.begin(), faces_.at(use.face).edges.end());
      if (const auto found = centres_.find(use.face); found != centres_.end())
        centres.push_back(found->second);
    }
    std::vector<std::pair<VertexId, VertexId>> whole_edges;
    for (const EdgeId edge : edges)
      if (!is_divided(edge)) whole_edges.push_back(ends_[static_cast<std::size_t>(edge.value)]);
    const std::map<VertexId, VertexId> part_of = parts(cell.corners, whole_edges);
    std::map<VertexId, Cell> made;
    for (const CellFaceUse& use : cell.faces)
      for (const auto& [corner, face] : parts_.at(use.face)) {
        const FaceId part = face;
        std::vector<CellFaceUse>& faces = made[part_of.at(corner)].faces;
        if (std::none_of(faces.begin(), faces.end(), [&](const auto& known) { return known.face == part; }))
          faces.push_back({part, use.reversed, static_cast<int>(faces.size())});
      }
    if (made.size() > 1) {
      const std::map<VertexId, EdgeId> to_inside = inner_edges(cell, centres);
      std::set<EdgeId> done;
      for (const EdgeId edge : edges)
        if (is_divided(edge) && !done.contains(edge))
          add_inner_face(cell, edge, to_inside, done, part_of, made);
    }
    for (auto& [corner, piece] : made) result.push_back(std::move(piece));
  }

  /// Edges inside the cell from the centres of its faces: to each other where there are two, else to the
  /// middle of the cell.
  std::map<VertexId, EdgeId> inner_edges(const OldCell& cell, const std::vector<VertexId>& centres) {
    std::map<VertexId, EdgeId> result;
    if (centres.size() == 2) {
      const EdgeId edge = complex_.add_straight_edge(centres[0], centres[1]);
      result = {{centres[0], edge}, {centres[1], edge}};
    } else if (!centres.empty()) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const VertexId corner : cell.corners)
        middle += complex_.vertex(corner) / double(cell.corners.size());
      const VertexId inside = complex_.add_vertex(middle);
      for (const VertexId centre : centres) result[centre] = complex_.add_straight_edge(centre, inside);
    }
    return result;
  }

  /// The face between the parts on both sides of a divided edge: around it over chords, up to centres, and
  /// through the inside.
  void add_inner_face(const OldCell& cell, EdgeId first, const std::map<VertexId, EdgeId>& to_inside,
                      std::set<EdgeId>& done, const std::map<VertexId, VertexId>& part_of,
                      std::map<VertexId, Cell>& made) {
    std::vector<FaceId> around;
    for (const CellFaceUse& use : cell.faces)
      if (const auto& of = faces_.at(use.face).edges; std::find(of.begin(), of.end(), first) != of.end())
        around.push_back(use.face);
    // Backwards over one of its faces, forwards over the other.
    std::vector<EdgeUse> walk = path(cell, first, around[0], done);
    std::reverse(walk.begin(), walk.end());
    for (EdgeUse& use : walk) use.reversed = !use.reversed;
    const VertexId start = walk.empty() ? middle_.at(first) : complex_.from(walk.front());
    if (walk.empty() || complex_.from(walk.front()) != middle_.at(first)) {
      const std::vector<EdgeUse> rest = path(cell, first, around[1], done);
      walk.insert(walk.end(), rest.begin(), rest.end());
      const VertexId end = complex_.to(walk.back());
      if (end != start) {
        walk.push_back(use_from(to_inside.at(end), end));
        if (complex_.to(walk.back()) != start) {
          EdgeUse back = use_from(to_inside.at(start), start);
          back.reversed = !back.reversed;
          walk.push_back(back);
        }
      }
    }
    StepWalk steps;
    for (const EdgeUse& use : walk) steps.push_back({use});
    const auto surface = cutting_surface(shapes(), steps, tolerance_, true);
    if (!surface)
      throw Error(ErrorCode::unsupported, "no surface is known through the middles of a cell's sides");
    const geometry::SurfaceId id = complex_.add_surface(surface->surface);
    for (std::size_t i = 0; i < surface->traces.size(); ++i)
      complex_.add_trace({walk[i].edge, false}, id, surface->traces[i]);
    complex_.faces.push_back({id, walk});
    const auto [start_corner, end_corner] = ends_[static_cast<std::size_t>(first.value)];
    for (const VertexId corner : {start_corner, end_corner}) add_to(made.at(part_of.at(corner)), last_face());
    done.insert(first);
  }

  /// From the middle of a divided edge across a face: its chord, and on from there, or to its centre.
  std::vector<EdgeUse> path(const OldCell& cell, EdgeId edge, FaceId face, std::set<EdgeId>& done) {
    std::vector<EdgeUse> walk;
    const EdgeId first = edge;
    for (;;) {
      done.insert(edge);
      if (const auto spoke = spokes_.find({face, edge}); spoke != spokes_.end()) {
        walk.push_back(use_from(spoke->second, middle_.at(edge)));
        return walk;
      }
      walk.push_back(use_from(chords_.at(face), middle_.at(edge)));
      const VertexId at = complex_.to(walk.back());
      for (const EdgeId other : faces_.at(face).edges)
        if (is_divided(other) && middle_.at(other) == at) edge = other;
      if (edge == first) return walk;
      for (const CellFaceUse& use : cell.faces) {
        const auto& of = faces_.at(use.face).edges;
        if (use.face != face && std::find(of.begin(), of.end(), edge) != of.end()) {
          face = use.face;
          break;
        }
      }
    }
  }

  /// Adds a face to a piece so that it walks an edge against the face that has it already.
  void add_to(Cell& piece, FaceId added) {
    const std::vector<EdgeUse>& loop = complex_.face(added).loop;
    for (const CellFaceUse& use : piece.faces)
      for (const EdgeUse& known : complex_.face(use.face).loop)
        for (const EdgeUse& here : loop)
          if (known.edge == here.edge) {
            const bool outside = known.reversed != use.reversed;
            piece.faces.push_back({added, here.reversed == outside, static_cast<int>(piece.faces.size())});
            return;
          }
    throw Error(ErrorCode::internal, "a face inside a cell meets none of its sides");
  }

  const Brep& source_;
  CellComplex complex_;
  double tolerance_;
  std::map<FaceId, OldFace> faces_;
  std::vector<OldCell> cells_;
  std::vector<std::pair<VertexId, VertexId>> ends_;     // of the old edges
  std::map<EdgeId, VertexId> middle_;                   // of divided edges
  std::map<FaceId, VertexId> centres_;                  // of faces divided by stars
  std::map<FaceId, EdgeId> chords_;                     // of faces divided in two
  std::map<std::pair<FaceId, EdgeId>, EdgeId> spokes_;  // from the middle of an edge to the centre of a face
  std::map<FaceId, std::vector<std::pair<VertexId, FaceId>>>
      parts_;  // of each old face: old corner, the part that has it
};

}  // namespace

CellComplex hexahedral(const Brep& source, CellComplex complex, double tolerance) {
  return Templates(source, std::move(complex), tolerance).make();
}

}  // namespace isopatch::segmentation

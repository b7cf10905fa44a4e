#include "segmentation/decomposition/whole_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellFace;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

/// Makes whole edges and sides once each, so that cells which need the same one share it.
class WholeSides {
 public:
  WholeSides(const Brep& source, CellComplex& complex) : source_(source), complex_(complex) {}

  CellFaceUse side(const std::vector<CellFaceUse>& faces, const std::set<VertexId>& corners) {
    const CellFaceUse first =
        *std::min_element(faces.begin(), faces.end(),
                          [](const CellFaceUse& a, const CellFaceUse& b) { return a.face < b.face; });
    const std::vector<EdgeUse> loop = merged(outline(faces, first.reversed), corners);
    if (faces.size() == 1 && loop.size() == complex_.face(first.face).loop.size()) return first;
    std::set<EdgeId> edges;
    for (const EdgeUse& use : loop) edges.insert(use.edge);
    const auto [known, fresh] = faces_.try_emplace({first.face, edges});
    if (fresh) {
      CellFace whole = common_face(faces, first);
      whole.loop = loop;
      known->second = FaceId(static_cast<int>(complex_.faces.size()));
      complex_.faces.push_back(std::move(whole));
    }
    return {known->second, first.reversed, first.side};
  }

 private:
  /// Without an outline: what all parts have in common. Parts of one plane may have come of several cuts; of
  /// several faces of the solid it is the first, as where neighbouring faces in one plane are made one.
  CellFace common_face(const std::vector<CellFaceUse>& faces, const CellFaceUse& first) {
    CellFace whole = complex_.face(first.face);
    bool one_surface = true, one_origin = true;
    for (const CellFaceUse& use : faces) {
      const CellFace& part = complex_.face(use.face);
      one_surface = one_surface && part.surface == whole.surface;
      if (part.origin != complex_.face(first.face).origin) one_origin = false;
      if (part.origin && (!whole.origin || *part.origin < *whole.origin)) whole.origin = part.origin;
    }
    if (one_surface && one_origin) return whole;
    whole.surface = plane_of(faces, first.face);
    return whole;
  }

  /// @throws Error unsupported  faces that do not lie in one plane
  geometry::SurfaceId plane_of(const std::vector<CellFaceUse>& faces, FaceId first) {
    const CellShapes shapes(source_, complex_);
    const EdgeUse edge = complex_.face(first).loop.front();
    const Eigen::Vector3d normal = shapes.normal(first, shapes.domain_point(first, edge.edge, 0.5));
    const Eigen::Vector3d at = complex_.vertex(complex_.from(edge));
    for (const CellFaceUse& use : faces)
      for (const EdgeUse& here : complex_.face(use.face).loop)
        if (!shapes.is_plane(complex_.face(use.face).surface) ||
            std::abs(normal.dot(complex_.vertex(complex_.from(here)) - at)) > 1e-7 * source_.size())
          throw Error(ErrorCode::unsupported,
                      "a side that meets others in parts lies on several surfaces, which are no planes");
    const Eigen::Vector3d x = normal.unitOrthogonal();
    return complex_.add_surface(geometry::PlaneSurface{at, x, normal.cross(x)});
  }

  /// The outline of some faces, to the left of which they lie, seen from the front of one with `reversed`.
  std::vector<EdgeUse> outline(const std::vector<CellFaceUse>& faces, bool reversed) const {
    std::map<EdgeId, std::vector<EdgeUse>> uses;
    for (const CellFaceUse& face : faces)
      for (EdgeUse use : complex_.face(face.face).loop) {
        use.reversed = use.reversed != (face.reversed != reversed);
        uses[use.edge].push_back(use);
      }
    std::map<VertexId, EdgeUse> next;
    for (const auto& [edge, found] : uses)
      if (found.size() == 1) next.emplace(complex_.from(found[0]), found[0]);
    std::vector<EdgeUse> loop = {next.begin()->second};
    while (complex_.to(loop.back()) != complex_.from(loop.front())) {
      const auto on = next.find(complex_.to(loop.back()));
      if (on == next.end() || loop.size() > next.size())
        throw Error(ErrorCode::internal, "the outline of a side is not closed");
      loop.push_back(on->second);
    }
    return loop;
  }

  /// With one edge from each corner to the next.
  std::vector<EdgeUse> merged(std::vector<EdgeUse> loop, const std::set<VertexId>& corners) {
    const auto start = std::find_if(loop.begin(), loop.end(),
                                    [&](const EdgeUse& use) { return corners.contains(complex_.from(use)); });
    std::rotate(loop.begin(), start, loop.end());
    std::vector<EdgeUse> result;
    for (std::size_t i = 0; i < loop.size();) {
      std::vector<EdgeUse> chain = {loop[i++]};
      while (i < loop.size() && !corners.contains(complex_.from(loop[i]))) chain.push_back(loop[i++]);
      result.push_back(whole_edge(chain));
    }
    return result;
  }

  EdgeUse whole_edge(const std::vector<EdgeUse>& chain) {
    if (chain.size() == 1) return chain.front();
    const VertexId from = complex_.from(chain.front()), to = complex_.to(chain.back());
    std::set<EdgeId> pieces;
    for (const EdgeUse& use : chain) pieces.insert(use.edge);
    const auto [known, fresh] = edges_.try_emplace(pieces);
    if (fresh) {
      const geometry::CellEdge edge = joined(chain);
      known->second = EdgeId(static_cast<int>(complex_.edges.size()));
      complex_.edges.push_back(edge);
    }
    const EdgeUse use{known->second, complex_.edge(known->second).start != from};
    if (complex_.to(use) != to) throw Error(ErrorCode::internal, "the pieces of an edge do not follow");
    return use;
  }

  geometry::CellEdge joined(const std::vector<EdgeUse>& chain) {
    geometry::CellEdge edge = complex_.edge(chain.front().edge);
    const bool one_curve = std::all_of(chain.begin(), chain.end(), [&](const EdgeUse& use) {
      return complex_.edge(use.edge).curve == edge.curve && use.reversed == chain.front().reversed;
    });
    if (!one_curve) return straight(chain);
    for (const EdgeUse& use : chain) {
      const geometry::CellEdge& piece = complex_.edge(use.edge);
      if (piece.low < edge.low) edge.low = piece.low, edge.start = piece.start;
      if (piece.high > edge.high) edge.high = piece.high, edge.end = piece.end;
    }
    return edge;
  }

  geometry::CellEdge straight(const std::vector<EdgeUse>& chain) {
    const CellShapes shapes(source_, complex_);
    const Eigen::Vector3d from = complex_.vertex(complex_.from(chain.front())),
                          to = complex_.vertex(complex_.to(chain.back())), along = (to - from).normalized();
    for (const EdgeUse& use : chain) {
      const Eigen::Vector3d d = shapes.tangent(use.edge, 0.5).normalized();
      if (!shapes.is_straight(use.edge) || along.cross(d).norm() > 1e-7)
        throw Error(ErrorCode::unsupported, "an edge of a side that meets others in parts is several curves");
    }
    return {complex_.add_curve({geometry::segment(from, to)}), 0, 1, complex_.from(chain.front()),
            complex_.to(chain.back())};
  }

  const Brep& source_;
  CellComplex& complex_;
  std::map<std::set<EdgeId>, EdgeId> edges_;                     // by pieces
  std::map<std::pair<FaceId, std::set<EdgeId>>, FaceId> faces_;  // by the first part and the outline
};

}  // namespace

void make_sides_whole(const Brep& source, CellComplex& complex, const std::vector<CellId>& cells,
                      const SideOptions& options) {
  WholeSides whole(source, complex);
  for (const CellId cell : cells) {
    const CellSides sides = cell_sides(CellShapes(source, complex), cell, options);
    const std::set<VertexId> corners(sides.vertices.begin(), sides.vertices.end());
    std::vector<CellFaceUse> faces;
    for (const auto& side : sides.faces) faces.push_back(whole.side(side, corners));
    complex.cells[static_cast<std::size_t>(cell.value)].faces = std::move(faces);
  }
}

}  // namespace isopatch::segmentation

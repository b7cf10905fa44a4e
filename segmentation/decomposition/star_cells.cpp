#include "segmentation/decomposition/star_cells.hpp"

#include <Eigen/Geometry>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Cell;
using geometry::CellComplex;
using geometry::CellFace;
using geometry::CellFaceUse;
using geometry::CellId;
using geometry::EdgeUse;

class StarMaker {
 public:
  StarMaker(const Brep& source, CellComplex complex, const std::vector<Eigen::Vector3d>& centres)
      : source_(source), complex_(std::move(complex)), centres_(centres) {}

  CellComplex make() {
    const std::vector<Cell> cells = complex_.cells;
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (!is_polyhedral(CellShapes(source_, complex_), CellId(static_cast<int>(c))))
        throw Error(ErrorCode::unsupported, "a cell with curved sides cannot be divided into tetrahedra");
    std::vector<Cell> result;
    for (std::size_t c = 0; c < cells.size(); ++c) divide(cells[c], c, result);
    complex_.cells = std::move(result);
    return std::move(complex_);
  }

 private:
  EdgeUse edge_between(VertexId from, VertexId to) {
    const auto [found, fresh] =
        edges_.try_emplace(std::minmax(from, to), EdgeId(static_cast<int>(complex_.edges.size())));
    if (fresh) complex_.add_straight_edge(from, to);
    return {found->second, complex_.edge(found->second).start != from};
  }

  /// The triangle between an edge and a point; made when it is first asked for, so that its front is to the
  /// left of that walk.
  /// @return  as a cell uses it that walks the edge against its use, or along it
  CellFaceUse triangle(EdgeUse base, VertexId apex, int side) {
    const auto [found, fresh] =
        triangles_.try_emplace({base.edge, apex}, FaceId(static_cast<int>(complex_.faces.size())));
    if (fresh) {
      const VertexId from = complex_.from(base), to = complex_.to(base);
      const EdgeUse up = edge_between(to, apex), down = edge_between(apex, from);
      const Eigen::Vector3d a = complex_.vertex(from), b = complex_.vertex(to), c = complex_.vertex(apex);
      geometry::PlaneSurface plane;
      plane.origin = a;
      plane.x = (b - a).normalized();
      plane.y = (b - a).cross(c - a).normalized().cross(plane.x);
      complex_.add_face({complex_.add_surface(plane), {base, up, down}});
    }
    const EdgeUse first = complex_.face(found->second).loop.front();
    return {found->second, first.reversed != base.reversed, side};
  }

  /// The parts of a face around its middle, by edge of its outline.
  const std::map<EdgeId, FaceId>& parts(FaceId id) {
    const auto [found, fresh] = parts_.try_emplace(id);
    if (!fresh) return found->second;
    const CellFace whole = complex_.face(id);
    if (whole.loop.size() == 3) return found->second;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const EdgeUse& use : whole.loop)
      middle += complex_.vertex(complex_.from(use)) / double(whole.loop.size());
    const VertexId centre = complex_.add_vertex(middle);
    for (const EdgeUse& use : whole.loop) {
      CellFace part = whole;
      part.loop = {use, edge_between(complex_.to(use), centre), edge_between(centre, complex_.from(use))};
      found->second[use.edge] = complex_.add_face(std::move(part));
    }
    return found->second;
  }

  void divide(const Cell& cell, std::size_t number, std::vector<Cell>& result) {
    std::set<VertexId> corners;
    for (const CellFaceUse& use : cell.faces)
      for (const EdgeUse& edge : complex_.face(use.face).loop) corners.insert(complex_.from(edge));
    if (corners.size() == 4 && cell.faces.size() == 4) {
      result.push_back(cell);
      return;
    }
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const VertexId corner : corners) middle += complex_.vertex(corner) / double(corners.size());
    const VertexId apex = complex_.add_vertex(centres_.empty() ? middle : centres_[number]);
    for (const CellFaceUse& use : cell.faces) {
      const std::map<EdgeId, FaceId> pieces = parts(use.face);
      if (pieces.empty()) {
        result.push_back(tetrahedron({use.face, use.reversed, 0}, apex));
        continue;
      }
      for (const auto& [edge, part] : pieces) result.push_back(tetrahedron({part, use.reversed, 0}, apex));
    }
  }

  Cell tetrahedron(CellFaceUse base, VertexId apex) {
    Cell cell;
    cell.faces = {base};
    const std::vector<EdgeUse> loop = complex_.face(base.face).loop;
    for (const EdgeUse& use : loop) {
      // The other faces walk the base's edges against it, seen from outside.
      const EdgeUse against{use.edge, use.reversed == base.reversed};
      cell.faces.push_back(triangle(against, apex, static_cast<int>(cell.faces.size())));
    }
    return cell;
  }

  const Brep& source_;
  CellComplex complex_;
  const std::vector<Eigen::Vector3d>& centres_;
  std::map<std::pair<VertexId, VertexId>, EdgeId> edges_;
  std::map<std::pair<EdgeId, VertexId>, FaceId> triangles_;
  std::map<FaceId, std::map<EdgeId, FaceId>> parts_;
};

}  // namespace

CellComplex star_cells(const Brep& source, CellComplex complex, const std::vector<Eigen::Vector3d>& centres) {
  return StarMaker(source, std::move(complex), centres).make();
}

}  // namespace isopatch::segmentation

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/problem/internal/cut_quadrature.hpp"
#include "iga/problem/region.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {

/// A quadrature point of one face of a patch.
struct FacePoint {
  Eigen::Vector3d place;   ///< m
  Eigen::Vector3d normal;  ///< outward, of length 1
  double area = 0;         ///< its weight, m^2
};

/// The rule by which loads on one face of a patch, or on the part of it that lies in a region, are
/// integrated: degree + 6 Gauss points per element and direction, so that a force spread over a rational face
/// adds up to itself; in elements that the rim of a region cuts, so many in each of the cells of `cut_rule`.
class FaceQuadrature {
 public:
  FaceQuadrature(const geometry::NurbsVolume& patch, geometry::Side side, const Region& region = {});

  const geometry::NurbsSurface& surface() const { return surface_; }
  /// Calls visit(point, u, qu, v, qv) for every point that has an area; u and v are the elements along the
  /// face's two directions, qu and qv the point's places in them.
  template <class Visit>
  void for_each(Visit visit) const {
    std::size_t element = 0;
    for (const DirectionTable::Element& v : tables_[1].elements)
      for (const DirectionTable::Element& u : tables_[0].elements) {
        const CutRule::Kind kind = cuts_.empty() ? CutRule::Kind::inside : cuts_[element].kind;
        if (kind == CutRule::Kind::inside) {
          for (Eigen::Index qv = 0; qv < v.nodes.size(); ++qv)
            for (Eigen::Index qu = 0; qu < u.nodes.size(); ++qu) {
              const FacePoint point = at(u.nodes[qu], v.nodes[qv], u.weights[qu] * v.weights[qv]);
              if (point.area > 0) visit(point, u, qu, v, qv);  // a collapsed edge carries nothing
            }
        } else if (kind == CutRule::Kind::cut) {
          for (const CutPoint& cut : cuts_[element].points) {
            const FacePoint point = at(cut.parameter[0], cut.parameter[1], cut.weight);
            if (point.area > 0)
              visit(point, single(0, cut.parameter[0]), Eigen::Index{0}, single(1, cut.parameter[1]),
                    Eigen::Index{0});
          }
        }
        ++element;
      }
  }

 private:
  FacePoint at(double u, double v, double weight) const;
  // The functions of one direction at one place.
  DirectionTable::Element single(int direction, double parameter) const;

  geometry::NurbsSurface surface_;
  double outward_;
  std::array<DirectionTable, 2> tables_;
  std::vector<CutRule> cuts_;  // of each element, where there is a region
};

/// How far outside of a region what touches it may lie and count as inside, m: faces of CAD files are where
/// they should be to about a ten-millionth of a patch.
double place_slack(const geometry::NurbsVolume& patch);

/// All points of some faces, or of the part of them in a region.
std::vector<FacePoint> face_points(const std::vector<geometry::NurbsVolume>& patches,
                                   const std::vector<geometry::PatchFace>& faces, const Region& region = {});

}  // namespace isopatch::iga

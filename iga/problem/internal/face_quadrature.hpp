#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {

/// A quadrature point of one face of a patch.
struct FacePoint {
  Eigen::Vector3d place;   ///< m
  Eigen::Vector3d normal;  ///< outward, of length 1
  double area = 0;         ///< its weight, m^2
};

/// The rule by which loads on one face of a patch are integrated: degree + 6 Gauss points per element and
/// direction, so that a force spread over a rational face adds up to itself.
class FaceQuadrature {
 public:
  FaceQuadrature(const geometry::NurbsVolume& patch, geometry::Side side);

  const geometry::NurbsSurface& surface() const { return surface_; }
  /// Calls visit(point, u, qu, v, qv) for every point that has an area; u and v are the elements along the
  /// face's two directions, qu and qv the point's places in them.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const DirectionTable::Element& v : tables_[1].elements)
      for (const DirectionTable::Element& u : tables_[0].elements)
        for (Eigen::Index qv = 0; qv < v.nodes.size(); ++qv)
          for (Eigen::Index qu = 0; qu < u.nodes.size(); ++qu) {
            const FacePoint point = at(u.nodes[qu], v.nodes[qv], u.weights[qu] * v.weights[qv]);
            if (point.area > 0) visit(point, u, qu, v, qv);  // a collapsed edge carries nothing
          }
  }

 private:
  FacePoint at(double u, double v, double weight) const;

  geometry::NurbsSurface surface_;
  double outward_;
  std::array<DirectionTable, 2> tables_;
};

/// All points of some faces.
std::vector<FacePoint> face_points(const std::vector<geometry::NurbsVolume>& patches,
                                   const std::vector<geometry::PatchFace>& faces);

}  // namespace isopatch::iga

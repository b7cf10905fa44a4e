#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

/// What is wrong with a solid, and where: what a picture of it marks.
struct SolidFault {
  struct Face {
    int number = 0;           ///< in its solid, from 0
    std::string solid = {};   ///< "" where there is only one
    std::string remark = {};  ///< "5 corners"
  };
  struct Edge {
    std::string name;         ///< "edge 3"
    Eigen::Matrix3Xd points;  ///< along it, m; two at least
  };
  struct Point {
    std::string name;       ///< "vertex 5"
    Eigen::Vector3d point;  ///< m
  };
  std::vector<Face> faces = {};
  std::vector<Edge> edges = {};
  std::vector<Point> points = {};
};

/// The same, its faces without a solid's name being those of `solid`.
SolidFault of_solid(SolidFault fault, const std::string& solid);

/// An error of which is known where on the solid it lies.
class SolidError : public Error {
 public:
  SolidError(ErrorCode code, const std::string& message, SolidFault fault)
      : Error(code, message), fault_(std::move(fault)) {}
  const SolidFault& fault() const { return fault_; }

 private:
  SolidFault fault_;
};

}  // namespace isopatch::geometry

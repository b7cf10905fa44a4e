#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/profiles/profile.hpp"

namespace isopatch::segmentation::planar {

/// A profile's edge as a smooth curve through its points: cubic pieces with derivatives of fourth order.
class Curve {
 public:
  explicit Curve(const ProfileEdge& edge);

  /// At a parameter in [0, 1]; a closed curve goes on beyond.
  Eigen::Vector2d at(double parameter) const;
  Eigen::Vector2d derivative(double parameter) const;

  bool straight() const { return points_.size() == 2; }
  bool closed() const { return closed_; }  ///< without a vertex
  double length() const { return length_; }
  double turning() const { return turning_; }  ///< radians, all bends taken positive
  /// The parameter within [low, high] at which the curve comes nearest to a point.
  double nearest(const Eigen::Vector2d& point, double low, double high) const;

 private:
  struct Place {
    int piece;
    double at;
  };
  Place place(double parameter) const;

  bool closed_;
  std::vector<Eigen::Vector2d> points_, derivatives_;  // over one step of the parameter
  double length_ = 0, turning_ = 0;
};

std::vector<Curve> curves_of(const Profile& profile);

}  // namespace isopatch::segmentation::planar

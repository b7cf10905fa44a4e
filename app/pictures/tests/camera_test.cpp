#include "app/pictures/camera.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

TEST(Camera, NamedViewsAreRightHandedAndUpright) {
  for (const std::string& name : view_names()) {
    const View view = *named_view(name);
    EXPECT_TRUE(view.right.cross(view.up).isApprox(view.toward_eye)) << name;
    EXPECT_NEAR(view.up.norm(), 1, 1e-12);
    EXPECT_GE(view.up.z(), -1e-12) << name;
  }
  EXPECT_TRUE(named_view("front")->right.isApprox(Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(named_view("top")->up.isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_FALSE(named_view("frnt").has_value());
}

TEST(Camera, AViewNeedsADirectionAndAnUpBesideIt) {
  EXPECT_ERROR(view_from({0, 0, 0}, std::nullopt), ErrorCode::invalid_argument, "needs a direction");
  EXPECT_ERROR(view_from({0, 2, 0}, Eigen::Vector3d(0, -1, 0)), ErrorCode::invalid_argument,
               "must not lie along the view");
  EXPECT_TRUE(view_from({0, 2, 0}, Eigen::Vector3d(3, 1, 0)).up.isApprox(Eigen::Vector3d::UnitX()));
}

TEST(Camera, FitsThePartIntoItsBoxAndTouchesIt) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, 50);
  points.row(0) *= 3;
  points.colwise() += Eigen::Vector3d(7, -2, 5);
  const Layout places = layout({1600, 1200}, {});
  for (const std::string& name : view_names()) {
    const Camera camera = fitted(*named_view(name), points, places, 1);
    const double pixels = 1200 / camera.height;
    const Eigen::Matrix3Xd from_focus = points.colwise() - camera.focus;
    const Eigen::VectorXd x = (pixels * camera.view.right.transpose() * from_focus).array() + 800;
    const Eigen::VectorXd y = (pixels * camera.view.up.transpose() * from_focus).array() + 600;
    EXPECT_GE(x.minCoeff<Eigen::PropagateNaN>(), places.part.left - 1e-9);
    EXPECT_LE(x.maxCoeff<Eigen::PropagateNaN>(), places.part.right + 1e-9);
    EXPECT_GE(y.minCoeff<Eigen::PropagateNaN>(), places.part.bottom - 1e-9);
    EXPECT_LE(y.maxCoeff<Eigen::PropagateNaN>(), places.part.top + 1e-9);
    const double spare = std::min(x.minCoeff<Eigen::PropagateNaN>() - places.part.left,
                                  y.minCoeff<Eigen::PropagateNaN>() - places.part.bottom);
    EXPECT_NEAR(spare, 0, 1e-9) << name;
  }
}

}  // namespace
}  // namespace isopatch::app

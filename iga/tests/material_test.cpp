#include "iga/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::iga {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Material, KeepsItsModuli) {
  for (const double ratio : {-0.9, -0.2, 0.0, 0.3, 0.4999}) {
    const Material material = isotropic(210e9, ratio);
    // Near 0.5 the ratio is a difference of lambda and lambda + 2 mu: five digits of sixteen go.
    EXPECT_NEAR(young(material) / 210e9, 1, 1e-11) << ratio;
    EXPECT_NEAR(poisson(material), ratio, 1e-11);
  }
}

TEST(Material, PulledBarHasYoungsModulusTimesItsStrainAndNoOtherStress) {
  const Material material = isotropic(70e9, 0.33);
  const double strain = 1e-3;
  const Eigen::Matrix3d found =
      stress(Eigen::Vector3d(strain, -0.33 * strain, -0.33 * strain).asDiagonal(), material);
  EXPECT_NEAR(found(0, 0), 70e6, 1e-6);  // round-off of the sum of three terms of that size
  EXPECT_LT((found - Eigen::Matrix3d(Eigen::Vector3d(found(0, 0), 0, 0).asDiagonal())).norm(), 1e-6);
}

TEST(Material, ShearedBlockHasTwiceTheShearModulusTimesItsStrain) {
  const Material material = isotropic(70e9, 0.33);
  Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
  strain(0, 1) = strain(1, 0) = 1e-3;
  EXPECT_NEAR(stress(strain, material)(0, 1), 2 * 70e9 / (2 * 1.33) * 1e-3, 1e-6);
}

TEST(Material, ModuliThatNoSolidHasAreRefused) {
  for (const double value : {0.0, -1.0, infinity, std::nan("")})
    EXPECT_ERROR(isotropic(value, 0.3), ErrorCode::invalid_argument, "Young's modulus is");
  EXPECT_ERROR(isotropic(1, 0.5), ErrorCode::invalid_argument, "use a value up to 0.4999");
  for (const double value : {-1.0, 0.51, std::nan("")})
    EXPECT_ERROR(isotropic(1, value), ErrorCode::invalid_argument, "must lie between -1 and 0.5");
  EXPECT_ERROR(isotropic(1, 0.3, -7850, "steel"), ErrorCode::invalid_argument,
               "material 'steel': density is -7850 kg/m^3");
}

TEST(Material, LameParametersThatGainEnergyAreRefused) {
  const auto with = [](double lambda, double mu, double expansion = 0) {
    return Material{lambda, mu, 0, "odd", expansion};
  };
  EXPECT_ERROR(validate(with(1, 0)), ErrorCode::invalid_argument, "material 'odd': mu is 0 Pa");
  EXPECT_ERROR(validate(with(-0.7, 1)), ErrorCode::invalid_argument, "above -2/3 mu");
  EXPECT_ERROR(validate(with(infinity, 1)), ErrorCode::invalid_argument, "not finite");
  EXPECT_ERROR(validate(with(1, 1, std::nan(""))), ErrorCode::invalid_argument, "not finite");
  EXPECT_EQ(test::message_of([&] { validate(with(-0.6, 1)); }), "no error") << "it grows wider when pulled";
}

}  // namespace
}  // namespace isopatch::iga

#include "geometry/jacobian_certificate.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using namespace geometry;

std::vector<int> rejected(const MultiPatch& model) {
  std::vector<int> result;
  for (int p = 0; p < model.patch_count(); ++p) {
    const JacobianCertificate c = certify_jacobian(model.patch(PatchId(p)));
    EXPECT_NE(c.sign, JacobianSign::undecided) << "patch " << p;
    if (!c.accepted()) result.push_back(p);
  }
  return result;
}

TEST(JacobianCertificateOnModels, RejectsTwoCornersOfTerrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  const MultiPatch model = connect(reference_patches("terrific/terrific.xml"));
  EXPECT_EQ(rejected(model), (std::vector{5, 8}));
  // The parameters are those of the file: neither patch is turned around.
  const JacobianCertificate five = certify_jacobian(model.patch(PatchId(5)));
  EXPECT_EQ(five.parameter, Parameter<3>(0, 0, 0));
  EXPECT_NEAR(five.smallest, -7.6e-7, 0.05e-7);
  const JacobianCertificate eight = certify_jacobian(model.patch(PatchId(8)));
  EXPECT_EQ(eight.parameter, Parameter<3>(1, 0, 1));
  EXPECT_NEAR(eight.smallest, -1.4e-6, 0.05e-6);
  for (const int p : {5, 8}) EXPECT_GT(quality(model.patch(PatchId(p))).min_jacobian, 0);
}

TEST(JacobianCertificateOnModels, AcceptsTheFirstSegmentationAndRejectsTwoPatchesOfTheSecond) {
  ISOPATCH_NEEDS_DATA("terrific/terrificPart01_vol.xml");
  ISOPATCH_NEEDS_DATA("terrific/terrificPart02_vol.xml");
  const Tolerance loose{.same_point = 1e-5};
  EXPECT_TRUE(rejected(connect(reference_patches("terrific/terrificPart01_vol.xml"), loose)).empty());
  EXPECT_EQ(rejected(connect(reference_patches("terrific/terrificPart02_vol.xml"), loose)),
            (std::vector{8, 9}));
}

TEST(JacobianCertificateOnModels, AcceptsTheChairStandReoriented) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const PatchSet set = reference_patches("chair_stand/chair_stand.xml");
  EXPECT_TRUE(rejected(connect(set)).empty());
  for (const NurbsVolume& patch : set.patches)
    EXPECT_EQ(certify_jacobian(patch).sign, JacobianSign::negative);
}

}  // namespace
}  // namespace isopatch::verification

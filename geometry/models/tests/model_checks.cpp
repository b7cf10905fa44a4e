#include "geometry/models/tests/model_checks.hpp"

#include <gmock/gmock.h>

#include <map>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "geometry/splines/permute.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

NurbsSurface trace(const MultiPatch& model, const PatchFace& face) {
  return face_surface(model.patch(face.patch), face.side);
}

// The second side of an interface brought into the parameters of the first.
NurbsSurface second_as_first(const MultiPatch& model, const Interface& shared) {
  NurbsSurface surface = trace(model, shared.second);
  if (shared.orientation.flip_first) surface = reversed(surface, 0);
  if (shared.orientation.flip_second) surface = reversed(surface, 1);
  return shared.orientation.swapped ? permuted<2>(surface, {1, 0}) : surface;
}

void expect_conforming(const MultiPatch& model, const Interface& shared) {
  SCOPED_TRACE(model.label(shared.first) + " and " + model.label(shared.second));
  const NurbsSurface a = trace(model, shared.first);
  const NurbsSurface b = second_as_first(model, shared);
  ASSERT_EQ(a.sizes(), b.sizes());
  const double tolerance = 1e-14 * model.size();
  EXPECT_LE((a.control_points() - b.control_points()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), tolerance);
  const Eigen::ArrayXd ratio = a.weights().array() / b.weights().array();
  EXPECT_NEAR(ratio.maxCoeff<Eigen::PropagateNaN>() / ratio.minCoeff<Eigen::PropagateNaN>(), 1, 1e-14);
}

void expect_every_face_named_once(const MultiPatch& model) {
  std::map<PatchFace, int> count;
  for (const Boundary& boundary : model.boundaries())
    for (const PatchFace& face : boundary.faces) ++count[face];
  for (const PatchFace& face : model.boundary_faces()) EXPECT_EQ(count[face], 1) << model.label(face);
  EXPECT_EQ(count.size(), model.boundary_faces().size());
}

// All interfaces are stated, and are those that are found where none is.
void expect_interfaces_stated(PatchSet patches, const MultiPatch& model) {
  EXPECT_EQ(patches.interfaces.size(), model.interfaces().size());
  patches.interfaces.clear();
  EXPECT_EQ(connect(std::move(patches)).interfaces(), model.interfaces());
}

}  // namespace

std::vector<PatchFace> faces_of(const MultiPatch& model, const std::string& name) {
  for (const Boundary& boundary : model.boundaries())
    if (boundary.name == name) return boundary.faces;
  ADD_FAILURE() << "no boundary " << name;
  return {};
}

double boundary_area(const MultiPatch& model, const std::string& name) {
  double sum = 0;
  for (const PatchFace& face : faces_of(model, name)) sum += area(trace(model, face));
  return sum;
}

double surface_area(const MultiPatch& model) {
  double sum = 0;
  for (const PatchFace& face : model.boundary_faces()) sum += area(trace(model, face));
  return sum;
}

double total_volume(const MultiPatch& model) {
  double sum = 0;
  for (const NurbsVolume& patch : model.patches()) sum += volume(patch);
  return sum;
}

double worst(const MultiPatch& model, const std::string& name,
             const std::function<double(const Eigen::Vector3d&)>& residual) {
  double result = 0;
  for (const PatchFace& face : faces_of(model, name)) {
    const NurbsSurface surface = trace(model, face);
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j <= 6; ++j)
        result = larger(result, std::abs(residual(surface.point(Parameter<2>(i / 6.0, j / 6.0)))));
  }
  return result;
}

MultiPatch expect_sound(const PatchSet& patches, const Expected& expected) {
  MultiPatch model = connect(patches);
  EXPECT_EQ(model.patch_count(), expected.patches);
  EXPECT_EQ(model.interfaces().size(), static_cast<std::size_t>(expected.interfaces));
  EXPECT_EQ(model.boundary_faces().size(), static_cast<std::size_t>(expected.boundary_faces));
  EXPECT_TRUE(model.degenerate_faces().empty());
  EXPECT_EQ(model.bodies().size(), 1u);
  expect_every_face_named_once(model);
  expect_interfaces_stated(patches, model);
  for (const Interface& shared : model.interfaces()) expect_conforming(model, shared);
  for (int i = 0; i < model.patch_count(); ++i) {
    const JacobianCertificate certificate = certify_jacobian(model.patch(PatchId(i)));
    EXPECT_EQ(certificate.sign, JacobianSign::positive)
        << "patch " << i << ": det J " << certificate.smallest;
  }
  return model;
}

void expect_refused(const std::function<void()>& make, const std::vector<std::string>& parts) {
  try {
    make();
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    for (const std::string& part : parts) EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

}  // namespace isopatch::geometry

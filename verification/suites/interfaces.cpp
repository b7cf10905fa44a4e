// Interfaces are found from the geometry alone; where a file lists them, the list is the reference.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/measures.hpp"
#include "verification/claims/expect.hpp"
#include "verification/tests/reference_data.hpp"

namespace isopatch::verification {
namespace {

using namespace geometry;

using FacePairs = std::vector<std::pair<PatchFace, PatchFace>>;

FacePairs sorted(FacePairs pairs) {
  for (auto& [a, b] : pairs)
    if (b < a) std::swap(a, b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

FacePairs found_in(const MultiPatch& model) {
  FacePairs pairs;
  for (const Interface& i : model.interfaces())
    pairs.emplace_back(model.to_input(i.first), model.to_input(i.second));
  return sorted(pairs);
}

void expect_count(const std::string& what, ReferenceKind kind, const std::string& source, double reference,
                  std::size_t value) {
  expect(Claim{what, "", kind, source, reference, static_cast<double>(value), 0, {}});
}

// The faces that are no interface lie on the boundary; all patches are one body.
void expect_one_body(const std::string& name, const MultiPatch& model, int interfaces) {
  const double sides = 6.0 * model.patch_count() - 2.0 * interfaces;
  expect_count(name + ": boundary faces", ReferenceKind::exact, "six sides a patch", sides,
               model.boundary_faces().size());
  expect_count(name + ": bodies", ReferenceKind::exact, "one part", 1, model.bodies().size());
}

TEST(Coupling, InterfacesOfTerrific) {
  ISOPATCH_NEEDS_DATA("terrific/terrific.xml");
  PatchSet set = reference_patches("terrific/terrific.xml");
  FacePairs pairs;
  for (const StatedInterface& stated : set.interfaces) pairs.emplace_back(stated.first, stated.second);
  const FacePairs listed = sorted(std::move(pairs));
  set.interfaces.clear();
  const MultiPatch model = connect(set);
  const FacePairs found = found_in(model);
  FacePairs common;
  std::set_intersection(found.begin(), found.end(), listed.begin(), listed.end(), std::back_inserter(common));
  expect_count("TERRIFIC: interfaces found without the file's list", ReferenceKind::published,
               "TERRIFIC's file", 24, found.size());
  expect_count("TERRIFIC: of these, in the file's list", ReferenceKind::published, "TERRIFIC's file", 24,
               common.size());
  expect_one_body("TERRIFIC", model, 24);
}

TEST(Coupling, InterfacesOfTheChairStand) {
  ISOPATCH_NEEDS_DATA("chair_stand/chair_stand.xml");
  const MultiPatch model = connect(reference_patches("chair_stand/chair_stand.xml"));
  std::size_t reversed = 0;
  double volume = 0;
  for (int p = 0; p < model.patch_count(); ++p) {
    reversed += model.was_reversed(PatchId(p)) ? 1 : 0;
    volume += geometry::volume(model.patch(PatchId(p)));
  }
  expect_count("chair stand: interfaces", ReferenceKind::seed_figure, "the file's nine patches", 10,
               model.interfaces().size());
  expect_count("chair stand: left-handed patches turned around", ReferenceKind::seed_figure,
               "the file's nine patches", 9, reversed);
  expect_one_body("chair stand", model, 10);
  EXPECT_GT(volume, 0);
}

TEST(Coupling, LooselyFittedPatchesNeedTheirTolerance) {
  for (const std::string name : {"terrific/terrificPart01_vol.xml", "terrific/terrificPart02_vol.xml"}) {
    ISOPATCH_NEEDS_DATA(name);
    const PatchSet set = reference_patches(name);
    try {
      connect(set);
      ADD_FAILURE() << name << " fits only to 5e-6 of its size and must be refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::not_conforming);
      EXPECT_THAT(error.what(),
                  ::testing::HasSubstr("raise same_point (in a study: model.same_point) above 4.9e-06"));
    }
    const MultiPatch model = connect(set, {.same_point = 1e-5});
    expect_count(name + ": interfaces", ReferenceKind::published, "TERRIFIC's file", 24,
                 model.interfaces().size());
    expect_one_body(name, model, 24);
  }
}

}  // namespace
}  // namespace isopatch::verification

// Solids whose planes and cylinders come as splines end in the same blocks as they themselves.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "segmentation/decomposition/blocks.hpp"
#include "segmentation/decomposition/decompose.hpp"

namespace isopatch::segmentation {
namespace {

/// What a solid is cut into.
struct Cut {
  std::size_t blocks = 0;
  std::multiset<std::string> faces;  ///< names of all blocks' faces that have one
  double volume = 0;                 ///< m^3
};

Cut cut(const geometry::BrepFile& solid) {
  Cut result;
  for (const geometry::BrepFile& part :
       blocks(solid, decompose(solid.brep, solid.name, {.method = Method::cuts}))) {
    ++result.blocks;
    result.volume += part.brep.volume();
    for (const geometry::BrepFace& face : part.brep.faces()) result.faces.insert(face.name);
  }
  return result;
}

/// With all faces as splines, sewn, and recognised again.
geometry::Brep disguised_and_recognised(const geometry::BrepFile& original) {
  std::vector<geometry::TrimmedSurface> surfaces = trimmed_surfaces(original.brep);
  for (std::size_t f = 0; f < surfaces.size(); ++f) surfaces[f].name = original.brep.faces()[f].name;
  const geometry::Brep disguise = geometry::sew(surfaces).brep;
  for (const geometry::BrepFace& face : disguise.faces()) EXPECT_EQ(face.kind, geometry::SurfaceKind::spline);
  const geometry::RecognisedBrep found = geometry::recognise_carriers(disguise);
  EXPECT_FALSE(found.text().empty());
  return found.brep;
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(info.param.find('/') + 1);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

class DisguisedModels : public testing::TestWithParam<std::string> {};

TEST_P(DisguisedModels, AreCutIntoTheSameBlocks) {
  const auto path = isopatch::test::data_file(GetParam());
  ISOPATCH_NEEDS(path);
  const geometry::BrepFile original = geometry::read_brep(path);
  const Cut expected = cut(original), is = cut({disguised_and_recognised(original), original.name});
  EXPECT_EQ(is.blocks, expected.blocks);
  EXPECT_EQ(is.faces, expected.faces);
  EXPECT_NEAR(is.volume, expected.volume, 1e-9 * expected.volume);
}

// Sewing numbers edges anew, and which of several equal ways of cutting is taken depends on numbers: these
// have one best way.
INSTANTIATE_TEST_SUITE_P(Files, DisguisedModels,
                         testing::Values("models/block.step", "models/block_fillet1.step",
                                         "models/wedge_ok.step", "solids/ffoLshapeCut.xml",
                                         "solids/house.off"),
                         name_of);

/// Other models, by whatever way is best for them.
class DisguisedModelsAtBest : public testing::TestWithParam<std::string> {};

TEST_P(DisguisedModelsAtBest, EndInAsManyHexahedra) {
  const auto path = isopatch::test::data_file(GetParam());
  ISOPATCH_NEEDS(path);
  const geometry::BrepFile original = geometry::read_brep(path);
  const geometry::Brep disguised = disguised_and_recognised(original);
  EXPECT_EQ(decompose(disguised, original.name).report.hexahedra,
            decompose(original.brep, original.name).report.hexahedra);
}

INSTANTIATE_TEST_SUITE_P(Files, DisguisedModelsAtBest,
                         testing::Values("models/cylinder.step", "models/block_through_hole.step",
                                         "models/three_concave_edge.step", "models/7-connected.step",
                                         "solids/ffoTriBiPyramid.xml", "solids/ffoTriDoublePyramid.xml",
                                         "solids/ffoVaseHalfed.xml"),
                         name_of);

}  // namespace
}  // namespace isopatch::segmentation

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

class DisguisedModels : public testing::TestWithParam<std::string> {};

TEST_P(DisguisedModels, AreCutIntoTheSameBlocks) {
  const auto path = isopatch::test::data_file(GetParam());
  ISOPATCH_NEEDS(path);
  const geometry::BrepFile original = geometry::read_brep(path);
  std::vector<geometry::TrimmedSurface> surfaces = trimmed_surfaces(original.brep);
  for (std::size_t f = 0; f < surfaces.size(); ++f) surfaces[f].name = original.brep.faces()[f].name;
  const geometry::Brep disguise = geometry::sew(surfaces).brep;
  for (const geometry::BrepFace& face : disguise.faces()) EXPECT_EQ(face.kind, geometry::SurfaceKind::spline);
  const geometry::RecognisedBrep found = geometry::recognise_carriers(disguise);
  EXPECT_FALSE(found.text().empty());
  const Cut expected = cut(original), is = cut({found.brep, original.name});
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
                         [](const auto& info) {
                           std::string name = info.param.substr(info.param.find('/') + 1);
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace isopatch::segmentation

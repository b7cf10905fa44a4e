// Faces of a solid are kept to the last: patches' boundaries have their names and all of their area.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/base/tests/data_file.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/measures.hpp"
#include "geometry/patch_face.hpp"
#include "segmentation/decomposition/blocks.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::BrepFile;

std::string name_of(const BrepFile& solid, FaceId face) {
  const std::string& name = solid.brep.face(face).name;
  return name.empty() ? "face " + std::to_string(face.value) : name;
}

/// m^2, by name.
std::map<std::string, double> areas_of(const BrepFile& solid) {
  std::map<std::string, double> result;
  for (int f = 0; f < static_cast<int>(solid.brep.faces().size()); ++f)
    result[name_of(solid, FaceId(f))] += solid.brep.area(FaceId(f));
  return result;
}

std::map<std::string, double> areas_of(const geometry::PatchSet& set) {
  std::map<std::string, double> result;
  for (const geometry::Boundary& boundary : set.boundaries)
    if (!boundary.name.starts_with("#"))  // else the faces of a colour
      for (const geometry::PatchFace& face : boundary.faces)
        result[boundary.name] +=
            area(face_surface(set.patches[static_cast<std::size_t>(face.patch.value)], face.side));
  return result;
}

/// Of the outer faces of blocks, as "name #rrggbb"; faces between blocks have neither.
std::set<std::string> coloured(const std::vector<BrepFile>& solids) {
  std::set<std::string> result;
  for (const BrepFile& solid : solids)
    for (const geometry::BrepFace& face : solid.brep.faces())
      if (face.colour) result.insert(face.name + " " + geometry::hex_text(*face.colour));
  return result;
}

/// Neighbours in one plane without names of their own are one.
std::map<std::string, double> areas_of(const BrepFile& solid,
                                       const std::vector<std::vector<FaceId>>& made_one) {
  std::map<std::string, double> result = areas_of(solid);
  for (const std::vector<FaceId>& group : made_one)
    for (std::size_t i = 1; i < group.size(); ++i) {
      result[name_of(solid, group[0])] += solid.brep.area(group[i]);
      result.erase(name_of(solid, group[i]));
    }
  return result;
}

/// @param tolerance  of a face's area, relative
void expect_kept(const BrepFile& solid, double tolerance) {
  const Decomposition cut = decompose(solid.brep, solid.name);
  const std::vector<BrepFile> parts = blocks(solid, cut);
  std::set<std::string> colours;
  for (std::size_t f = 0; f < solid.brep.faces().size(); ++f)
    if (const auto& colour = solid.brep.faces()[f].colour)
      colours.insert(name_of(solid, FaceId(static_cast<int>(f))) + " " + geometry::hex_text(*colour));
  EXPECT_EQ(coloured(parts), colours);
  HexModel model = hex_model(parts, block_pairs(cut));
  model.bodies.assign(parts.size(), solid.name);
  const auto expected = areas_of(solid, faces_made_one(solid.brep, cut.complex)),
             found = areas_of(parameterize(model).patches);
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, area] : expected) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_NEAR(found.at(name), area, tolerance * area) << name;
  }
}

constexpr double allowed = 1e-6;  // what sides are, which planes and rational patches are to round-off

class KeptFaces : public testing::TestWithParam<std::string> {};

TEST_P(KeptFaces, HaveTheirNamesColoursAndAreas) {
  const BrepFile solid = geometry::read_breps(geometry::test::made_solid(GetParam())).bodies.front();
  expect_kept(solid, allowed);
}

INSTANTIATE_TEST_SUITE_P(MadeSolids, KeptFaces,
                         testing::Values("named", "drilled", "notched", "grooved", "countersunk",
                                         "drafted_boss", "angle", "quarter_shaft", "filleted_step"),
                         [](const auto& info) { return info.param; });

class KeptFacesOfModels : public testing::TestWithParam<std::string> {};

TEST_P(KeptFacesOfModels, HaveTheirNamesColoursAndAreas) {
  const auto path = test::data_file(GetParam());
  ISOPATCH_NEEDS(path);
  expect_kept(geometry::read_brep(path), allowed);
}

INSTANTIATE_TEST_SUITE_P(Models, KeptFacesOfModels,
                         testing::Values("models/7-connected.step", "models/block_fillet1.step",
                                         "models/three_concave_edge.step", "models/conjoined_twins.step",
                                         "solids/ffoLshapeCut.xml", "solids/ffoTriDoublePyramid.xml",
                                         "solids/E_triangulated.off"),
                         [](const auto& info) {
                           std::string name = info.param.substr(info.param.find('/') + 1);
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace isopatch::segmentation

#include "geometry/io/read_patches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/atomic_file.hpp"
#include "geometry/io/read_g2.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/io/tests/sample_patches.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::geometry {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ReadPatches, ContentTellsTheFormat) {
  const auto path = std::filesystem::temp_directory_path() / "isopatch_read_patches.g2";
  write_file(path, "\xEF\xBB\xBF\n" + to_gismo_xml(PatchSet{{cube_at(1, 2, 3)}, {}, {}}).substr(39));
  EXPECT_TRUE(same_bits(read_patches(path).patches.at(0), cube_at(1, 2, 3)));
  std::filesystem::remove(path);
}

TEST(ReadPatches, SkipsTheByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string g2 =
      "700 1 0 0\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n"
      "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n";
  EXPECT_TRUE(same_bits(read_patches(mark + g2, "x").patches.at(0), cube_at(0, 0, 0)));
  EXPECT_TRUE(same_bits(read_g2(mark + g2, "x").patches.at(0), cube_at(0, 0, 0)));
  const std::string xml = to_gismo_xml(PatchSet{{cube_at(1, 2, 3)}, {}, {}});
  EXPECT_TRUE(same_bits(read_patches(mark + xml, "x").patches.at(0), cube_at(1, 2, 3)));
  // Lines are still counted right.
  EXPECT_THAT(error_of([&] { read_patches(mark + "700 1 0 0\n3 0\nx", "x"); }), HasSubstr("x:3: 'x' is not"));
  EXPECT_THAT(error_of([&] { read_patches(mark + "<xml>\n<Geo", "x"); }), HasSubstr("x:2: broken XML"));
  EXPECT_THAT(error_of([&] { read_patches(mark + "MFEM NURBS mesh v1.0\ndimension\n7", "x"); }),
              HasSubstr("x:3: the dimension is '7'"));
  EXPECT_EQ(
      read_off(mark + "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", "x")
          .faces.size(),
      4u);
}

TEST(ReadPatches, NamesWhatItKnowsAndWhatItWants) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"ISO-10303-21;\nHEADER;", "unsupported: x: this is a STEP file"},
      {"solid part\n facet", "unsupported: x: this is an STL triangulation"},
      {"*Heading\n*NODE\n", "unsupported: x: this is an input file of Abaqus or CalculiX"},
      {"$MeshFormat\n4.1 0 8\n", "unsupported: x: this is a Gmsh mesh"},
      {"\nDBRep_DrawableShape\n", "unsupported: x: this is an OpenCASCADE .brep file"},
      {std::string("\xFF\xFE<\0", 4), "unsupported: x: this is a text in UTF-16; save it as UTF-8"},
      {"MFEM mesh v1.0\n", "unsupported: x: this is an MFEM mesh without NURBS"},
      {std::string("\x89HDF\r\n\x1a\n\0\0", 10), "unsupported: x: this is an HDF5 file"},
      {"hello", "unsupported: x: the format is unknown"},
      {" \n ", "bad_format: x: the file is empty"}};
  for (const auto& [text, says] : cases)
    EXPECT_THAT(error_of([&, t = text] { read_patches(t, "x"); }),
                AllOf(HasSubstr(says), HasSubstr("supported are G+Smo XML")));
  EXPECT_THAT(error_of([] { read_patches(std::filesystem::path("/no/such/file.xml")); }),
              HasSubstr("io: cannot read /no/such/file.xml"));
}

}  // namespace
}  // namespace isopatch::geometry

#include "geometry/io/read_patches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/atomic_file.hpp"
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

TEST(ReadPatches, NamesWhatItKnowsAndWhatItWants) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"ISO-10303-21;\nHEADER;", "unsupported: x: this is a STEP file"},
      {"solid part\n facet", "unsupported: x: this is an STL triangulation"},
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

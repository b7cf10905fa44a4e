#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/data_file.hpp"
#include "geometry/io/read_gismo_xml.hpp"
#include "geometry/io/tests/sample_patches.hpp"
#include "geometry/io/write_gismo_xml.hpp"
#include "geometry/splines/permute.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

PatchSet read_gismo_xml_text(const std::string& text) {
  return read_gismo_xml(text, "a.xml");
}

const std::string one_cube = R"(<?xml version="1.0"?>
<xml>
 <Geometry type="TensorBSpline3" id="7">
  <Basis type="TensorBSplineBasis3">
   <Basis type="BSplineBasis" index="0"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
   <Basis type="BSplineBasis" index="1"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
   <Basis type="BSplineBasis" index="2"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
  </Basis>
  <coefs geoDim="3">0 0 0  1 0 0
   0 1 0  1 1 0
   <!-- the upper half -->
   0 0 1  1 0 1
   0 1 1  1 1 1
  </coefs>
 </Geometry>
 <MultiPatch parDim="3" id="8"><patches type="id_index">7</patches>
  <boundary name="clamp &amp; load">7 1
7 2</boundary>
 </MultiPatch>
</xml>
)";

TEST(GismoXml, ReadsPatchesAndNamedBoundaries) {
  const PatchSet found = read_gismo_xml_text(one_cube);
  ASSERT_EQ(found.patches.size(), 1u);
  EXPECT_TRUE(same_bits(found.patches[0], NurbsVolume()));
  ASSERT_EQ(found.boundaries.size(), 1u);
  EXPECT_EQ(found.boundaries[0].name, "clamp & load");
  EXPECT_THAT(found.boundaries[0].faces,
              testing::ElementsAre(PatchFace{PatchId(0), Side::west}, PatchFace{PatchId(0), Side::east}));
}

TEST(GismoXml, WithoutAListAllVolumesAreRead) {
  std::string text = one_cube;
  const std::size_t from = text.find(" <MultiPatch");
  text.erase(from, text.find("</MultiPatch>") + 14 - from);
  EXPECT_EQ(read_gismo_xml_text(text).patches.size(), 1u);
}

TEST(GismoXml, BoundariesOfOneNameAreOne) {
  const PatchSet found = read_gismo_xml_text(
      replaced(one_cube, "7 2</boundary>",
               "7 2</boundary><boundary name=\"top\">7 6</boundary>"
               "<boundary name=\"clamp &amp; load\">7 3</boundary><boundary>7 4</boundary>"));
  ASSERT_EQ(found.boundaries.size(), 2u);  // one without a name is none
  EXPECT_THAT(found.boundaries[0].faces,
              testing::ElementsAre(PatchFace{PatchId(0), Side::west}, PatchFace{PatchId(0), Side::east},
                                   PatchFace{PatchId(0), Side::south}));
  EXPECT_THAT(found.boundaries[1].faces, testing::ElementsAre(PatchFace{PatchId(0), Side::back}));
}

TEST(GismoXml, ReadsNumbersHoweverWritten) {
  const PatchSet found =
      read_gismo_xml_text(replaced(one_cube, "0 1 0  1 1 0", "+0 1.0E+00 -0e5  1. .1e1 1e-400"));
  EXPECT_TRUE(same_bits(found.patches[0], NurbsVolume()));
}

TEST(GismoXml, RandomPatchesComeBackToTheLastBit) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    PatchSet set;
    for (int p = 0; p <= round % 3; ++p) set.patches.push_back(random_patch(random));
    set.boundaries.push_back({"a <\"b\"> & 'c'\n\xC3\xBC", {{PatchId(0), Side::back}}});
    const PatchSet back = read_gismo_xml_text(to_gismo_xml(set));
    ASSERT_EQ(back.patches.size(), set.patches.size());
    for (std::size_t p = 0; p < set.patches.size(); ++p)
      ASSERT_TRUE(same_bits(back.patches[p], set.patches[p]));
    ASSERT_EQ(back.boundaries.size(), 1u);
    EXPECT_EQ(back.boundaries[0].name, set.boundaries[0].name);
    EXPECT_EQ(back.boundaries[0].faces, set.boundaries[0].faces);
  }
}

TEST(GismoXml, KeepsTheInputsNamesOfLeftHandedPatches) {
  PatchSet set{{cube_at(0, 0, 0), reversed(cube_at(1, 0, 0), 0)}, {}, {}};
  set.boundaries.push_back({"far", {{PatchId(1), Side::west}}});
  const MultiPatch model = connect(set);
  ASSERT_TRUE(model.was_reversed(PatchId(1)));
  const std::string text = to_gismo_xml(model);
  EXPECT_THAT(text, HasSubstr("<interfaces>0 2 1 2 0 1 2 0 1 1\n</interfaces>"));
  EXPECT_THAT(text, HasSubstr("<boundary name=\"far\">1 1\n</boundary>"));
  const PatchSet back = read_gismo_xml_text(text);
  EXPECT_TRUE(same_bits(back.patches[1], set.patches[1]));
  EXPECT_EQ(connect(back).boundaries()[0].faces, model.boundaries()[0].faces);
}

TEST(GismoXml, StatesHowFacesLieOnEachOther) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const auto turned = [&](NurbsVolume cube) {
      for (int d = 0; d < 3; ++d)
        if (random() % 2 == 1) cube = reversed(cube, d);
      return permuted(cube, random() % 2 == 1 ? std::array{1, 2, 0} : std::array{0, 2, 1});
    };
    const MultiPatch model = connect({{turned(cube_at(0, 0, 0)), turned(cube_at(1, 0, 0))}, {}, {}});
    const PatchSet back = read_gismo_xml_text(to_gismo_xml(model));
    ASSERT_EQ(back.interfaces.size(), 1u);
    // `connect` would refuse another orientation.
    EXPECT_EQ(connect(back).interfaces(), model.interfaces()) << seed;
    EXPECT_EQ(read_gismo_xml_text(to_gismo_xml(back)), back);
  }
}

// The lines of an <interfaces> element, each pair in both orders.
std::set<std::vector<int>> interface_lines(const std::string& text) {
  const std::size_t from = text.find("<interfaces>") + 12;
  std::istringstream in(text.substr(from, text.find("</interfaces>") - from));
  std::set<std::vector<int>> result;
  std::vector<int> line(10);
  while (in >> line[0]) {
    for (std::size_t i = 1; i < 10; ++i) in >> line[i];
    std::vector<int> other = {line[2], line[3], line[0], line[1], 0, 0, 0, 0, 0, 0};
    for (std::size_t d = 0; d < 3; ++d) {
      other[4 + static_cast<std::size_t>(line[4 + d])] = static_cast<int>(d);
      other[7 + static_cast<std::size_t>(line[4 + d])] = line[7 + d];
    }
    result.insert(line);
    result.insert(other);
  }
  return result;
}

TEST(GismoXml, WritesTheInterfaceLinesOfThePublishedModel) {
  const auto path = isopatch::test::data_file("terrific/terrific.xml");
  ISOPATCH_NEEDS(path);
  const std::string text = read_file(path);
  const std::string ours = to_gismo_xml(connect(read_gismo_xml(text, path)));
  EXPECT_EQ(interface_lines(text).size(), 48u);
  EXPECT_EQ(interface_lines(ours), interface_lines(text));
}

TEST(GismoXml, PublishedModelsComeBackToTheLastBit) {
  for (const char* name :
       {"terrific/terrific.xml", "terrific/terrificPart01_vol.xml", "chair_stand/chair_stand.xml"}) {
    const auto path = isopatch::test::data_file(name);
    ISOPATCH_NEEDS(path);
    const PatchSet first = read_gismo_xml(read_file(path), name);
    const PatchSet second = read_gismo_xml_text(to_gismo_xml(first));
    // One of these models has gaps of 4.9e-6 of its size.
    const PatchSet third = read_gismo_xml_text(to_gismo_xml(connect(first, {.same_point = 1e-5})));
    ASSERT_EQ(first.patches.size(), second.patches.size());
    ASSERT_EQ(first.patches.size(), third.patches.size());
    for (std::size_t p = 0; p < first.patches.size(); ++p) {
      EXPECT_TRUE(same_bits(first.patches[p], second.patches[p]));
      EXPECT_TRUE(same_bits(first.patches[p], third.patches[p]));
    }
  }
}

struct Broken {
  std::string from, to, says;
};

TEST(GismoXml, ErrorsNameFileLineAndCause) {
  const std::vector<Broken> cases = {
      {"</Geometry>", "</Geo>", "bad_format: a.xml:15: broken XML"},
      {"<xml>", "<VTKFile>", "broken XML"},
      {"0 0 1 1</KnotVector></Basis>\n   <Basis type=\"BSplineBasis\" index=\"1\">",
       "0 1 0 1</KnotVector></Basis>\n<Basis index='1'>",
       "bad_format: a.xml:5: patch 0 (id 7), direction 0: knot vector: knot 2 (0) is smaller than the one "
       "before (1)"},
      {"0 0 1 1", "0 0 0 1", "bad_format: a.xml:5: patch 0 (id 7), direction 0: knot vector: not clamped"},
      {"0 0 1 1", "0 0 .5 1 1", "bad_format: a.xml:9: 36 numbers"},
      {"degree=\"1\"", "degree=\"0\"", "bad_format: a.xml:5: attribute 'degree' is '0', outside 1 .. 20"},
      {"degree=\"1\"", "degree=\"x\"", "bad_format: a.xml:5: 'x' is not an integer"},
      {"0 1 1  1 1 1", "0 1 1  1 1 nan",
       "bad_format: a.xml:13: patch 0 (id 7), control point 7 is 'nan'; it must be finite"},
      {"0 1 1  1 1 1", "0 1 1  1 1e999 1", "bad_format: a.xml:13: '1e999' is too large"},
      {"0 1 1  1 1 1", "0 1 1  1 1 1 1", "bad_format: a.xml:13: '1' follows the 24 numbers"},
      {"0 1 1  1 1 1", "0 1 1  1 1",
       "bad_format: a.xml:14: the data end where patch 0 (id 7), control point 7 is expected"},
      {"0 1 1  1 1 1", "0 1 1  1 1,5 1", "bad_format: a.xml:13: '1,5' is not a number"},
      {"geoDim=\"3\"", "geoDim=\"2\"",
       "unsupported: a.xml:9: patch 0 (id 7) has control points in 2 dimensions"},
      {"geoDim=\"3\"", "geoDim=\"3\" format=\"Hex\"",
       "unsupported: a.xml:9: patch 0 (id 7), control point: numbers in format 'Hex'; ASCII and base64"},
      {"geoDim=\"3\"", "geoDim=\"3\" format=\"B64Float16\"",
       "unsupported: a.xml:9: patch 0 (id 7), control point: numbers in format 'B64Float16'"},
      {"TensorBSpline3", "THBSpline3", "unsupported: a.xml:3: patch 0 (id 7) is of type 'THBSpline3'"},
      {"TensorBSpline3", "TensorNurbs3",
       "bad_format: a.xml:4: patch 0 (id 7): element <Basis> lacks its <weights>"},
      {"index=\"1\"", "index=\"0\"", "bad_format: a.xml:6: patch 0 (id 7): direction 0 is given twice"},
      {">7</patches>", ">7 7</patches>", "bad_format: a.xml:16: patch id 7 is listed twice"},
      {">7</patches>", ">6</patches>", "bad_format: a.xml:16: patch id 6 is listed, but no Geometry has it"},
      {"id_index\">7", "id_range\">0 2000000000", "bad_format: a.xml:16: more than 10000 patches"},
      {"7 2</boundary>", "7 9</boundary>", "bad_format: a.xml:18: a side is '9', outside 1 .. 6"},
      {"7 2</boundary>", "8 2</boundary>", "bad_format: a.xml:18: there is no patch with id 8"},
      {"7 2</boundary>", "7 2</boundary><interfaces>7 1 7 2 0 1</interfaces>",
       "bad_format: a.xml:18: the data end"},
      {"<MultiPatch", "<MultiPatch parDim=\"3\"/><MultiPatch",
       "a second MultiPatch element; keep the one to use"},
      {"<patches type=\"id_index\">7</patches>", "", "the MultiPatch element lacks its <patches>"},
      {" <Geometry type", " <Geometry type=\"TensorBSpline3\" id=\"7\"/><Geometry type",
       "bad_format: a.xml:3: a second Geometry with id 7"},
      {"7 2</boundary>", "7 2</boundary><interfaces>7 1 7 2 0 2 2 1 1 1</interfaces>",
       "bad_format: a.xml:18: directions 0 2 2 of an interface do not take side 1 to side 2"},
      {"7 2</boundary>", "7 2</boundary><interfaces>7 1 7 3 0 1 2 1 1 1</interfaces>",
       "bad_format: a.xml:18: directions 0 1 2 of an interface do not take side 1 to side 3"},
  };
  for (const Broken& broken : cases)
    EXPECT_THAT(error_of([&] { read_gismo_xml_text(replaced(one_cube, broken.from, broken.to)); }),
                HasSubstr(broken.says));
  EXPECT_THAT(error_of([] { read_gismo_xml_text("<mesh/>"); }),
              HasSubstr("the root element is <mesh>; G+Smo files have <xml>"));
}

// Bytes as base64, by the letters of the alphabet.
std::string base64(const std::string& bytes) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

template <class Number>
std::string base64_of(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double x : numbers) {
    const Number number = static_cast<Number>(x);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  return base64(bytes);
}

// A cube 0 .. 3 with all its numbers as base64; the format in lower case, as newer versions write it, too.
template <class Number>
std::string cube_in_base64(const std::string& format) {
  std::vector<double> points;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {0, 1, 2}) points.push_back(i >> bit & 1 ? 3 : 0);
  const std::string knots = "<KnotVector degree=\"1\" format=\"" + format + "\">" +
                            base64_of<Number>({0, 0, 1, 1}) + "</KnotVector>";
  std::string text = "<xml><Geometry type=\"TensorNurbs3\"><Basis><Basis>";
  for (int d = 0; d < 3; ++d) text += "<Basis>" + knots + "</Basis>";
  return text + "</Basis><weights format=\"" + format + "\">" + base64_of<Number>({1, 1, 1, 1, 1, 1, 1, 2}) +
         "</weights></Basis>\n<coefs geoDim=\"3\" format=\"" + format + "\">\n " +
         base64_of<Number>(points).insert(20, "\n  ") + "\n</coefs></Geometry></xml>";
}

TEST(GismoXml, ReadsNumbersInBase64) {
  for (const std::string& text :
       {cube_in_base64<double>("B64Float64"), cube_in_base64<double>("b64float64"),
        cube_in_base64<float>("B64Float32"), cube_in_base64<std::int16_t>("B64Int16"),
        cube_in_base64<std::int32_t>("B64Int32"), cube_in_base64<std::int64_t>("B64Int64"),
        cube_in_base64<std::uint16_t>("B64Uint16"), cube_in_base64<std::uint32_t>("B64Uint32"),
        cube_in_base64<std::uint64_t>("B64Uint64")}) {
    const PatchSet found = read_gismo_xml_text(text);
    ASSERT_EQ(found.patches.size(), 1u);
    EXPECT_EQ(found.patches[0].point({1, 1, 0}), Eigen::Vector3d(3, 3, 0));
    EXPECT_EQ(found.patches[0].weights()[7], 2);
  }
}

TEST(GismoXml, BrokenBase64IsAnError) {
  const std::string good = cube_in_base64<double>("B64Float64");
  const std::string first = base64_of<double>({0, 0, 1, 1});
  const auto with = [&](const std::string& knots) { return replaced(good, first, knots); };
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(with(first.substr(0, 20))); }),
              HasSubstr("no whole numbers of 8 bytes"));
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(with(first.substr(0, 21))); }),
              HasSubstr("the base64 text is cut off"));
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(with("*" + first.substr(1))); }),
              HasSubstr("'*' does not belong into base64"));
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(with("=" + first)); }),
              HasSubstr("does not belong into base64"));
  EXPECT_THAT(error_of([&] {
                read_gismo_xml_text(with(base64_of<double>({0, 0, 1, std::nan("")})));
              }),
              HasSubstr("it must be finite"));
  EXPECT_THAT(error_of([&] {
                read_gismo_xml_text(with(base64_of<double>({0, 0, .5, 1, 1})));
              }),
              HasSubstr("numbers where the knot vectors ask for"));
}

TEST(GismoXml, RefusesWeightsThatAreNotPositive) {
  std::mt19937 random(3);
  NurbsVolume patch = random_patch(random);
  while (!patch.is_rational()) patch = random_patch(random);
  const std::string text = to_gismo_xml(PatchSet{{patch}, {}, {}});
  const std::string weight = fmt::format("<weights>{}", patch.weights()[0]);
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(replaced(text, weight, "<weights>-2")); }),
              AllOf(StartsWith("bad_format: a.xml:"), HasSubstr("weight 0 is -2; weights must be positive")));
}

TEST(GismoXml, AnnouncedCountsAreNotBelieved) {
  std::string knots = "0 0";
  for (int i = 1; i < 5000; ++i) knots += fmt::format(" {}", i);
  std::string text = one_cube;
  for (int d = 0; d < 3; ++d) text = replaced(text, "0 0 1 1", knots + " 5000 5000");
  EXPECT_THAT(error_of([&] { read_gismo_xml_text(text); }),
              HasSubstr("5001 x 5001 x 5001 control points are more than"));
}

}  // namespace
}  // namespace isopatch::geometry

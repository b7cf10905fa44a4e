#include "geometry/brep/iges_header.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The section as cards of 72 columns.
std::string file_with(const std::string& global) {
  std::string text = fmt::format("{:72}S{:7}\n", "made by hand", 1);
  for (std::size_t i = 0; 72 * i < global.size(); ++i)
    text += fmt::format("{:72}G{:7}\n", global.substr(72 * i, 72), i + 1);
  return text + fmt::format("{:72}D{:7}\n", "", 1);
}

IgesHeader header(const std::string& scale, const std::string& flag, const std::string& name) {
  const std::string unit = name.empty() ? "" : fmt::format("{}H{}", name.size(), name);
  return iges_header(
      file_with(fmt::format("1H,,1H;,7Hproduct,8Ha;b,c.ig,3Hsys,3Hpre,32,308,15,308,15,,{},{},{},1,0.01,;",
                            scale, flag, unit)),
      "a.igs");
}

TEST(IgesHeader, KnowsAllUnitsByFlagAndByName) {
  for (const auto& [flag, name, metres] : {std::tuple(1, "IN", 0.0254),
                                           {2, "MM", 1e-3},
                                           {4, "FT", 0.3048},
                                           {6, "M", 1.0},
                                           {9, "UM", 1e-6},
                                           {10, "CM", 1e-2}}) {
    SCOPED_TRACE(name);
    const IgesHeader both = header("1.", std::to_string(flag), name);
    EXPECT_EQ(both.metres, metres);
    EXPECT_THAT(both.warnings, IsEmpty());
    EXPECT_EQ(header("1.", "3", name).metres, metres);
    EXPECT_EQ(header("1.", std::to_string(flag), "").metres, metres);
  }
}

TEST(IgesHeader, SaysWhatContradictsItselfOrIsMissing) {
  const IgesHeader against = header("1.", "1", "MM");
  EXPECT_EQ(against.unit, "inch");
  EXPECT_THAT(against.warnings.at(0),
              HasSubstr("the unit's flag says inch, its name says mm; inch is taken"));
  const IgesHeader none = header("", "", "");
  EXPECT_FALSE(none.has_unit);
  EXPECT_THAT(none.warnings.at(0), HasSubstr("mm is taken; give length_unit"));
  const IgesHeader scaled = header("0.5D0", "2", "MM");
  EXPECT_EQ(scaled.scale, 0.5);
  EXPECT_THAT(scaled.warnings.at(0), HasSubstr("drawn 0.5 times its size"));
}

TEST(IgesHeader, RefusesWhatIsNone) {
  const auto problem = [](const std::string& text) {
    try {
      iges_header(text, "a.igs");
      return std::string("none");
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(problem("solid\n"), HasSubstr("a.igs: this is no IGES file"));
  EXPECT_THAT(problem(file_with("1H,,1H;,7Hpro")), HasSubstr("does not end"));
  EXPECT_THAT(problem(file_with("1H,,1H;,,,,,,,,,,,-1.,2,2HMM,;")), HasSubstr("scale of the model is '-1.'"));
}

}  // namespace
}  // namespace isopatch::geometry

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/step_units.hpp"
#include "geometry/brep/write_brep.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string problem_of(const fs::path& path) {
  try {
    read_breps(path);
    return "none";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(DamagedCadFile, NumbersOfOpenCascadeFilesMustBeFinite) {
  const fs::path path = fs::path(testing::TempDir()) / "isopatch_nan.brep";
  write_brep(path, make_brep(test::block(1, 2, 3)));
  const std::string text = read_file(path);
  for (const char* word : {"nan", "-inf", "NAN"}) {
    std::string damaged = text;
    const std::size_t line = damaged.find('\n', damaged.find("Curve2ds")) + 1;
    const std::size_t number = damaged.find(' ', line) + 1;
    damaged.replace(number, damaged.find(' ', number) - number, word);
    write_file(path, damaged);
    EXPECT_THAT(problem_of(path), AllOf(HasSubstr("isopatch_nan.brep:"), HasSubstr("is no number"))) << word;
  }
  fs::remove(path);
}

TEST(DamagedCadFile, AMarkOfTheByteOrderIsPassedOver) {
  const fs::path path = fs::path(testing::TempDir()) / "isopatch_mark.step";
  write_brep(path, make_brep(test::block(1, 2, 3)));
  write_file(path, "\xEF\xBB\xBF" + read_file(path));
  EXPECT_NEAR(read_brep(path).brep.volume(), 6, 1e-9);
  fs::remove(path);
}

TEST(DamagedCadFile, AUnitThatDoesNotCallItselfALengthIsNone) {
  const std::string text =
      "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
      "#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
      "#2=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#1);\n"
      "#3=(CONVERSION_BASED_UNIT('INCH',#2)NAMED_UNIT(*));\n"
      "#4=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#3))"
      "REPRESENTATION_CONTEXT('',''));\n"
      "#5=SHAPE_REPRESENTATION('',(),#4);\nENDSEC;\nEND-ISO-10303-21;\n";
  const Part21File file(text, "a.step");
  const StepUnits units = step_units(file);
  EXPECT_FALSE(units.stated);
  EXPECT_THAT(units.warnings, ElementsAre(AllOf(HasSubstr("#3"), HasSubstr("no LENGTH_UNIT"))));
}

// The CAD library passes such a context over, units and all.
TEST(DamagedCadFile, UnitsOfSomethingElseThanAGeometricContextAreNone) {
  const std::string text =
      "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
      "#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MICRO.,.METRE.));\n"
      "#4=(SOME_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1))REPRESENTATION_CONTEXT('',''));\n"
      "#5=SHAPE_REPRESENTATION('',(),#4);\nENDSEC;\nEND-ISO-10303-21;\n";
  const StepUnits units = step_units(Part21File(text, "a.step"));
  EXPECT_FALSE(units.stated);
  EXPECT_THAT(units.warnings,
              ElementsAre(AllOf(HasSubstr("#4"), HasSubstr("no GEOMETRIC_REPRESENTATION_CONTEXT"))));
}

}  // namespace
}  // namespace isopatch::geometry

#include "geometry/brep/part21.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "geometry/base/error.hpp"
#include "geometry/brep/step_products.hpp"
#include "geometry/brep/step_units.hpp"
#include "geometry/brep/tests/step_assembly.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

using test::StepAssembly;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string with_data(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n" + data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string problem(const std::string& text) {
  try {
    const Part21File file(text, "a.step");
    return "none";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_format);
    return error.what();
  }
}

TEST(Part21, ReadsEveryKindOfValue) {
  const std::string text = with_data(
      "#1 = A(1,-2.5E+1,$,*,'it''s',.T.,\"0F\",#2,(1.,(2.)),B(3.),());/* #9=no */\n#2=(C('')\nD(#1));\n");
  const Part21File file(text, "a.step");
  ASSERT_EQ(file.instances().size(), 2u);
  const auto records = file.records(file.instances()[0]);
  ASSERT_EQ(records.size(), 1u);
  const auto& values = records[0].values;
  ASSERT_EQ(values.size(), 11u);
  EXPECT_EQ(values[0].number, 1);
  EXPECT_EQ(values[1].number, -25);
  EXPECT_EQ(values[2].kind, Part21Value::Kind::omitted);
  EXPECT_EQ(values[3].kind, Part21Value::Kind::derived);
  EXPECT_EQ(values[4].text, "it''s");
  EXPECT_EQ(values[5].text, "T");
  EXPECT_EQ(values[7].reference, 2);
  EXPECT_EQ(values[8].items[1].items[0].number, 2);
  EXPECT_EQ(values[9].text, "B");
  EXPECT_THAT(values[10].items, IsEmpty());
  EXPECT_EQ(file.find(2)->line, 6);
  EXPECT_EQ(file.records(*file.find(2)).size(), 2u);
  EXPECT_THAT(file.references(*file.find(2)), ElementsAre(1));
  EXPECT_EQ(file.find(3), nullptr);
}

TEST(Part21, NamesLineAndEntityOfWhatIsNoToken) {
  for (const std::string bad : {"1.#IND", "1..0", "1.2.3", "-", "nan", "1e", "12abc", "+-1", "1,,2", "1 2",
                                ".T", "1e999", "#", "#x", "'", "\"1", "((1)", "/* "}) {
    SCOPED_TRACE(bad);
    EXPECT_THAT(problem(with_data("#7=PLANE('',#8);\n#8=POINT((" + bad + "));\n")),
                HasSubstr("a.step:6: #8"));
  }
  for (const std::string good : {"1", "1.", "-.5", "+1.5e-3", "1E5", "1.E-400", "00.10"}) {
    SCOPED_TRACE(good);
    EXPECT_EQ(problem(with_data("#8=POINT((" + good + "));\n")), "none");
  }
}

TEST(Part21, RefusesFilesThatAreNoneOrCutShort) {
  EXPECT_THAT(problem(""), HasSubstr("no STEP file"));
  EXPECT_THAT(problem("solid cube\n"), HasSubstr("no STEP file"));
  EXPECT_THAT(problem(with_data("")), HasSubstr("has no data"));
  const std::string whole = with_data("#1=A(1.);\n#2=B(#1);\n");
  for (std::size_t length = 0; length < whole.find("END-ISO"); ++length)
    EXPECT_NE(problem(whole.substr(0, length)), "none") << length;
  EXPECT_THAT(problem(with_data("#1=A();\n#1=B();\n")),
              HasSubstr("a.step:6: #1 = B: this number is there before, in line 5"));
  EXPECT_THAT(problem(with_data("#1=A()\n#2=B();\n")), HasSubstr("';' is missing"));
}

TEST(Part21, NothingButAnErrorComesOfDamagedFiles) {
  StepAssembly step;
  step.product("part", {step.body(test::block(1, 2, 3)).item});
  const std::string sound = step.text();
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text = sound;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random() % 128);
    try {
      const Part21File file(text, "a.step");
      step_units(file);
      StepProducts(file).product_of(file.instances().back().id);
      file.unknown_references();
    } catch (const Error&) {
    }
  }
}

TEST(Part21, FindsReferencesIntoNothing) {
  const std::string text = with_data("#1=A(#2,#5);\n#2=B();\n");
  EXPECT_THAT(Part21File(text, "a.step").unknown_references(),
              ElementsAre("line 5: #1 = A refers to #5, which is not in the file"));
}

StepUnits units_of(const std::string& unit) {
  StepAssembly step(unit);
  if (unit.find("#100") != unit.npos) {  // for units made of others
    while (step.add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.3048),#102)") < 99) {
    }
    step.add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.0833333333333333),#101)");
    step.add("(CONVERSION_BASED_UNIT('FOOT',#99)LENGTH_UNIT()NAMED_UNIT(*))");
    step.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))");
  }
  step.product("part", {step.body(test::block(1, 2, 3)).item});
  const std::string text = step.text();
  return step_units(Part21File(text, "a.step"));
}

TEST(StepUnits, AreFollowedDownToTheMetre) {
  const auto si = [](const std::string& prefix) {
    return units_of("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(" + prefix + ",.METRE.))");
  };
  EXPECT_EQ(si(".MILLI.").name, "mm");
  EXPECT_EQ(si(".CENTI.").name, "cm");
  EXPECT_EQ(si("$").name, "m");
  EXPECT_TRUE(si("$").stated);
  EXPECT_THAT(si("$").warnings, IsEmpty());
  EXPECT_THAT(si("$").replaced, IsEmpty());
  const StepUnits inch = units_of("(CONVERSION_BASED_UNIT('INCH',#100)LENGTH_UNIT()NAMED_UNIT(*))");
  EXPECT_EQ(inch.name, "inch");
  ASSERT_EQ(inch.replaced.size(), 1u);  // the library would take 1 mm
  EXPECT_THAT(inch.replaced.at(100), HasSubstr("0.02539999999"));
}

TEST(StepUnits, AreNeverGuessedInSilence) {
  const StepUnits none = units_of("$");
  EXPECT_FALSE(none.stated);
  ASSERT_EQ(none.warnings.size(), 1u);
  EXPECT_THAT(none.warnings[0],
              HasSubstr("SHAPE_REPRESENTATION has no unit of length; mm is taken; give length_unit"));
  const StepUnits endless = units_of("(CONVERSION_BASED_UNIT('INCH',#4711)LENGTH_UNIT()NAMED_UNIT(*))");
  EXPECT_FALSE(endless.stated);
  EXPECT_THAT(endless.warnings.at(0), HasSubstr("how long the unit is, is not in the file"));
  const StepUnits odd = units_of("(CONVERSION_BASED_UNIT('MILE',#100)LENGTH_UNIT()NAMED_UNIT(*))");
  EXPECT_TRUE(odd.stated);
  EXPECT_THAT(odd.warnings.at(0), HasSubstr("the unit is called 'MILE' but is said to be 25.4 mm long"));
}

TEST(StepProducts, CountsBodiesWhereverTheyArePlaced) {
  StepAssembly step;
  const auto bolt = step.product("bolt", {step.body(test::block(1, 1, 1)).item});
  const auto pair = step.product("pair", {});
  const auto whole = step.product(
      "whole", {step.body(test::block(1, 2, 1)).item, step.body(test::block(1, 2, 2), "", "shell").item});
  step.place(pair, bolt, {2, 0, 0});
  step.place(pair, bolt, {4, 0, 0});
  step.place(whole, pair, {0, 5, 0});
  step.place(whole, pair, {0, 9, 0});
  const std::string text = step.text();
  const Part21File file(text, "a.step");
  const StepProducts products(file);
  EXPECT_EQ(products.placed_bodies(), 6);
  for (const Part21Instance& instance : file.instances())
    if (instance.type == "ADVANCED_FACE") {
      EXPECT_EQ(products.product_of(instance.id), "bolt");
      break;
    }
}

}  // namespace
}  // namespace isopatch::geometry

#include "app/base/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "app/base/engineering_units.hpp"
#include "app/base/place_text.hpp"
#include "app/base/unit_table.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

using testing::HasSubstr;

std::string unit_refusal(const std::string& text) {
  try {
    parse_quantity(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(Units, KnowTheEngineersUnits) {
  // Factors are exact or correctly rounded, so values must agree to the last bit.
  EXPECT_EQ(parse_quantity("20 MPa").value, 20e6);
  EXPECT_EQ(parse_quantity("-14 MPa").value, -14e6);
  EXPECT_EQ(parse_quantity("1.1 mm").value, 0.0011);
  EXPECT_EQ(parse_quantity("225mm").value, 0.225);
  EXPECT_EQ(parse_quantity("+1 kN").value, 1000);
  EXPECT_EQ(parse_quantity("7850 kg/m^3").value, 7850);
  EXPECT_EQ(parse_quantity("7.85 g/cm3").value, 7850);
  EXPECT_EQ(parse_quantity("2 t").value, 2000);
  EXPECT_EQ(parse_quantity("1 in").value, 0.0254);
  EXPECT_EQ(parse_quantity("2 inch").value, 0.0508);
  EXPECT_EQ(parse_quantity("3 foot").value, 0.9144);
  EXPECT_EQ(parse_quantity("1 foot/s").dimension, parse_quantity("1 ft/s").dimension);
  EXPECT_EQ(parse_quantity("3 %").value, 0.03);
  EXPECT_EQ(parse_quantity("5 N/mm^2").value, 5e6);
  EXPECT_EQ(parse_quantity("5 N/mm\u00b2").value, 5e6);
  EXPECT_DOUBLE_EQ(parse_quantity("1 lbf").value, 4.4482216152605);
  EXPECT_NEAR(parse_quantity("1 psi").value, 6894.757293168, 1e-8);
  EXPECT_DOUBLE_EQ(parse_quantity("36 deg").value, std::numbers::pi / 5);
  EXPECT_DOUBLE_EQ(parse_quantity("3 \u00b5m").value, 3e-6);
}

TEST(Units, AnAlgebraOfDimensionsJoinsThem) {
  EXPECT_EQ(parse_quantity("1 N/m^2").dimension, dimensions::pressure);
  EXPECT_EQ(parse_quantity("1 kg m s^-2").dimension, dimensions::force);
  EXPECT_EQ(parse_quantity("1 N*m").dimension, dimensions::energy);
  EXPECT_EQ(parse_quantity("1 N\u00b7m").dimension, dimensions::energy);
  EXPECT_EQ(parse_quantity("1 kg/(m s^2)").dimension, dimensions::pressure);
  EXPECT_EQ(parse_quantity("9.81 m/s^2").dimension, dimensions::acceleration);
  EXPECT_EQ(parse_quantity("1 (N/mm)^2").value, 1e6);
  EXPECT_EQ(parse_quantity("4").dimension, dimensions::none);
  EXPECT_EQ(parse_scale("mm").value, 1e-3);
  EXPECT_EQ(si_unit(parse_quantity("1 kg^2 m").dimension), "kg^2 m");
}

TEST(Units, MeasureMemoryInPowersOf1000And1024) {
  EXPECT_EQ(parse_quantity("2 GB").value, 2e9);
  EXPECT_EQ(parse_quantity("1.5 MB").value, 1.5e6);
  EXPECT_EQ(parse_quantity("4 KiB").value, 4096);
  EXPECT_EQ(parse_quantity("3 GiB").value, 3221225472.0);
  EXPECT_EQ(parse_quantity("1 TB").dimension, dimensions::data);
  EXPECT_EQ(describe(dimensions::data), "an amount of memory");
  EXPECT_EQ(si_unit(parse_quantity("1 B/s").dimension), "s^-1 B");
  EXPECT_THAT(unit_refusal("2 gb"), HasSubstr("did you mean 'GB'?"));
  EXPECT_THAT(unit_refusal("2 KB"), HasSubstr("did you mean 'kB'?"));
}

TEST(Units, AreListedOnceEach) {
  EXPECT_EQ(
      known_units(),
      "m g s N Pa J W with the prefixes n u m c d k M G; t bar in ft lb lbf psi ksi Msi rad deg K rpm %; of "
      "memory B "
      "kB MB GB TB KiB MiB GiB TiB");
  EXPECT_THAT(unit_refusal("20 furlong"), HasSubstr(known_units()));
}

TEST(Units, UncertaintiesHaveTheUnitOfTheirValueAndNoPowersOfTen) {
  EXPECT_EQ(with_uncertainty(290e3, 110e3, "Pa"), "290 +- 110 kPa");
  EXPECT_EQ(with_uncertainty(375.83e6, 7.93e6, "Pa"), "375.8 +- 7.9 MPa");
  EXPECT_EQ(with_uncertainty(1.469e9, 873e6, "Pa"), "1.469 +- 0.87 GPa");
  EXPECT_EQ(with_uncertainty(12.34e6, 96, "Pa"), "12.34 +- 0.000096 MPa");
  EXPECT_EQ(with_uncertainty(12.34e6, 995e3, "Pa"), "12.34 +- 1.00 MPa") << "two digits, rounded up to three";
  EXPECT_EQ(with_uncertainty(290e3, 2e6, "Pa"), "0.29 +- 2.0 MPa");
  EXPECT_EQ(with_uncertainty(5e6, 0, "Pa"), "5 +- 0 MPa");
}

TEST(Units, ArePrintedWithThePrefixesThatAreRead) {
  for (const double value : {2e-9, 3e-6, 4e-3, 5.0, 6e3, 7e6, 8e9}) {
    const std::string text = with_unit(value, "Pa");
    EXPECT_EQ(parse_quantity(text).value, value) << text;
  }
  EXPECT_EQ(with_unit(7.5e-4, "m^2"), "7.5 cm^2");
  EXPECT_EQ(with_unit(0.1, "m"), "100 mm");
  EXPECT_EQ(with_unit(1 - 1e-15, "m^2"), "1 m^2") << "not 1e+04 cm^2";
  EXPECT_EQ(with_unit(1 - 1e-15, "m^3"), "1 m^3");
  EXPECT_EQ(with_unit(999.99e3, "Pa"), "1 MPa");
  EXPECT_EQ(with_unit(999.9e3, "Pa"), "999.9 kPa");
  EXPECT_EQ(place_text({0.1, -2, 1e-7}), "(0.1, -2, 1e-07)");
  EXPECT_EQ(place_text({1. / 3, 20, 1e6}, 3), "(0.333, 20, 1e+06)");
}

TEST(Units, RefuseWhatIsNoQuantity) {
  EXPECT_THAT(unit_refusal("nan"), HasSubstr("not a finite number"));
  EXPECT_THAT(unit_refusal("inf m"), HasSubstr("not a finite number"));
  EXPECT_THAT(unit_refusal("1e999 m"), HasSubstr("too large"));
  EXPECT_THAT(unit_refusal("1e308 GPa"), HasSubstr("overflows"));
  EXPECT_THAT(unit_refusal("20 Mpa"), HasSubstr("did you mean 'MPa'?"));
  EXPECT_THAT(unit_refusal("20 furlong"), HasSubstr("unknown unit 'furlong'"));
  EXPECT_THAT(unit_refusal("MPa"), HasSubstr("expected a number with a unit"));
  EXPECT_THAT(unit_refusal(""), HasSubstr("expected a number"));
  EXPECT_THAT(unit_refusal("1 N/"), HasSubstr("a unit is missing"));
  EXPECT_THAT(unit_refusal("1 (N"), HasSubstr("bracket is not closed"));
  EXPECT_THAT(unit_refusal("1 N)"), HasSubstr("unexpected ')'"));
  for (const char* power : {"1 m^99", "1 m^10", "1 m^0", "1 m^-10"})
    EXPECT_THAT(unit_refusal(power), HasSubstr("an exponent from 1 to 9 or -1 to -9 in the unit")) << power;
  for (const char* power : {"1 m^", "1 m^x", "1 m^99999999999"})
    EXPECT_THAT(unit_refusal(power), HasSubstr("a whole exponent in the unit")) << power;
  EXPECT_THAT(unit_refusal("1 " + std::string(1000, '(')), HasSubstr("too many brackets"));
}

TEST(EngineeringUnits, CountInTheSingularAndThePlural) {
  EXPECT_EQ(counted(1, "interface"), "1 interface");
  EXPECT_EQ(counted(0, "interface"), "0 interfaces");
  EXPECT_EQ(counted(std::size_t{73746}, "interface"), "73,746 interfaces");
  EXPECT_EQ(counted(1, "patch", "patches"), "1 patch");
  EXPECT_EQ(counted(2, "patch", "patches"), "2 patches");
}

TEST(Units, BytesThatRoundToAThousandAreOneOfTheNextUnit) {
  EXPECT_EQ(bytes_text(999'400'000), "999 MB");
  EXPECT_EQ(bytes_text(999'900'000), "1 GB");
  EXPECT_EQ(bytes_text(999'900), "1 MB");
}

}  // namespace
}  // namespace isopatch::app

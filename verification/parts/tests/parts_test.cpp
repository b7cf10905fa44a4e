// The files of isopatch-parts, as isopatch reads them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/contradictions.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::parts {
namespace {

using nlohmann::json;

const std::filesystem::path folder = ISOPATCH_PARTS;
constexpr double round_off = 1e-11;  // volumes are sums of thousands of terms; cones reach 3e-13

json table() {
  return json::parse(read_file(folder / "parts.json"));
}

/// In this very process: faster than `read_brep`, which trusts no file.
geometry::Brep solid(const json& part) {
  const std::filesystem::path path = folder / part["file"].get<std::string>();
  const std::string text = read_file(path);
  const auto content = geometry::brep_module().read({.path = path, .text = text}, {});
  EXPECT_EQ(content.bodies.size(), 1U) << path;
  EXPECT_TRUE(content.lost.empty()) << path;
  return geometry::Brep(content.bodies.front().kernel);
}

void expect_a_sound_solid_as_drawn(const json& part) {
  SCOPED_TRACE(part["name"].get<std::string>());
  const geometry::Brep brep = solid(part);
  geometry::require_sound(brep);
  for (const std::string name : part["faces"])
    EXPECT_EQ(std::count_if(brep.faces().begin(), brep.faces().end(),
                            [&](const geometry::BrepFace& face) { return face.name == name; }),
              1)
        << name;
  if (!part["volume_in_mm3"].is_null()) {
    EXPECT_NEAR(1e9 * brep.volume() / part["volume_in_mm3"].get<double>(), 1, round_off);
  }
}

void expect_all_of(const std::string& set) {
  int count = 0;
  for (const json& part : table())
    if (part["set"] == set) {
      expect_a_sound_solid_as_drawn(part);
      ++count;
    }
  EXPECT_GT(count, 1);
}

double volume_of(const std::string& name) {
  for (const json& part : table())
    if (part["name"] == name) return 1e9 * solid(part).volume();
  throw std::out_of_range(name);
}

TEST(Parts, BasicOnesAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("basic");
}

TEST(Parts, ThoseOfAShopAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("shop");
}

TEST(Parts, LaterOnesAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("later");
}

TEST(Parts, TurnedOnesAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("turned");
}

TEST(Parts, HeldOutOnesAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("held_out");
}

TEST(Parts, ThoseHeldOutLaterAreSoundHaveTheirNamesAndTheirVolume) {
  expect_all_of("held_out_later");
}

TEST(Parts, ModelsAreSoundAndHaveTheirNames) {
  expect_all_of("models");
}

TEST(Parts, TheLinkIsThatOfItsExample) {
  EXPECT_NEAR(volume_of("link"), 30230, 10);  // as the example's README rounds it
}

// Of the published model without the blends of its pockets.
TEST(Parts, TheDemonstratorHasItsVolume) {
  EXPECT_NEAR(volume_of("demonstrator") / 465324, 1, 2e-3);
}

// Of the published patches, whose slot and sides are splines of their own.
TEST(Parts, TheChairStandHasItsVolume) {
  EXPECT_NEAR(volume_of("chair_stand") / 570.0e3, 1, 5e-3);
}

}  // namespace
}  // namespace isopatch::parts

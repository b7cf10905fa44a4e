#include "geometry/base/nearest_name.hpp"

#include <gtest/gtest.h>

namespace isopatch {
namespace {

const std::vector<std::string> keys = {"degree", "refine", "elements_per_direction", "continuity", "id"};

TEST(NearestName, FindsTyposOfEveryKind) {
  EXPECT_EQ(nearest_name("degre", keys), "degree");           // a letter left out
  EXPECT_EQ(nearest_name("deegree", keys), "degree");         // one too many
  EXPECT_EQ(nearest_name("defree", keys), "degree");          // another one
  EXPECT_EQ(nearest_name("laod", {"load", "lame"}), "load");  // two exchanged
  EXPECT_EQ(nearest_name("elements_per_dirction", keys), "elements_per_direction");
  EXPECT_EQ(nearest_name("continuity", keys), "continuity");
}

TEST(NearestName, ShortNamesMayDifferByOneLetter) {
  EXPECT_EQ(nearest_name("it", keys), "id");
  EXPECT_EQ(nearest_name("xy", keys), "");
}

TEST(NearestName, FarNamesAreNotGuessed) {
  EXPECT_EQ(nearest_name("material", keys), "");
  EXPECT_EQ(nearest_name("", keys), "");
  EXPECT_EQ(nearest_name("degree", {}), "");
}

TEST(NearestName, TheNearestOfSeveralWins) {
  EXPECT_EQ(nearest_name("bore_lefd", {"bore_right", "bore_left", "bore_list"}), "bore_left");
}

TEST(NearestName, SuggestionIsReadyToAppend) {
  EXPECT_EQ(did_you_mean("degre", keys), " (did you mean 'degree'?)");
  EXPECT_EQ(did_you_mean("material", keys), "");
}

}  // namespace
}  // namespace isopatch

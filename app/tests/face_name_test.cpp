#include "app/problem/face_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::app {
namespace {

using geometry::PatchFace;
using geometry::Side;
using testing::ElementsAre;
using testing::HasSubstr;

const PatchFace west{PatchId(0), Side::west};
const PatchFace top{PatchId(1), Side::back};
const PatchFace front{PatchId(1), Side::front};

std::vector<PatchFace> faces_found(const std::string& text,
                                   const std::vector<geometry::Boundary>& boundaries) {
  return faces_named(text, 2, boundaries, {"study.toml", 7, 1});
}

std::string name_refusal(const std::string& text, const std::vector<geometry::Boundary>& boundaries) {
  try {
    faces_found(text, boundaries);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "accepted";
}

TEST(FaceName, HasAFormForEachKind) {
  const std::vector<geometry::Boundary> boundaries = {{"bore", {top}}, {"#ff0000", {top, front}}};
  EXPECT_THAT(faces_found("bore", boundaries), ElementsAre(top));
  EXPECT_THAT(faces_found("face:bore", boundaries), ElementsAre(top));
  EXPECT_THAT(faces_found("#ff0000", boundaries), ElementsAre(top, front));
  EXPECT_THAT(faces_found("#FF0000", boundaries), ElementsAre(top, front)) << "colours have no capitals";
  EXPECT_THAT(faces_found("colour:#Ff0000", boundaries), ElementsAre(top, front));
  EXPECT_THAT(faces_found("0:west", boundaries), ElementsAre(west));
  EXPECT_THAT(faces_found("side:0:west", boundaries), ElementsAre(west));
  EXPECT_THAT(name_refusal("Bore", boundaries),
              HasSubstr("no boundary is named \"Bore\" (did you mean 'bore'?)"));
  EXPECT_THAT(name_refusal("colour:bore", boundaries), HasSubstr("no boundary is named \"colour:bore\""));
  EXPECT_THAT(name_refusal("face:#ff0000", boundaries), HasSubstr("no boundary is named \"face:#ff0000\""));
  EXPECT_THAT(name_refusal("side:2:west", boundaries), HasSubstr("the model has patches 0 to 1"));
}

TEST(FaceName, WithTwoMeaningsIsRefusedWithBoth) {
  // As solids give them: faces called like a side and like a colour, and faces of that colour.
  const std::vector<geometry::Boundary> boundaries = {
      {"0:west", {top}}, {"face:#ff0000", {front}}, {"#ff0000", {top}}};
  EXPECT_EQ(name_refusal("0:west", boundaries),
            "study.toml:7:1: the name \"0:west\" has two meanings: the faces of that name, which is "
            "\"face:0:west\" in full, and the west side of patch 0, \"side:0:west\"; write one of these");
  EXPECT_THAT(faces_found("face:0:west", boundaries), ElementsAre(top));
  EXPECT_THAT(faces_found("side:0:west", boundaries), ElementsAre(west));
  const std::string message = name_refusal("#ff0000", boundaries);
  EXPECT_THAT(message, HasSubstr("\"face:#ff0000\""));
  EXPECT_THAT(message, HasSubstr("the faces of that colour, \"colour:#ff0000\""));
  EXPECT_THAT(faces_found("face:#ff0000", boundaries), ElementsAre(front));
  EXPECT_THAT(faces_found("colour:#ff0000", boundaries), ElementsAre(top));
}

TEST(FaceName, WithTwoMeaningsThatAreTheSameFacesIsNone) {
  EXPECT_THAT(faces_found("0:west", {{"0:west", {west}}}), ElementsAre(west));
  // Where the input's sides are called otherwise, they are brought into the model's naming first.
  const auto turned = [](const PatchFace& face) {
    return face.side == Side::west ? PatchFace{face.patch, Side::east} : face;
  };
  const PatchFace east{PatchId(0), Side::east};
  EXPECT_THAT(faces_named("0:west", 2, {{"0:west", {east}}}, {}, turned), ElementsAre(east));
  EXPECT_ERROR(faces_named("0:west", 2, {{"0:west", {west}}}, {}, turned), ErrorCode::invalid_argument,
               "has two meanings");
}

TEST(FaceName, OfABlockCalledFaceIsItsOwn) {
  const std::vector<geometry::Boundary> boundaries = {{"face:bore", {top}}, {"side:west", {front}}};
  EXPECT_THAT(faces_found("face:bore", boundaries), ElementsAre(top));
  EXPECT_THAT(faces_found("side:west", boundaries), ElementsAre(front));
  EXPECT_THAT(name_refusal("bore", boundaries), HasSubstr("no boundary is named \"bore\""));
}

}  // namespace
}  // namespace isopatch::app

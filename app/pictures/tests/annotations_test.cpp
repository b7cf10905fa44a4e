#include "app/pictures/annotations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace isopatch::app {
namespace {

using ::testing::ElementsAre;

const PictureSize sizes[] = {{1600, 1200}, {400, 300}, {4096, 2160}};

/// A picture of three colours, seen from a named side.
Picture seen_from(const std::string& view, const PictureSize& size = {1600, 1200}) {
  Picture picture;
  picture.size = size;
  picture.camera.view = *named_view(view);
  picture.palette = {{10, 0, 0}, {0, 20, 0}, {0, 0, 30}};
  return picture;
}

std::vector<std::string> words(const Picture& picture) {
  std::vector<std::string> result;
  for (const PictureText& text : picture.texts) result.push_back(text.text);
  return result;
}

const PictureText& text_of(const Picture& picture, const std::string& word) {
  const auto found = std::find_if(picture.texts.begin(), picture.texts.end(),
                                  [&](const PictureText& text) { return text.text == word; });
  if (found == picture.texts.end()) throw std::out_of_range(word);
  return *found;
}

Box around(const PicturePolygon& polygon) {
  Box box{1e9, 1e9, -1e9, -1e9};
  for (const Eigen::Vector2d& corner : polygon.corners)
    box = {std::min(box.left, corner.x()), std::min(box.bottom, corner.y()), std::max(box.right, corner.x()),
           std::max(box.top, corner.y())};
  return box;
}

bool is_inside(const Box& box, const PictureSize& size) {
  return box.left >= 0 && box.bottom >= 0 && box.right <= size.width && box.top <= size.height;
}

TEST(Layout, KeepsPartBarAndAxesApartAndInThePicture) {
  for (const PictureSize& size : sizes)
    for (const bool bar : {true, false})
      for (const bool caption : {true, false}) {
        const Layout at = layout(size, {.bar = bar, .caption = caption});
        const double reach = at.axes + at.font;  // an arrow and the letter behind it
        const Box axes = {at.axes_x - reach, at.axes_y - reach, at.axes_x + reach, at.axes_y + reach};
        EXPECT_TRUE(is_inside(at.part, size));
        EXPECT_TRUE(is_inside(axes, size)) << size.width << (bar ? " with" : " without") << " bar";
        EXPECT_LE(at.part.right, axes.left);
        // The caption's line ends half a font above its middle.
        EXPECT_GE(at.part.bottom, (caption ? 1.7 : 0.5) * at.font);
        if (!bar) continue;
        EXPECT_TRUE(is_inside(at.bar, size));
        EXPECT_LE(at.part.right, at.bar.left);
        EXPECT_LT(axes.top, at.bar.bottom);
      }
}

TEST(ColourBar, ShowsThePaletteFromBelowWithoutGaps) {
  Picture picture = seen_from("iso");
  const Layout at = layout(picture.size, {});
  add_colour_bar(picture, at, {.title = {}, .ticks = {}, .notes = {}});
  ASSERT_EQ(picture.polygons.size(), 4U);  // the frame, then the colours over it
  double below = at.bar.bottom;
  for (std::size_t i = 0; i < 3; ++i) {
    const Box box = around(picture.polygons[i + 1]);
    EXPECT_EQ(picture.polygons[i + 1].colour, picture.palette[i]);
    EXPECT_NEAR(box.bottom, below, 1e-9);
    EXPECT_NEAR(box.top - box.bottom, (at.bar.top - at.bar.bottom) / 3, 1e-9);
    below = box.top;
  }
  EXPECT_NEAR(below, at.bar.top, 1e-9);
}

TEST(ColourBar, WritesNumbersAtTheirMarksTitleAboveAndNotesBelow) {
  for (const PictureSize& size : sizes) {
    Picture picture = seen_from("iso", size);
    const Layout at = layout(size, {});
    add_colour_bar(picture, at,
                   {.title = {"von Mises", "MPa"},
                    .ticks = {{0, "0"}, {0.5, "175"}, {1, "350"}},
                    .notes = {"max 375.8"}});
    for (const auto& [word, share] : {std::pair("0", 0.0), std::pair("175", 0.5), std::pair("350", 1.0)}) {
      const PictureText& number = text_of(picture, word);
      EXPECT_NEAR(number.y, at.bar.bottom + share * (at.bar.top - at.bar.bottom), 1e-9);
      EXPECT_GT(number.x, at.bar.right);
      const bool is_marked =
          std::any_of(picture.polygons.begin() + 4, picture.polygons.end(), [&](const PicturePolygon& p) {
            const Box mark = around(p);
            return std::abs((mark.bottom + mark.top) / 2 - number.y) < 1e-9 && mark.right < number.x;
          });
      EXPECT_TRUE(is_marked) << word;
    }
    EXPECT_GT(text_of(picture, "von Mises").y, text_of(picture, "MPa").y);
    EXPECT_GT(text_of(picture, "MPa").y, at.bar.top + at.font / 2);  // clear of the number at the top
    EXPECT_LT(text_of(picture, "max 375.8").y, at.bar.bottom - at.font / 2);
    for (const PictureText& text : picture.texts) {
      EXPECT_GT(text.y - text.font / 2, 0) << text.text;
      EXPECT_LT(text.y + text.font / 2, size.height) << text.text;
    }
  }
}

TEST(Axes, PointAsTheyLieInTheView) {
  Picture front = seen_from("front");
  const Layout at = layout(front.size, {});
  add_axes(front, at);
  EXPECT_THAT(words(front), testing::UnorderedElementsAre("x", "z"));  // y points away from the eye
  EXPECT_GT(text_of(front, "x").x, at.axes_x + at.axes);
  EXPECT_NEAR(text_of(front, "x").y, at.axes_y, 1e-9);
  EXPECT_GT(text_of(front, "z").y, at.axes_y + at.axes);
  EXPECT_NEAR(text_of(front, "z").x, at.axes_x, 1e-9);
}

TEST(Axes, ThatPointTowardsTheEyeLieOverTheOthers) {
  Picture picture = seen_from("iso");
  const Layout at = layout(picture.size, {});
  add_axes(picture, at);
  // From the right, the front and above: x and z come towards the eye, y goes away from it.
  ASSERT_EQ(picture.texts.size(), 3U);
  EXPECT_EQ(picture.texts.front().text, "y");
  ASSERT_EQ(picture.polygons.size(), 6U);  // a shaft and a head each
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(picture.polygons[2 * i].colour, picture.texts[i].colour);
    EXPECT_EQ(picture.polygons[2 * i + 1].colour, picture.texts[i].colour);
    // The letter stands beyond the head's tip.
    const Eigen::Vector2d origin(at.axes_x, at.axes_y);
    const Eigen::Vector2d letter(picture.texts[i].x, picture.texts[i].y);
    EXPECT_GT((letter - origin).norm(), (picture.polygons[2 * i + 1].corners[1] - origin).norm());
  }
}

TEST(Caption, StandsBelowThePart) {
  Picture picture = seen_from("top");
  const Layout at = layout(picture.size, {});
  add_caption(picture, at, "a link");
  EXPECT_THAT(words(picture), ElementsAre("a link"));
  EXPECT_LT(picture.texts[0].y + picture.texts[0].font / 2, at.part.bottom);
}

}  // namespace
}  // namespace isopatch::app

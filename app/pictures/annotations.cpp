#include "app/pictures/annotations.hpp"

#include <algorithm>

namespace isopatch::app {
namespace {

constexpr Colour ink = {34, 34, 34};

PicturePolygon rectangle(const Box& box, const Colour& colour) {
  return {{{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}},
          colour};
}

void add_strip(Picture& picture, const Box& box, double line) {
  picture.polygons.push_back(
      rectangle({box.left - line, box.bottom - line, box.right + line, box.top + line}, ink));
  const auto count = static_cast<double>(picture.palette.size());
  const double height = box.top - box.bottom;
  for (std::size_t i = 0; i < picture.palette.size(); ++i) {
    const auto from = static_cast<double>(i);
    picture.polygons.push_back(rectangle(
        {box.left, box.bottom + from / count * height, box.right, box.bottom + (from + 1) / count * height},
        picture.palette[i]));
  }
}

/// An arrow from the cross' centre.
void add_arrow(Picture& picture, const Layout& layout, const Eigen::Vector2d& direction,
               const Colour& colour) {
  const Eigen::Vector2d start(layout.axes_x, layout.axes_y);
  const Eigen::Vector2d end = start + layout.axes * direction;
  const double length = (end - start).norm();
  const double width = 0.09 * layout.font;
  const Eigen::Vector2d along = direction.normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const double head = std::min(0.55 * layout.font, 0.6 * length);
  const Eigen::Vector2d neck = end - head * along;
  picture.polygons.push_back(
      {{start - width * across, neck - width * across, neck + width * across, start + width * across},
       colour});
  picture.polygons.push_back({{neck - 0.42 * head * across, end, neck + 0.42 * head * across}, colour});
}

}  // namespace

void add_colour_bar(Picture& picture, const Layout& layout, const ColourBar& bar) {
  const double line = std::max(1.0, 0.04 * layout.font);
  const double step = 1.25 * layout.font;
  add_strip(picture, layout.bar, line);
  double y = layout.bar.top + 1.4 * layout.font + step * static_cast<double>(bar.title.size());
  for (const std::string& text : bar.title)
    picture.texts.push_back({text, layout.bar.left, y -= step, layout.font, Align::left, ink});
  for (const Tick& tick : bar.ticks) {
    const double at = layout.bar.bottom + tick.position * (layout.bar.top - layout.bar.bottom);
    const double right = layout.bar.right + 0.35 * layout.font;
    picture.polygons.push_back(rectangle({layout.bar.right, at - line / 2, right, at + line / 2}, ink));
    picture.texts.push_back({tick.text, right + 0.3 * layout.font, at, layout.font, Align::left, ink});
  }
  y = layout.bar.bottom - 0.2 * layout.font;
  for (const std::string& text : bar.notes)
    picture.texts.push_back({text, layout.bar.left, y -= step, 0.8 * layout.font, Align::left, ink});
}

void add_axes(Picture& picture, const Layout& layout) {
  const View& view = picture.camera.view;
  constexpr std::array<Colour, 3> colours = {{{190, 55, 45}, {45, 130, 60}, {45, 85, 175}}};
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return view.toward_eye[a] < view.toward_eye[b]; });
  for (const int axis : order) {
    const Eigen::Vector2d direction(view.right[axis], view.up[axis]);
    if (direction.norm() < 0.05) continue;  // it points at the eye
    const auto i = static_cast<std::size_t>(axis);
    add_arrow(picture, layout, direction, colours[i]);
    const Eigen::Vector2d place = Eigen::Vector2d(layout.axes_x, layout.axes_y) + layout.axes * direction +
                                  0.6 * layout.font * direction.normalized();
    picture.texts.push_back({names[i], place.x(), place.y(), 0.9 * layout.font, Align::centre, colours[i]});
  }
}

void add_caption(Picture& picture, const Layout& layout, const std::string& caption) {
  picture.texts.push_back({caption, layout.margin, 1.2 * layout.font, layout.font, Align::left, ink});
}

}  // namespace isopatch::app

#include "app/plots/internal/legend.hpp"

namespace isopatch::app {

constexpr double left = 10;
constexpr double title_bottom = 28;
constexpr double row_height = 18;
constexpr double sample_width = 22;
constexpr double gap = 6;

Legend::Legend(std::vector<Entry> entries, double width)
    : entries_(std::move(entries)), bottom_(title_bottom) {
  SvgPoint place = {left, title_bottom};
  for (Entry& entry : entries_) {
    entry.text = fitted(entry.text, text_size, width - 2 * left - sample_width - gap);
    const double entry_width = sample_width + gap + text_width(entry.text, text_size);
    if (!entry.text.empty()) {
      if (place.x > left && place.x + entry_width > width - left) place = {left, place.y + row_height};
      bottom_ = place.y + row_height;
    }
    places_.push_back({place.x, place.y + row_height / 2});
    if (!entry.text.empty()) place.x += entry_width + 3 * gap;
  }
}

void Legend::draw(Svg& svg) const {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const SvgPoint at = places_[i];
    if (entry.text.empty()) continue;
    if (entry.sample == Sample::area)
      svg.rectangle({at.x + 4, at.y - 6}, 14, 12, "f" + colour_class(i));
    else
      svg.line(at, {at.x + sample_width, at.y},
               "curve s" + colour_class(i) + (entry.sample == Sample::dashed_line ? " dashed" : ""));
    if (entry.marker) svg.marker({at.x + sample_width / 2, at.y}, i);
    svg.text({at.x + sample_width + gap, at.y + 4}, entry.text);
  }
}

}  // namespace isopatch::app

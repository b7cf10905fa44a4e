#pragma once

#include <string>
#include <vector>

#include "app/plots/internal/svg.hpp"

namespace isopatch::app {

/// Names in rows below the title, each with a sample of its series in front.
class Legend {
 public:
  enum class Sample { line, dashed_line, area };
  struct Entry {
    std::string text;
    Sample sample = Sample::line;
    bool marker = false;
  };

  /// Entries with an empty text do not appear but keep their colour.
  /// @param width  of the picture
  Legend(std::vector<Entry> entries, double width);

  /// The end of the legend, or of the title if there is none.
  double bottom() const { return bottom_; }
  void draw(Svg& svg) const;

 private:
  std::vector<Entry> entries_;
  std::vector<SvgPoint> places_;
  double bottom_;
};

}  // namespace isopatch::app

#pragma once

#include <string>

namespace isopatch::app {

/// What SI values are multiplied with to be shown, and the unit behind them: {"mm", 1e3}.
struct DisplayUnit {
  std::string unit;
  double factor = 1;
};

}  // namespace isopatch::app

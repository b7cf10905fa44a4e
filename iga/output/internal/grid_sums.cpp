#include "iga/output/internal/grid_sums.hpp"

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

void GridSums::plane(int combination, Plane& out) const {
  const GridLine& line = lines_[2];
  const int rows = patch_.size(1), length = patch_.size(0);
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(length);
  out.value.resize(count);
  out.d3.resize(count);
  const auto from = static_cast<std::size_t>(line.first[static_cast<std::size_t>(combination)]);
  const double* const x = patch_.control_points().data();
  const double* const u = displacement_.data();
  const double* const weights = patch_.weights().data();
  parallel_ranges(rows, [&](std::int64_t row, int) {
    const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(length);
    for (std::size_t at = begin; at < begin + static_cast<std::size_t>(length); ++at) {
      FieldLanes<8> value = FieldLanes<8>::Zero(), d3 = FieldLanes<8>::Zero();
      for (Eigen::Index a = 0; a < line.values.cols(); ++a) {
        const std::size_t i = at + count * (from + static_cast<std::size_t>(a));
        const double w = weights[i];
        FieldLanes<8> coefficient;
        coefficient << w * x[3 * i], w * x[3 * i + 1], w * x[3 * i + 2], w, w * u[3 * i], w * u[3 * i + 1],
            w * u[3 * i + 2], 0.0;
        value += line.values(combination, a) * coefficient;
        d3 += line.derivatives(combination, a) * coefficient;
      }
      out.value[at] = value;
      out.d3[at] = d3;
    }
  });
}

void GridSums::row(int combination, const Plane& plane, Row& out) const {
  const GridLine& line = lines_[1];
  const auto length = static_cast<std::size_t>(patch_.size(0));
  const auto from = static_cast<std::size_t>(line.first[static_cast<std::size_t>(combination)]);
  for (auto* lanes : {&out.value, &out.d2, &out.d3}) lanes->assign(length, FieldLanes<8>::Zero());
  for (Eigen::Index a = 0; a < line.values.cols(); ++a) {
    const double value = line.values(combination, a), derivative = line.derivatives(combination, a);
    const std::size_t begin = length * (from + static_cast<std::size_t>(a));
    for (std::size_t i = 0; i < length; ++i) {
      out.value[i] += value * plane.value[begin + i];
      out.d2[i] += derivative * plane.value[begin + i];
      out.d3[i] += value * plane.d3[begin + i];
    }
  }
}

}  // namespace isopatch::iga

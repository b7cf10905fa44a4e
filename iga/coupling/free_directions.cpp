#include "iga/coupling/free_directions.hpp"

#include <algorithm>

namespace isopatch::iga {

FreeDirections::FreeDirections(const std::vector<const SupportFrame*>& frame_of_row) {
  for (std::size_t row = 0; row < frame_of_row.size(); ++row) {
    const SupportFrame& frame = *frame_of_row[row];
    if (frame.free < 3) held_.push_back({static_cast<int>(row), frame.free, frame.axes});
  }
}

Eigen::VectorXd FreeDirections::to_space(Eigen::VectorXd x) const {
  for (const Held& held : held_) {
    const Eigen::Vector3d along = x.segment<3>(3 * held.row);
    x.segment<3>(3 * held.row) = held.axes.leftCols(held.free) * along.head(held.free);
  }
  return x;
}

Eigen::VectorXd FreeDirections::to_free(Eigen::VectorXd force) const {
  for (const Held& held : held_) {
    Eigen::Vector3d along = held.axes.transpose() * force.segment<3>(3 * held.row);
    along.tail(3 - held.free).setZero();
    force.segment<3>(3 * held.row) = along;
  }
  return force;
}

std::vector<SupportFrame> FreeDirections::frames(int rows) const {
  std::vector<SupportFrame> result(static_cast<std::size_t>(rows));
  for (const Held& held : held_) {
    result[static_cast<std::size_t>(held.row)].axes = held.axes;
    result[static_cast<std::size_t>(held.row)].free = held.free;
  }
  return result;
}

const FreeDirections::Held* FreeDirections::find(int row) const {
  const auto found = std::lower_bound(held_.begin(), held_.end(), row,
                                      [](const Held& held, int wanted) { return held.row < wanted; });
  return found != held_.end() && found->row == row ? &*found : nullptr;
}

bool FreeDirections::can_move(int row, int axis) const {
  const Held* const held = find(row);
  return !held || held->axes.row(axis).head(held->free).norm() > 1e-8;
}

}  // namespace isopatch::iga

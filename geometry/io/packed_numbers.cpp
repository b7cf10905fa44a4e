#include "geometry/io/packed_numbers.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

void PackedNumbers::write(Hdf5Writer& file, const std::string& path, Eigen::Index rows) const {
  if (rows == 1)
    file.write(path, numbers_);
  else
    file.write(path, Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(
                         numbers_.data(), rows, static_cast<Eigen::Index>(numbers_.size()) / rows)));
}

UnpackedNumbers::UnpackedNumbers(const Hdf5Reader& file, const std::string& path, int rows)
    : values_(rows == 1 ? Eigen::MatrixXd(file.vector(path).transpose()) : file.matrix(path, rows)),
      path_(path) {}

void UnpackedNumbers::require(Eigen::Index count) const {
  if (count > values_.cols() - taken_)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} ends early: {} columns are too few", path_, values_.cols()));
}

Eigen::MatrixXd UnpackedNumbers::take(Eigen::Index count) {
  require(count);
  taken_ += count;
  return values_.middleCols(taken_ - count, count);
}

void UnpackedNumbers::require_end() const {
  if (taken_ != values_.cols())
    throw Error(ErrorCode::invalid_argument, fmt::format("{} has {} columns, of which {} belong to patches",
                                                         path_, values_.cols(), taken_));
}

}  // namespace isopatch::geometry

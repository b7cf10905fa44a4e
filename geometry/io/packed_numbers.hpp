#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"

namespace isopatch::geometry {

/// Numbers of many things one after the other in one dataset: files of many small datasets take long to
/// write.
class PackedNumbers {
 public:
  template <class Matrix>
  void add(const Matrix& values) {
    numbers_.insert(numbers_.end(), values.data(), values.data() + values.size());
  }
  /// @param rows  of the matrix that the numbers are; 1: a vector
  void write(Hdf5Writer& file, const std::string& path, Eigen::Index rows) const;

 private:
  std::vector<double> numbers_;
};

/// Takes numbers off one after the other.
class UnpackedNumbers {
 public:
  /// @throws Error bad_format  as the reader does
  UnpackedNumbers(const Hdf5Reader& file, const std::string& path, int rows);

  /// @throws Error invalid_argument  if fewer columns are left, naming the dataset
  void require(Eigen::Index count) const;
  /// (rows, count); throws as `require` does.
  Eigen::MatrixXd take(Eigen::Index count);
  /// @throws Error invalid_argument  if columns are left
  void require_end() const;

 private:
  Eigen::MatrixXd values_;
  std::string path_;
  Eigen::Index taken_ = 0;
};

}  // namespace isopatch::geometry

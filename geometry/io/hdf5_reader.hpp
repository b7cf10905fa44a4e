#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace isopatch::geometry {

/// An HDF5 file opened for reading. Every error names file and dataset.
class Hdf5Reader {
 public:
  /// Most numbers (or characters) read from one dataset: a broken file cannot ask for more memory than this.
  static constexpr std::int64_t max_values = std::int64_t{1} << 31;

  /// @throws Error io          a file that is missing or cannot be read
  /// @throws Error bad_format  not an HDF5 file, or a damaged or truncated one
  explicit Hdf5Reader(const std::filesystem::path& path);
  ~Hdf5Reader();
  Hdf5Reader(Hdf5Reader&&) noexcept;
  Hdf5Reader& operator=(Hdf5Reader&&) noexcept;

  /// Whether there is a dataset or a group at the path.
  bool contains(const std::string& path) const;
  /// Names inside a group, sorted.
  std::vector<std::string> names(const std::string& group) const;

  /// @throws Error bad_format  for each: no such dataset, another type or shape, too large, damaged or
  ///                           changed since it was written
  /// @param rows  number of rows the matrix must have; -1: any
  Eigen::MatrixXd matrix(const std::string& path, int rows = -1) const;
  /// @param size  number of entries the vector must have; -1: any
  Eigen::VectorXd vector(const std::string& path, std::int64_t size = -1) const;
  std::vector<std::int64_t> integers(const std::string& path, std::int64_t size = -1) const;
  std::int64_t integer(const std::string& path) const;
  double number(const std::string& path) const;
  std::string text(const std::string& path) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isopatch::geometry

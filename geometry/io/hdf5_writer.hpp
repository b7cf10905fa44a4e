#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isopatch::geometry {

/// An HDF5 file put together in memory.
///
/// Datasets are named by their path, "/fields/displacement"; groups on the way are created. Matrices are
/// stored with one row of the file per column here, so that points (3, n) become n rows of 3 for other
/// readers. Each dataset has an attribute "checksum" (isopatch::content_hash), by which `Hdf5Reader` sees
/// bytes that have changed since.
class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(Hdf5Writer&&) noexcept;
  Hdf5Writer& operator=(Hdf5Writer&&) noexcept;

  /// @throws Error invalid_argument  for a path that is empty, relative or taken
  void write(const std::string& path, const Eigen::MatrixXd& values);
  void write(const std::string& path, const Eigen::Matrix3Xd& values);
  void write(const std::string& path, const Eigen::VectorXd& values);
  void write(const std::string& path, const std::vector<double>& values);
  void write(const std::string& path, const std::vector<std::int64_t>& values);
  void write(const std::string& path, std::int64_t value);
  void write(const std::string& path, double value);
  void write(const std::string& path, const std::string& text);
  void write(const std::string& path, const char* text) { write(path, std::string(text)); }

  /// The file's content, for isopatch::write_file. The writer can go on afterwards.
  std::string image() const { return std::string(view()); }
  /// The same without a copy; valid until the next call of `write`.
  std::string_view view() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isopatch::geometry

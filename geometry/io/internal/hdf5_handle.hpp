#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/base/content_hash.hpp"

namespace isopatch::geometry {

/// An HDF5 identifier that closes itself. For the .cpp files of this folder only.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }

  explicit operator bool() const { return id_ >= 0; }
  operator hid_t() const { return id_; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Name of the attribute that tells whether a dataset is still as it was written.
inline constexpr const char* checksum_name = "checksum";

/// What that attribute says: of shape and content.
inline std::uint64_t dataset_checksum(const std::vector<hsize_t>& shape, const void* data,
                                      std::size_t bytes) {
  const std::string_view extents(reinterpret_cast<const char*>(shape.data()), shape.size() * sizeof(hsize_t));
  return content_hash({static_cast<const char*>(data), bytes}, content_hash(extents));
}

/// Keeps HDF5 from printing its errors while it lives, and for good from closing itself when the program
/// ends: all that we open is closed by then, and after some damaged files it would print "infinite loop
/// closing library".
class Hdf5Silence {
 public:
  Hdf5Silence() {
    [[maybe_unused]] static const herr_t first_call = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

}  // namespace isopatch::geometry

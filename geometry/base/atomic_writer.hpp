#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace isopatch {

/// A file written piece by piece that appears whole or not at all, as with `write_file`: pieces go to a
/// temporary file beside it; `finish` synchronises and renames it. Without `finish` the temporary file is
/// removed and an earlier file of that name stays as it was.
///
/// One file is written at a time: a second writer waits until the first is gone, so one thread must not hold
/// two.
class AtomicWriter {
 public:
  /// @throws Error io, as every function here: with the path and the system's reason (no space left, ...)
  explicit AtomicWriter(const std::filesystem::path& path);
  ~AtomicWriter();
  AtomicWriter(AtomicWriter&&) = delete;

  void write(std::string_view bytes);
  /// Writes bytes at a place of the file, wherever `write` goes on; what is never written reads as zeros.
  void write_at(std::uint64_t place, std::string_view bytes);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isopatch

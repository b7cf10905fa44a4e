#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace isopatch::geometry {

/// Whole numbers one after the other, as records of a file.
class NumberList {
 public:
  NumberList() = default;
  NumberList(std::vector<std::int64_t> numbers, std::string path)
      : numbers_(std::move(numbers)), path_(std::move(path)) {}

  template <class... Numbers>
  void add(Numbers... numbers) {
    (numbers_.push_back(static_cast<std::int64_t>(numbers)), ...);
  }
  const std::vector<std::int64_t>& numbers() const { return numbers_; }

  bool at_end() const { return next_ == numbers_.size(); }
  /// The next number. What fits no int becomes -1, which is no index.
  /// @throws Error invalid_argument  at the end of the list
  int next();
  bool next_flag() { return next() != 0; }
  /// The next number as a count of records that follow.
  /// @throws Error invalid_argument  for a negative one, or one above what the list can hold
  std::size_t next_count();

 private:
  std::vector<std::int64_t> numbers_;
  std::string path_;
  std::size_t next_ = 0;
};

}  // namespace isopatch::geometry

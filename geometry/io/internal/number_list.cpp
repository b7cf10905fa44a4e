#include "geometry/io/internal/number_list.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

int NumberList::next() {
  if (at_end()) throw Error(ErrorCode::invalid_argument, fmt::format("'{}' ends within a record", path_));
  const std::int64_t number = numbers_[next_++];
  return number < 0 || number > 1'000'000'000 ? -1 : static_cast<int>(number);
}

std::size_t NumberList::next_count() {
  const int count = next();
  if (count < 0 || static_cast<std::size_t>(count) > numbers_.size())
    throw Error(ErrorCode::invalid_argument, fmt::format("'{}' announces more than it has", path_));
  return static_cast<std::size_t>(count);
}

}  // namespace isopatch::geometry

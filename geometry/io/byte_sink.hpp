#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace isopatch::geometry {

/// Takes a file's bytes, from the first to the last.
using ByteSink = std::function<void(std::string_view)>;

/// Takes a file's bytes in any order, each piece with the place of its first byte.
using PlacedByteSink = std::function<void(std::uint64_t place, std::string_view bytes)>;

}  // namespace isopatch::geometry

#pragma once

#include <cstdint>
#include <string_view>

namespace isopatch {

/// A number that tells whether bytes are still the same: a change within eight bytes in a row (counted from
/// the start) always changes it, any other change but for one in 2^64. No protection against intent.
///
/// @param before  of what comes before the bytes, so that several pieces have one number
/// @cost  some 0.3 ns per byte
std::uint64_t content_hash(std::string_view bytes, std::uint64_t before = 0);

}  // namespace isopatch

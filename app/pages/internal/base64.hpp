#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace isopatch::app {

/// The bytes of single precision numbers, little-endian, as base64 (RFC 4648).
std::string to_base64(const std::vector<float>& numbers);
/// The same of numbers of 16 bits.
std::string short_to_base64(const std::vector<std::int16_t>& numbers);

}  // namespace isopatch::app

#pragma once

#include <string>
#include <vector>

namespace isopatch::app {

/// The bytes of single precision numbers, little-endian, as base64 (RFC 4648).
std::string to_base64(const std::vector<float>& numbers);

}  // namespace isopatch::app

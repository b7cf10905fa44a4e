#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {

/// Whether a `format` attribute of a G+Smo file asks for base64: "B64Float64" and the like, in any case.
bool is_base64(std::string_view format);

/// The numbers that a base64 text holds, as little-endian bytes one after the other.
/// @param format  B64Float64, B64Float32, B64Int16, B64Int32, B64Int64, B64Uint16, B64Uint32 or B64Uint64
/// @param in      for messages: file and line
/// @param what    the numbers, for messages
/// @throws Error unsupported  another format
/// @throws Error bad_format   letters that are not base64, pieces of numbers, numbers that are not finite
std::vector<double> base64_numbers(std::string_view text, std::string_view format, const TextScanner& in,
                                   const std::string& what);

}  // namespace isopatch::geometry

#include "geometry/io/internal/base64_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace isopatch::geometry {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return result;
}

// The six bits of a letter, or -1.
int six_bits(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string bytes_of(std::string_view text, const TextScanner& in, const std::string& what) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;  // of bits that wait
  int padding = 0;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c))) continue;
    const int six = six_bits(c);
    if (c == '=' && ++padding <= 2) continue;
    if (six < 0 || padding > 0)
      in.fail(fmt::format("{}: {} does not belong into base64 here", what, quoted({&c, 1})));
    bits = bits << 6 | static_cast<std::uint32_t>(six);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFF);
    }
  }
  if (count >= 6) in.fail(fmt::format("{}: the base64 text is cut off", what));
  return bytes;
}

template <class Number>
std::vector<double> numbers_of(const std::string& bytes, const TextScanner& in, const std::string& what) {
  if (bytes.size() % sizeof(Number) != 0)
    in.fail(fmt::format("{}: {} bytes of base64 are no whole numbers of {} bytes", what, bytes.size(),
                        sizeof(Number)));
  std::vector<double> result(bytes.size() / sizeof(Number));
  for (std::size_t i = 0; i < result.size(); ++i) {
    Number number = 0;
    std::memcpy(&number, bytes.data() + i * sizeof(Number), sizeof(Number));
    result[i] = static_cast<double>(number);
    if (!std::isfinite(result[i])) in.fail(fmt::format("{} {} is {}; it must be finite", what, i, result[i]));
  }
  return result;
}

}  // namespace

bool is_base64(std::string_view format) {
  return lower(format).starts_with("b64");
}

std::vector<double> base64_numbers(std::string_view text, std::string_view format, const TextScanner& in,
                                   const std::string& what) {
  const std::string kind = lower(format);
  const std::string bytes = bytes_of(text, in, what);
  if (kind == "b64float64") return numbers_of<double>(bytes, in, what);
  if (kind == "b64float32") return numbers_of<float>(bytes, in, what);
  if (kind == "b64int16") return numbers_of<std::int16_t>(bytes, in, what);
  if (kind == "b64int32") return numbers_of<std::int32_t>(bytes, in, what);
  if (kind == "b64int64") return numbers_of<std::int64_t>(bytes, in, what);
  if (kind == "b64uint16") return numbers_of<std::uint16_t>(bytes, in, what);
  if (kind == "b64uint32") return numbers_of<std::uint32_t>(bytes, in, what);
  if (kind == "b64uint64") return numbers_of<std::uint64_t>(bytes, in, what);
  in.fail(fmt::format("{}: numbers in format {}; ASCII, B64Float64 and B64Float32 are the usual ones", what,
                      quoted(format)),
          ErrorCode::unsupported);
}

}  // namespace isopatch::geometry

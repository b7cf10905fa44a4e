#include "app/pages/internal/base64.hpp"

#include <bit>
#include <cstdint>

namespace isopatch::app {

std::string to_base64(const std::vector<float>& numbers) {
  constexpr const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((4 * numbers.size() + 2) / 3 * 4);
  std::uint32_t bits = 0;
  int count = 0;  // bytes in `bits`
  const auto flush = [&](int bytes) {
    bits <<= 8 * (3 - bytes);
    for (int i = 0; i < 4; ++i) text += i <= bytes ? alphabet[bits >> (18 - 6 * i) & 63] : '=';
    bits = 0;
    count = 0;
  };
  for (const float number : numbers) {
    const auto word = std::bit_cast<std::uint32_t>(number);
    for (int byte = 0; byte < 4; ++byte) {
      bits = bits << 8 | (word >> (8 * byte) & 255);
      if (++count == 3) flush(3);
    }
  }
  if (count > 0) flush(count);
  return text;
}

}  // namespace isopatch::app

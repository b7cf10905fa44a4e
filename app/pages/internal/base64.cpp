#include "app/pages/internal/base64.hpp"

#include <bit>
#include <cstdint>

namespace isopatch::app {

namespace {

// The bytes of numbers, each of `Word`, the lowest first.
template <class Word, class Number>
std::string encoded(const std::vector<Number>& numbers) {
  constexpr const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  constexpr int size = sizeof(Number);
  text.reserve((size * numbers.size() + 2) / 3 * 4);
  std::uint32_t bits = 0;
  int count = 0;  // bytes in `bits`
  const auto flush = [&](int bytes) {
    bits <<= 8 * (3 - bytes);
    for (int i = 0; i < 4; ++i) text += i <= bytes ? alphabet[bits >> (18 - 6 * i) & 63] : '=';
    bits = 0;
    count = 0;
  };
  for (const Number number : numbers) {
    const auto word = std::uint32_t{std::bit_cast<Word>(number)};
    for (int byte = 0; byte < size; ++byte) {
      bits = bits << 8 | (word >> (8 * byte) & 255);
      if (++count == 3) flush(3);
    }
  }
  if (count > 0) flush(count);
  return text;
}

}  // namespace

std::string to_base64(const std::vector<float>& numbers) {
  return encoded<std::uint32_t>(numbers);
}

std::string short_to_base64(const std::vector<std::int16_t>& numbers) {
  return encoded<std::uint16_t>(numbers);
}

}  // namespace isopatch::app

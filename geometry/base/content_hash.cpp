#include "geometry/base/content_hash.hpp"

#include <cstring>

namespace isopatch {
namespace {

/// A one-to-one function of each of its arguments, so that a change of one word is never lost.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15;  // the golden ratio times 2^64
  hash = (hash ^ word) * odd;
  return hash ^ (hash >> 32);
}

}  // namespace

std::uint64_t content_hash(std::string_view bytes, std::uint64_t before) {
  std::uint64_t hash = mixed(before, bytes.size());
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t count = bytes.size() < sizeof(word) ? bytes.size() : sizeof(word);
    std::memcpy(&word, bytes.data(), count);
    bytes.remove_prefix(count);
    hash = mixed(hash, word);
  }
  return hash;
}

}  // namespace isopatch

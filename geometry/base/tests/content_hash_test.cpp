#include "geometry/base/content_hash.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace isopatch {
namespace {

TEST(ContentHash, EveryChangeOfABitChangesIt) {
  std::string bytes;
  for (int i = 0; i < 61; ++i) bytes += static_cast<char>(37 * i);
  std::set<std::uint64_t> seen = {content_hash(bytes)};
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = bytes;
      other[at] = static_cast<char>(other[at] ^ 1 << bit);
      EXPECT_TRUE(seen.insert(content_hash(other)).second) << at << " " << bit;
    }
}

TEST(ContentHash, KnowsLengthAndWhatCameBefore) {
  EXPECT_NE(content_hash(std::string(8, '\0')), content_hash(std::string(9, '\0')));
  EXPECT_NE(content_hash(""), content_hash(std::string(1, '\0')));
  EXPECT_NE(content_hash("b", content_hash("a")), content_hash("a", content_hash("b")));
  EXPECT_EQ(content_hash("ab"), content_hash("ab"));
}

}  // namespace
}  // namespace isopatch

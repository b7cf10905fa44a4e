#pragma once

#include <gtest/gtest.h>

#include <string>

#include "geometry/base/error.hpp"

namespace isopatch::test {

/// "bad_format: ..." of the error that work ends with; "no error" if it ends with none.
template <class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return std::string(name(error.code())) + ": " + error.what();
  }
  return "no error";
}

/// Whether work ends with an error of this cause whose message has these words.
template <class Work>
testing::AssertionResult ends_with(const Work& work, ErrorCode cause, const std::string& words) {
  const std::string found = message_of(work), expected = std::string(name(cause)) + ": ";
  if (!words.empty() && found.rfind(expected, 0) == 0 && found.find(words, expected.size()) != found.npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "expected " << expected << "... " << words << " ...\nfound    "
                                     << found;
}

}  // namespace isopatch::test

/// The expression must end with an `Error` of this cause and these words, which are some.
#define EXPECT_ERROR(expression, cause, words) \
  EXPECT_TRUE(::isopatch::test::ends_with([&] { static_cast<void>(expression); }, cause, words))

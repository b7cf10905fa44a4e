#pragma once

#include <string>

#include "geometry/base/error.hpp"

namespace isopatch::geometry::test {

/// "bad_format: ..." of the error that work ends with.
template <class Work>
std::string message_of(Work work) {
  try {
    work();
  } catch (const Error& error) {
    return std::string(name(error.code())) + ": " + error.what();
  }
  return "no error";
}

}  // namespace isopatch::geometry::test

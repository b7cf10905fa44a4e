#pragma once

#include <new>
#include <optional>
#include <string>

#include "geometry/base/error.hpp"

namespace isopatch::app {

/// What a run gives, or nothing and the reason if there is no memory for it.
template <class Run>
auto if_it_fits(const Run& run, std::string& reason) -> std::optional<decltype(run())> {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    reason = "out of memory";
  } catch (const Error& error) {
    if (error.code() != ErrorCode::out_of_memory) throw;
    reason = error.what();
  }
  return std::nullopt;
}

}  // namespace isopatch::app

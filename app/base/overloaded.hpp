#pragma once

namespace isopatch::app {

/// One function object made of several, for std::visit: Overloaded{[](const A&) { ... }, [](const B&) { ...
/// }}.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace isopatch::app

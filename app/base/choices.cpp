#include "app/base/choices.hpp"

namespace isopatch::app {

std::string quoted_list(const std::vector<std::string>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) result += i + 1 == names.size() ? " or " : ", ";
    result += "\"" + names[i] + "\"";
  }
  return result;
}

}  // namespace isopatch::app

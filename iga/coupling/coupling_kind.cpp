#include "iga/coupling/coupling_kind.hpp"

namespace isopatch::iga {

std::string_view name(Coupling coupling) {
  return coupling == Coupling::elimination ? "elimination" : "lagrange";
}

}  // namespace isopatch::iga

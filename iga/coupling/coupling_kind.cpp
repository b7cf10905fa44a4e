#include "iga/coupling/coupling_kind.hpp"

namespace isopatch::iga {

std::string_view name(Coupling coupling) {
  return coupling == Coupling::elimination ? "elimination" : "lagrange";
}

std::string_view name(NonMatchingCoupling coupling) {
  return coupling == NonMatchingCoupling::nitsche ? "nitsche" : "mortar";
}

}  // namespace isopatch::iga

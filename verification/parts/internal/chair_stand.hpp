#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// One fifth of a five-star swivel chair base: a slotted arm between a hub and the hole of a caster's pin.
/// From the dimensions of the model published with G+Smo.
Part chair_stand();

}  // namespace isopatch::parts

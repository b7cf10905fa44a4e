#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// One fifth of a five-star swivel chair base: a slotted arm between a hub and the hole of a caster's pin.
/// From the dimensions of the model published with G+Smo.
Part chair_stand();

/// The same with a fifth of the ring of the inner cylinder in its hub and a hollow pin in the hole: bodies
/// "stand", "ring" and "pin".
Part chair_stand_with_ring_and_pin();

}  // namespace isopatch::parts

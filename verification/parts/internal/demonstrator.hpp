#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// The TERRIFIC demonstrator: two eyes with bores, joined by a bow whose outer wall is freeform, with two
/// drafted pockets. From the dimensions of the model published with G+Smo, without the blends of its pockets.
Part demonstrator();

}  // namespace isopatch::parts

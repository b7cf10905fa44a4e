#pragma once

#include <variant>

#include "geometry/models/box.hpp"
#include "geometry/models/bracket.hpp"
#include "geometry/models/cook.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/models/elbow.hpp"
#include "geometry/models/elliptic_plate.hpp"
#include "geometry/models/link.hpp"
#include "geometry/models/plate.hpp"
#include "geometry/models/sphere.hpp"
#include "geometry/models/twisted_beam.hpp"

namespace isopatch::app {

/// A generated model and its dimensions, model units: which model it is, its options say.
using GeneratedDimensions =
    std::variant<geometry::BoxOptions, geometry::CylinderOptions, geometry::LinkOptions,
                 geometry::SphereOptions, geometry::PlateOptions, geometry::BracketOptions,
                 geometry::CookOptions, geometry::ElbowOptions, geometry::EllipticPlateOptions,
                 geometry::TwistedBeamOptions>;

struct GeneratedInput {
  GeneratedDimensions dimensions;
  double length_unit = 1;  ///< m per model unit; above 0
  bool operator==(const GeneratedInput&) const = default;
};

}  // namespace isopatch::app

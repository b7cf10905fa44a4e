#pragma once

#include <array>

namespace isopatch::iga {

/// Energy of the part of the stresses that needs the functions' full degree within elements: small where
/// displacements are well represented. Its share of the internal energy is about the relative error of the
/// energy, and so of displacements under loads.
struct UnresolvedEnergy {
  std::array<double, 3> along = {0, 0, 0};  ///< of what needs the full degree along each direction, J
  double volumetric = 0;                    ///< of mean stresses, J: most of it where nearly incompressible

  double total() const { return along[0] + along[1] + along[2]; }
  UnresolvedEnergy& operator+=(const UnresolvedEnergy& other) {
    for (std::size_t d = 0; d < 3; ++d) along[d] += other.along[d];
    volumetric += other.volumetric;
    return *this;
  }
};

}  // namespace isopatch::iga

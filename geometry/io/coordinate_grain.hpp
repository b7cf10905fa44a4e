#pragma once

#include <string_view>

namespace isopatch::geometry {

/// Finds out by how much a program rounded the coordinates that it wrote as text.
class CoordinateGrain {
 public:
  void add(std::string_view word, double value);
  /// The step of the largest coordinate, by the most digits that were seen; the others have this or a smaller
  /// one. Round-off alone where all have fewer than five, as a cube of size 1.
  double step() const;

 private:
  int digits_ = 0;
  double largest_ = 0;
};

/// The step of numbers of 32 bits around a value.
double float_step(double value);

}  // namespace isopatch::geometry

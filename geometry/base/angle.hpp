#pragma once

#include <compare>
#include <numbers>

namespace isopatch {

/// An angle that cannot be mistaken for its value in the other unit: `Angle::degrees(40).radians()`.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle degrees(double value) { return Angle(value * (std::numbers::pi / 180)); }
  static constexpr Angle radians(double value) { return Angle(value); }

  constexpr double degrees() const { return radians_ * (180 / std::numbers::pi); }
  constexpr double radians() const { return radians_; }

  constexpr auto operator<=>(const Angle&) const = default;
  constexpr Angle operator-() const { return Angle(-radians_); }
  constexpr Angle operator+(Angle other) const { return Angle(radians_ + other.radians_); }
  constexpr Angle operator-(Angle other) const { return Angle(radians_ - other.radians_); }
  constexpr Angle operator*(double factor) const { return Angle(radians_ * factor); }
  constexpr Angle operator/(double divisor) const { return Angle(radians_ / divisor); }

 private:
  constexpr explicit Angle(double radians) : radians_(radians) {}
  double radians_ = 0;
};

}  // namespace isopatch

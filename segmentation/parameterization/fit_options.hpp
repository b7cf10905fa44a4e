#pragma once

namespace isopatch::segmentation {

struct FitOptions {
  int degree = 3;           ///< range 2 .. 8
  double tolerance = 1e-4;  ///< largest deviation, share of the model's size; range [1e-8, 0.1]
  int start_spans = 1;      ///< equal spans of every direction at the start; range 1 .. 64
  /// Of any direction; range start_spans .. 1024. Where the input's splines or turns begin with more than an
  /// eighth of it, it is eight times as many as they bring.
  int max_spans = 64;
  bool operator==(const FitOptions&) const = default;
};
void validate(const FitOptions& options);

}  // namespace isopatch::segmentation

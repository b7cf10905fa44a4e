#pragma once

namespace isopatch::iga {

/// The product of a small matrix and rows that lie anywhere in a buffer:
/// out[m][n] (+)= sum over k of factors[k][m] rows[k][n], m below `outputs`, n below `columns`.
struct SmallProduct {
  const double* factors = nullptr;  ///< (terms, factor_step), row by row
  int factor_step = 0;              ///< at least outputs
  const int* offsets = nullptr;     ///< of each row from `rows`
  int terms = 0;
  int outputs = 0;
  int columns = 0;
};

/// @param rows  each readable up to `columns` rounded up to whole registers
/// @param out   rows `out_step` apart, writable likewise; what lies behind `columns` is undefined afterwards
/// @cost        2 terms outputs columns flops; blocks of up to 24 sums stay in registers
void multiply(const SmallProduct& product, const double* rows, double* out, int out_step);
/// The same, added to `out`.
void multiply_add(const SmallProduct& product, const double* rows, double* out, int out_step);

}  // namespace isopatch::iga

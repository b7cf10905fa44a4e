#pragma once

#include <vector>

namespace isopatch::iga {

/// Products of a small matrix with rows that lie anywhere in a buffer:
/// out[m][n] (+)= sum over k of factors[k][m] rows[k][n], m below `outputs`, n below `columns`.
///
/// Cut once into blocks whose sums, up to 24 registers, stay in the processor.
class SmallProducts {
 public:
  SmallProducts() = default;
  SmallProducts(int outputs, int columns);
  int outputs() const { return outputs_; }
  int columns() const { return columns_; }

  struct Operands {
    const double* factors;  ///< (terms, outputs), row by row
    const int* offsets;     ///< of each row from `rows`
    int terms;
    const double* rows;       ///< each readable up to `columns` rounded up to whole registers
    double* out;              ///< rows writable likewise; what lies behind `columns` is undefined afterwards
    std::ptrdiff_t out_step;  ///< from row to row of `out`
  };
  /// @cost  2 terms outputs columns flops
  void multiply(const Operands& operands) const;
  /// The same, added to `out`.
  void multiply_add(const Operands& operands) const;

 private:
  struct Block {
    int height;  // outputs
    int width;   // registers
    int first_output;
    int first_column;
  };
  int outputs_ = 0;
  int columns_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace isopatch::iga

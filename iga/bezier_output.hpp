#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/io/vtk_bezier.hpp"
#include "iga/elastic_field.hpp"

namespace isopatch::iga {

/// The elements of one patch as rational Bezier cells with their fields, any range of them at a time.
///
/// Displacement (m) is exact. Stress (Pa, xx yy zz xy yz zx), von Mises (Pa) and the Jacobian determinant are
/// interpolated at the (p + 1)^3 Gauss points of each element: exact there, a polynomial between them.
/// The cell field `patch` holds the patch's index, from 0.
class BezierOutput {
 public:
  /// @param field  must outlive this
  BezierOutput(const ElasticField& field, int patch);
  ~BezierOutput();
  BezierOutput(BezierOutput&&) noexcept;

  int cell_count() const;
  /// Elements first .. last - 1, the first direction running fastest; in parallel, the same for any number of
  /// threads.
  /// @cost  O((p + 1)^4) per element, and 15 numbers for each of its (p + 1)^3 points
  geometry::BezierCells cells(int first, int last) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All cells of one patch.
geometry::BezierCells bezier_cells(const ElasticField& field, int patch);

/// What the numbers of all patches' cells take in full precision, bytes.
std::int64_t bezier_bytes(const ElasticField& field);

/// One patch as a .vtu file, of which some 16 MB are in memory at a time.
void write_bezier_cells(const ElasticField& field, int patch, const geometry::ByteSink& sink,
                        geometry::Precision precision = geometry::Precision::full);

}  // namespace isopatch::iga

#include "iga/assembly/mass.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "iga/assembly/assembly.hpp"
#include "iga/spaces/element.hpp"
#include "iga/spaces/internal/element_batches.hpp"
#include "iga/spaces/internal/element_tensors.hpp"

namespace isopatch::iga {
namespace {

struct ElementMass {
  std::vector<int> functions;
  Eigen::MatrixXd mass;
};

// The place of a block on or above the diagonal.
std::size_t position_of(const solvers::SymmetricBlockMatrix& matrix, int row, int column) {
  const auto begin = matrix.columns.begin() + matrix.row_start[static_cast<std::size_t>(row)];
  const auto end = matrix.columns.begin() + matrix.row_start[static_cast<std::size_t>(row) + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, column) - matrix.columns.begin());
}

void add(const ElementMass& element, int first_node, const RowNumbering& numbering,
         solvers::SymmetricBlockMatrix& matrix) {
  const auto row_of = [&](int function) {
    return numbering.row_of_node[static_cast<std::size_t>(first_node + function)];
  };
  for (std::size_t a = 0; a < element.functions.size(); ++a)
    for (std::size_t b = 0; b < element.functions.size(); ++b) {
      const int row = row_of(element.functions[a]), column = row_of(element.functions[b]);
      if (row > column) continue;
      const std::size_t at = 9 * position_of(matrix, row, column);
      const double mass = element.mass(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
      for (const std::size_t diagonal : {0u, 4u, 8u}) matrix.values[at + diagonal] += mass;
    }
}

}  // namespace

solvers::SymmetricBlockMatrix assemble_mass(const Discretization& d, const std::vector<Material>& materials,
                                            const RowNumbering& numbering, int points) {
  constexpr std::int64_t elements_per_batch = 256;
  solvers::SymmetricBlockMatrix matrix = stiffness_pattern(d, numbering);
  for (int p = 0; p < d.patch_count(); ++p) {
    const auto patch = static_cast<std::size_t>(p);
    const ElementEvaluator evaluator(d.patches[patch], gauss_rules(d.points_of(p, points)));
    in_batches<ElementValues, ElementMass>(
        evaluator.element_count(), elements_per_batch,
        [&](std::int64_t element, ElementValues& values, ElementMass& out) {
          evaluator.evaluate(element, values);
          out.functions = values.functions;
          out.mass = materials[patch].density * values.values * values.measures.asDiagonal() *
                     values.values.transpose();
        },
        [&](std::int64_t, std::span<const ElementMass> elements) {
          for (const ElementMass& element : elements) add(element, d.first_node[patch], numbering, matrix);
        });
  }
  return matrix;
}

}  // namespace isopatch::iga

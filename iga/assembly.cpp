#include "iga/assembly.hpp"

#include <algorithm>
#include <numeric>

#include "iga/internal/element_loop.hpp"

namespace isopatch::iga {
namespace {

using solvers::SymmetricBlockMatrix;

// First and last function whose support overlaps that of each function of one direction.
std::vector<std::pair<int, int>> overlaps(const geometry::KnotVector& knots) {
  std::vector<std::pair<int, int>> result(static_cast<std::size_t>(knots.size()), {knots.size(), -1});
  const std::vector<double> breaks = knots.breaks();
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    const int last = knots.span(breaks[e]);
    for (int i = last - knots.degree(); i <= last; ++i) {
      auto& [low, high] = result[static_cast<std::size_t>(i)];
      low = std::min(low, last - knots.degree());
      high = std::max(high, last);
    }
  }
  return result;
}

// Nodes of one patch whose functions overlap that of a node.
class Neighbours {
 public:
  explicit Neighbours(const geometry::NurbsVolume& patch) : sizes_(patch.sizes()) {
    for (std::size_t d = 0; d < 3; ++d) ranges_[d] = overlaps(patch.knots()[d]);
  }
  template <class Visit>
  void for_each(int local, Visit visit) const {
    const auto [u0, u1] = ranges_[0][static_cast<std::size_t>(local % sizes_[0])];
    const auto [v0, v1] = ranges_[1][static_cast<std::size_t>(local / sizes_[0] % sizes_[1])];
    const auto [w0, w1] = ranges_[2][static_cast<std::size_t>(local / sizes_[0] / sizes_[1])];
    for (int k = w0; k <= w1; ++k)
      for (int j = v0; j <= v1; ++j)
        for (int i = u0; i <= u1; ++i) visit(i + sizes_[0] * (j + sizes_[1] * k));
  }

 private:
  std::array<int, 3> sizes_;
  std::array<std::vector<std::pair<int, int>>, 3> ranges_;
};

// Nodes of each block row.
std::vector<std::vector<int>> nodes_of_rows(const RowNumbering& numbering) {
  std::vector<std::vector<int>> nodes(static_cast<std::size_t>(numbering.rows));
  for (std::size_t node = 0; node < numbering.row_of_node.size(); ++node)
    nodes[static_cast<std::size_t>(numbering.row_of_node[node])].push_back(static_cast<int>(node));
  return nodes;
}

// The blocks of one element: for every ordered pair of functions (a, b) nine values, row by row.
struct ElementStiffness {
  std::vector<int> rows;
  std::vector<int> order;  // of the functions, by row
  std::vector<double> blocks;
};

struct Products {
  Eigen::MatrixXd gradients;  // (3 n, q), scaled by the square root of the measure
  Eigen::MatrixXd products;   // (3 n, 3 n), lower triangle
};

void compute_element(const ElementValues& values, const Material& material, Products& scratch,
                     ElementStiffness& out) {
  const auto n = static_cast<Eigen::Index>(values.functions.size());
  scratch.gradients.resize(3 * n, values.measures.size());
  const Eigen::VectorXd roots = values.measures.cwiseSqrt();
  for (int d = 0; d < 3; ++d)
    scratch.gradients.middleRows(d * n, n) =
        values.gradients[static_cast<std::size_t>(d)] * roots.asDiagonal();
  scratch.products.setZero(3 * n, 3 * n);
  scratch.products.selfadjointView<Eigen::Lower>().rankUpdate(scratch.gradients);
  const auto product = [&](int i, Eigen::Index a, int j, Eigen::Index b) {
    const Eigen::Index r = i * n + a;
    const Eigen::Index c = j * n + b;
    return r >= c ? scratch.products(r, c) : scratch.products(c, r);
  };
  out.blocks.resize(static_cast<std::size_t>(9 * n * n));
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      if (out.rows[static_cast<std::size_t>(a)] > out.rows[static_cast<std::size_t>(b)]) continue;
      double* block = &out.blocks[static_cast<std::size_t>(9 * (a * n + b))];
      const double shear = material.mu * (product(0, a, 0, b) + product(1, a, 1, b) + product(2, a, 2, b));
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
          block[3 * i + j] = material.lambda * product(i, a, j, b) + material.mu * product(j, a, i, b);
        block[4 * i] += shear;
      }
    }
  }
}

// Adds the rows of an element that belong to one of `shares`.
void add_rows(const ElementStiffness& element, int share, int shares, SymmetricBlockMatrix& matrix) {
  const auto n = static_cast<int>(element.rows.size());
  const auto row_of = [&](int a) { return element.rows[static_cast<std::size_t>(a)]; };
  for (int a = 0; a < n; ++a) {
    const int row = row_of(a);
    if (row / 16 % shares != share) continue;
    auto column = matrix.columns.begin() + matrix.row_start[static_cast<std::size_t>(row)];
    const auto end = matrix.columns.begin() + matrix.row_start[static_cast<std::size_t>(row) + 1];
    for (const int b : element.order) {
      if (row_of(b) < row) continue;
      column = std::lower_bound(column, end, row_of(b));
      const double* block = &element.blocks[static_cast<std::size_t>(9 * (a * n + b))];
      double* target = &matrix.values[static_cast<std::size_t>(9 * (column - matrix.columns.begin()))];
      for (int k = 0; k < 9; ++k) target[k] += block[k];
    }
  }
}

}  // namespace

SymmetricBlockMatrix stiffness_pattern(const Discretization& d, const RowNumbering& numbering) {
  constexpr int rows_per_task = 64;
  std::vector<Neighbours> neighbours;
  for (const auto& patch : d.patches) neighbours.emplace_back(patch);
  const std::vector<std::vector<int>> nodes = nodes_of_rows(numbering);
  std::vector<std::vector<int>> columns(nodes.size());
  parallel_for((numbering.rows + rows_per_task - 1) / rows_per_task, [&](std::int64_t task, int) {
    const int last = std::min(numbering.rows, static_cast<int>(task + 1) * rows_per_task);
    for (int row = static_cast<int>(task) * rows_per_task; row < last; ++row) {
      std::vector<int>& found = columns[static_cast<std::size_t>(row)];
      for (const int node : nodes[static_cast<std::size_t>(row)]) {
        const auto patch = static_cast<std::size_t>(
            std::upper_bound(d.first_node.begin(), d.first_node.end(), node) - d.first_node.begin() - 1);
        const int first = d.first_node[patch];
        neighbours[patch].for_each(node - first, [&](int local) {
          const int column = numbering.row_of_node[static_cast<std::size_t>(first + local)];
          if (column >= row) found.push_back(column);
        });
      }
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      found.shrink_to_fit();
    }
  });
  SymmetricBlockMatrix matrix;
  matrix.row_start.reserve(nodes.size() + 1);
  for (const auto& found : columns)
    matrix.row_start.push_back(matrix.row_start.back() + static_cast<std::int64_t>(found.size()));
  matrix.columns.reserve(static_cast<std::size_t>(matrix.row_start.back()));
  for (const auto& found : columns) matrix.columns.insert(matrix.columns.end(), found.begin(), found.end());
  matrix.values.assign(9 * matrix.columns.size(), 0.0);
  return matrix;
}

SymmetricBlockMatrix assemble_stiffness(const Discretization& d, const std::vector<Material>& materials,
                                        const RowNumbering& numbering, int points, const Progress& progress) {
  SymmetricBlockMatrix matrix = stiffness_pattern(d, numbering);
  std::int64_t functions = 1;
  for (const auto& patch : d.patches)
    functions = std::max<std::int64_t>(functions,
                                       (patch.degree(0) + 1) * (patch.degree(1) + 1) * (patch.degree(2) + 1));
  // Every row has one owner, which adds the elements in their order: no races, and the same sums for any
  // number of threads.
  const int shares = 4 * omp_get_max_threads();
  for_each_element<Products, ElementStiffness>(
      d, points, 72 * functions * functions, progress, "assembly",
      [&](const ElementAt& at, const ElementValues& values, Products& scratch, ElementStiffness& element) {
        const auto patch = static_cast<std::size_t>(at.patch);
        element.rows.resize(values.functions.size());
        for (std::size_t a = 0; a < values.functions.size(); ++a)
          element.rows[a] =
              numbering.row_of_node[static_cast<std::size_t>(d.first_node[patch] + values.functions[a])];
        element.order.resize(element.rows.size());
        std::iota(element.order.begin(), element.order.end(), 0);
        std::sort(element.order.begin(), element.order.end(), [&](int a, int b) {
          return element.rows[static_cast<std::size_t>(a)] < element.rows[static_cast<std::size_t>(b)];
        });
        compute_element(values, materials[patch], scratch, element);
      },
      [&](std::span<const ElementStiffness> elements) {
        parallel_for(shares, [&](std::int64_t share, int) {
          for (const ElementStiffness& element : elements)
            add_rows(element, static_cast<int>(share), shares, matrix);
        });
      });
  return matrix;
}

}  // namespace isopatch::iga

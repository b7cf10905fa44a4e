#include "iga/output/bezier_output.hpp"

#include <omp.h>

#include <Eigen/LU>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/output/hexahedra_output.hpp"
#include "iga/output/internal/error_cells.hpp"
#include "iga/output/internal/grid_sums.hpp"
#include "iga/output/output_grid.hpp"
#include "iga/output/plane_fields.hpp"
#include "iga/spaces/internal/patch_batches.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;
using NodeFields = std::vector<FieldLanes<8>>;

// From values at degree + 1 evenly spread parameters to the Bernstein coefficients of their interpolant.
Eigen::MatrixXd interpolation(int degree) {
  const KnotVector knots = KnotVector::bezier(degree);
  Eigen::MatrixXd values(degree + 1, degree + 1);
  for (int q = 0; q <= degree; ++q)
    values.row(q) = geometry::basis(knots, static_cast<double>(q) / degree).values.row(0);
  return pseudo_inverse(values);
}

ElementPieces pieces_of_degree(const NurbsVolume& patch) {
  ElementPieces result;
  for (int d = 0; d < 3; ++d)
    result[static_cast<std::size_t>(d)].assign(static_cast<std::size_t>(patch.knots(d).element_count()),
                                               patch.degree(d));
  return result;
}

geometry::VtuGrid vtu_grid(const NurbsVolume& patch) {
  geometry::VtuGrid grid;
  for (int d = 0; d < 3; ++d) {
    const auto i = static_cast<std::size_t>(d);
    grid.degree[i] = patch.degree(d);
    grid.points[i] = patch.degree(d) * patch.knots(d).element_count() + 1;
  }
  return grid;
}

// Control points of a plane, and the coefficients of the fields.
struct NetPlane {
  Eigen::Matrix3Xd points, displacement;
  Eigen::MatrixXd stress;
  Eigen::RowVectorXd weights;
};

// One patch's points, weights and fields, a layer of elements after the other.
class PatchCells {
 public:
  PatchCells(const ElasticField& field, int patch)
      : volume_(field.patches[static_cast<std::size_t>(patch)]),
        grid_(vtu_grid(volume_)),
        nodal_(field, patch, grid_of(volume_, pieces_of_degree(volume_))),
        net_(volume_, field.displacement[static_cast<std::size_t>(patch)],
             {bezier_line(volume_.knots(0)), bezier_line(volume_.knots(1)), bezier_line(volume_.knots(2))}) {
    for (int d = 0; d < 3; ++d)
      to_coefficients_[static_cast<std::size_t>(d)] = interpolation(volume_.degree(d));
    const std::size_t layer = size() * static_cast<std::size_t>(volume_.degree(2) + 1);
    nodes_.resize(layer);
    stress_.resize(layer);
  }

  // Calls take(plane, number of its first point) for every plane.
  template <class Take>
  void for_each(std::int64_t first, const Take& take) {
    const int p = volume_.degree(2), layers = volume_.knots(2).element_count();
    for (int layer = 0; layer < layers; ++layer) {
      evaluate_layer(layer);
      interpolate_layer();
      for (int k = 0; k < p + (layer + 1 == layers ? 1 : 0); ++k)
        take(plane(layer * p + k, k), first + static_cast<std::int64_t>(size()) * (layer * p + k));
    }
  }

 private:
  std::size_t size() const {
    return static_cast<std::size_t>(grid_.points[0]) * static_cast<std::size_t>(grid_.points[1]);
  }

  // Stress times the weight function at the nodes of a layer; its first plane is the last one of the layer
  // before.
  void evaluate_layer(int layer) {
    const int p = volume_.degree(2);
    if (layer > 0)
      std::copy(nodes_.end() - static_cast<std::ptrdiff_t>(size()), nodes_.end(), nodes_.begin());
    for (int k = layer > 0 ? 1 : 0; k <= p; ++k) {
      const FieldPlane& plane = nodal_.plane(layer * p + k);
      for (std::size_t i = 0; i < size(); ++i) {
        FieldLanes<8>& lanes = nodes_[size() * static_cast<std::size_t>(k) + i];
        lanes.setZero();
        const auto at = static_cast<Eigen::Index>(i);
        lanes.head<6>() = plane.weights[at] * plane.stress.col(at).array();
      }
    }
  }

  // Coefficients of the interpolants. Neighbours have the same ones on the face between them; the one behind
  // it writes them.
  void interpolate_layer() {
    const int p = grid_.degree[0], q = grid_.degree[1], r = grid_.degree[2];
    const int across = volume_.knots(0).element_count(), rows = volume_.knots(1).element_count();
    std::vector<std::array<NodeFields, 2>> buffers(static_cast<std::size_t>(omp_get_max_threads()));
    parallel_for(std::int64_t{across} * rows, [&](std::int64_t element, int thread) {
      const int e = static_cast<int>(element) % across, f = static_cast<int>(element) / across;
      std::array<NodeFields, 2>& buffer = buffers[static_cast<std::size_t>(thread)];
      NodeFields &values = buffer[0], &spare = buffer[1];
      values.resize(static_cast<std::size_t>((p + 1) * (q + 1) * (r + 1)));
      spare.resize(values.size());
      const auto for_each = [&](int last_i, int last_j, auto visit) {
        for (int k = 0; k <= r; ++k)
          for (int j = 0; j <= last_j; ++j)
            for (int i = 0; i <= last_i; ++i)
              visit(static_cast<std::size_t>(i + (p + 1) * (j + (q + 1) * k)),
                    static_cast<std::size_t>(e * p + i) +
                        static_cast<std::size_t>(grid_.points[0]) * static_cast<std::size_t>(f * q + j) +
                        size() * static_cast<std::size_t>(k));
      };
      for_each(p, q, [&](std::size_t own, std::size_t at) { values[own] = nodes_[at]; });
      contract<false, false, 8>(to_coefficients_[0], 1, (q + 1) * (r + 1), values.data(), spare.data());
      contract<false, false, 8>(to_coefficients_[1], p + 1, r + 1, spare.data(), values.data());
      contract<false, false, 8>(to_coefficients_[2], (p + 1) * (q + 1), 1, values.data(), spare.data());
      for_each(e + 1 == across ? p : p - 1, f + 1 == rows ? q : q - 1,
               [&](std::size_t own, std::size_t at) { stress_[at] = spare[own]; });
    });
  }

  NetPlane plane(int k, int in_layer) {
    const auto count = static_cast<Eigen::Index>(size());
    const Eigen::Index across = grid_.points[0];
    NetPlane result{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), Eigen::MatrixXd(6, count),
                    Eigen::RowVectorXd(count)};
    net_.plane(k, plane_);
    std::vector<GridSums::Row> rows(static_cast<std::size_t>(omp_get_max_threads()));
    parallel_for(grid_.points[1], [&](std::int64_t j, int thread) {
      GridSums::Row& row = rows[static_cast<std::size_t>(thread)];
      net_.row(static_cast<int>(j), plane_, row);
      for (Eigen::Index i = 0; i < across; ++i) {
        const FieldLanes<8> sums = net_.point(static_cast<int>(i), row).value;
        const Eigen::Index at = i + across * j;
        const auto coefficient = size() * static_cast<std::size_t>(in_layer) + static_cast<std::size_t>(at);
        result.weights[at] = sums[3];
        result.points.col(at) = sums.head<3>().matrix() / sums[3];
        result.displacement.col(at) = sums.segment<3>(4).matrix() / sums[3];
        result.stress.col(at) = stress_[coefficient].head<6>().matrix() / sums[3];
      }
    });
    return result;
  }

  const NurbsVolume& volume_;
  geometry::VtuGrid grid_;
  PlaneFields nodal_;
  GridSums net_;
  std::array<Eigen::MatrixXd, 3> to_coefficients_;
  NodeFields nodes_, stress_;  // of the planes of one layer
  GridSums::Plane plane_;
};

}  // namespace

void write_bezier_cells(const ElasticField& field, const std::vector<int>& patches,
                        const geometry::PlacedByteSink& sink, geometry::Precision precision) {
  const std::vector<int> all = material_numbers(field);
  std::vector<geometry::VtuGrid> grids;
  std::vector<geometry::GridParameters<3>> elements;
  std::vector<int> materials;
  std::vector<std::int64_t> first = {0};
  for (const int p : patches) {
    elements.push_back(element_grid(field.patches[static_cast<std::size_t>(p)]));
    grids.push_back(vtu_grid(field.patches[static_cast<std::size_t>(p)]));
    first.push_back(first.back() + grids.back().point_count());
    materials.push_back(all[static_cast<std::size_t>(p)]);
  }
  geometry::VtuFile file(
      geometry::VtuCell::bezier_hexahedron, grids,
      {{"RationalWeights", 1, precision}, {"displacement", 3, precision}, {"stress", 6, precision}},
      {{"patch", patches}, {"material", materials}}, sink, precision, error_cells(field, patches, elements));
  for_each_plane<NetPlane>(
      first, [&](std::size_t i, const auto& take) { PatchCells(field, patches[i]).for_each(first[i], take); },
      [&](const NetPlane& plane, std::int64_t at) {
        file.points(at, plane.points);
        file.field(0, at, plane.weights);
        file.field(1, at, plane.displacement);
        file.field(2, at, plane.stress);
      });
  file.finish();
}

std::int64_t bezier_bytes(const ElasticField& field) {
  std::int64_t points = 0;
  for (const NurbsVolume& patch : field.patches) points += vtu_grid(patch).point_count();
  return 13 * static_cast<std::int64_t>(sizeof(double)) * points;
}

}  // namespace isopatch::iga

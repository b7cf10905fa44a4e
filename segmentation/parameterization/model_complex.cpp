#include "segmentation/parameterization/internal/model_complex.hpp"

#include "segmentation/parameterization/internal/edge_pace.hpp"
#include "segmentation/parameterization/internal/edge_samples.hpp"

namespace isopatch::segmentation {
namespace {

/// The mean of the blocks' corners at each vertex.
std::vector<Eigen::Vector3d> mean_corners(const HexComplex& complex) {
  const auto count = static_cast<std::size_t>(complex.topology.vertex_count);
  std::vector<Eigen::Vector3d> sums(count, Eigen::Vector3d::Zero());
  std::vector<int> uses(count, 0);
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (std::size_t c = 0; c < 8; ++c) {
      const auto v = static_cast<std::size_t>(complex.topology.blocks[b].vertices[c].value);
      sums[v] += complex.blocks[b].corners[c];
      ++uses[v];
    }
  for (std::size_t v = 0; v < count; ++v) sums[v] /= uses[v];
  return sums;
}

}  // namespace

HexComplex model_complex(const HexModel& model) {
  HexComplex complex;
  complex.topology = model.topology;
  complex.blocks = hexahedra(model);
  complex.maps = face_maps(complex.blocks);
  complex.size = size_of(complex.blocks);
  complex.vertices = mean_corners(complex);
  complex.edges.resize(model.topology.edges.size());
  choose_paces(complex);
  locate_vertices(complex);
  return complex;
}

}  // namespace isopatch::segmentation

#include "iga/operator/internal/patch_operator.hpp"

#include <algorithm>
#include <utility>

#include "iga/spaces/internal/folded_patch.hpp"

namespace isopatch::iga {
namespace {

// Number of blocks of at least `smallest` that `count` is cut into.
int block_count(int count, int smallest) {
  return std::max(1, count / smallest);
}

std::array<int, 2> block(int begin, int end, int index, int blocks) {
  const auto cut = [&](int i) {
    return begin + static_cast<int>(static_cast<std::int64_t>(end - begin) * i / blocks);
  };
  return {cut(index), cut(index + 1)};
}

Denominators denominators(const PatchSpace& space, bool together) {
  const bool rational_geometry = space.geometry->is_rational();
  if (together) return rational_geometry ? Denominators::shared : Denominators::none;
  if (space.is_rational()) return rational_geometry ? Denominators::both : Denominators::functions;
  return rational_geometry ? Denominators::geometry : Denominators::none;
}

// The same functions in the same space.
bool isoparametric(const PatchSpace& space) {
  if (space.knots != space.geometry->knots()) return false;
  if (!space.is_rational()) return !space.geometry->is_rational();
  return space.geometry->is_rational() && space.weights == space.geometry->weights();
}

std::int64_t bytes_of(const LineTable& table) {
  std::size_t bytes =
      (table.first.size() + table.run_start.size()) * sizeof(int) + table.runs.size() * sizeof(PointRun);
  for (const std::vector<double>& kind : table.kinds) bytes += kind.size() * sizeof(double);
  return static_cast<std::int64_t>(bytes);
}

}  // namespace

PatchOperator::Group PatchOperator::group(const std::array<geometry::KnotVector, 3>& knots,
                                          std::array<LineTable, 3> tables) {
  Group result;
  result.tables = std::move(tables);
  result.bands = lane_bands(result.tables[0]);
  result.sizes = {knots[0].size(), knots[1].size()};
  return result;
}

PatchOperator::PatchOperator(int patch, const PatchSpace& space, const Material& material, int points)
    : patch_(patch), space_(&space), material_(material), is_isoparametric_(isoparametric(space)) {
  denominators_ = denominators(space, is_isoparametric_);
  std::array<LineTable, 3> own, geometry, products;
  for (std::size_t d = 0; d < 3; ++d) {
    elements_[d] = direction_table(space.knots[d],
                                   geometry::gauss_legendre(space.points_along(static_cast<int>(d), points)));
    for (const DirectionTable::Element& element : elements_[d].elements)
      quadrature_[d].insert(quadrature_[d].end(), element.weights.begin(), element.weights.end());
    own[d] = line_table(elements_[d]);
    products[d] = squares(own[d]);
    if (!is_isoparametric_) geometry[d] = line_table(space.geometry->knots()[d], elements_[d]);
  }
  functions_ = group(space.knots, std::move(own));
  squares_ = group(space.knots, std::move(products));
  if (!is_isoparametric_) geometry_ = group(space.geometry->knots(), std::move(geometry));
  lane_weights_.assign(functions_.bands.size(), Lanes{});
  for (std::size_t q = 0; q < quadrature_[0].size(); ++q)
    lane_weights_[q / lane_count][q % lane_count] = quadrature_[0][q];
}

std::vector<ElementBox> PatchOperator::boxes(int first_layer, int last_layer) const {
  constexpr int enough = 16;
  // Neighbours in directions 2 and 3 expand the lines of p functions twice, neighbours in direction 1 share
  // nothing but results.
  const auto smallest = [&](std::size_t d) { return std::max(8, 2 * space_->knots[d].degree()); };
  const int elements2 = static_cast<int>(elements_[1].elements.size());
  const int bands = static_cast<int>(functions_.bands.size());
  const int blocks2 = block_count(elements2, smallest(1));
  const int blocks3 = block_count(last_layer - first_layer, smallest(2));
  const int wanted1 = std::clamp(enough / (blocks2 * blocks3), 1, bands);
  const int length1 = (bands + wanted1 - 1) / wanted1;  // all blocks about as long, for equal tasks
  const int blocks1 = (bands + length1 - 1) / length1;
  std::vector<ElementBox> result;
  for (int k = 0; k < blocks3; ++k)
    for (int j = 0; j < blocks2; ++j)
      for (int i = 0; i < blocks1; ++i) {
        const auto [b1, e1] = block(0, bands, i, blocks1);
        const auto [b2, e2] = block(0, elements2, j, blocks2);
        const auto [b3, e3] = block(first_layer, last_layer, k, blocks3);
        result.push_back({{b1, b2, b3}, {e1, e2, e3}});
      }
  return result;
}

BoxFunctions PatchOperator::functions_of(const ElementBox& box) const {
  const LaneBand& low = functions_.bands[static_cast<std::size_t>(box.begin[0])];
  const LaneBand& high = functions_.bands[static_cast<std::size_t>(box.end[0]) - 1];
  BoxFunctions result{{low.first, 0, 0}, {high.first + high.functions - low.first, 0, 0}};
  for (std::size_t d = 1; d < 3; ++d) {
    const auto first = [&](int element) {
      return elements_[d].elements[static_cast<std::size_t>(element)].first;
    };
    result.first[d] = first(box.begin[d]);
    result.sizes[d] = first(box.end[d] - 1) + space_->knots[d].degree() + 1 - result.first[d];
  }
  return result;
}

void PatchOperator::refuse_folded(const ElementBox& box) const {
  const auto nodes = [&](std::size_t d) {
    std::vector<double> result;
    const bool bands = d == 0;
    const int begin = bands ? 0 : box.begin[d];
    const int end = bands ? static_cast<int>(elements_[d].elements.size()) : box.end[d];
    for (int e = begin; e < end; ++e) {
      const Eigen::VectorXd& at = elements_[d].elements[static_cast<std::size_t>(e)].nodes;
      result.insert(result.end(), at.begin(), at.end());
    }
    return result;
  };
  const std::array<std::vector<double>, 3> grid = {nodes(0), nodes(1), nodes(2)};
  iga::refuse_folded(patch_, *space_->geometry, space_->reversed, grid);
}

std::int64_t PatchOperator::bytes() const {
  std::int64_t result = static_cast<std::int64_t>(sizeof(*this) + lane_weights_.size() * sizeof(Lanes));
  for (const Group* group : {&functions_, &geometry_, &squares_}) {
    for (const LineTable& table : group->tables) result += bytes_of(table);
    for (const LaneBand& band : group->bands)
      result += static_cast<std::int64_t>(sizeof(band) + band.values.size() * sizeof(Lanes));
  }
  for (const DirectionTable& direction : elements_)
    for (const DirectionTable::Element& element : direction.elements)
      result += static_cast<std::int64_t>(sizeof(element)) +
                8 * (2 * element.values.size() + 2 * element.nodes.size());
  for (const std::vector<double>& weights : quadrature_)
    result += static_cast<std::int64_t>(weights.size() * sizeof(double));
  return result;
}

}  // namespace isopatch::iga

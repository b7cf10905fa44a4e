#include "iga/operator/internal/patch_operator.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "iga/operator/internal/box_lines.hpp"
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

template <Denominators D>
using Constant = std::integral_constant<Denominators, D>;

using MapsAtPoints = Lanes (*)(const PointLine&, PointMap*);

MapsAtPoints maps_function(Denominators denominators) {
  switch (denominators) {
    case Denominators::geometry:
      return maps_at_points<Denominators::geometry>;
    case Denominators::functions:
      return maps_at_points<Denominators::functions>;
    case Denominators::both:
      return maps_at_points<Denominators::both>;
    case Denominators::shared:
      return maps_at_points<Denominators::shared>;
    default:
      return maps_at_points<Denominators::none>;
  }
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

template <int F>
void PatchOperator::spread_fields(const Group& group, const Fields& fields, const LaneBand& band,
                                  BoxContraction& contraction) {
  std::vector<double> coefficients(static_cast<std::size_t>(band.functions * F));
  for (int k = 0; k < contraction.planes(); ++k)
    for (int r = 0; r < contraction.rows(); ++r) {
      const Eigen::Index node =
          band.first + static_cast<Eigen::Index>(group.sizes[0]) *
                           (contraction.first_row() + r +
                            static_cast<Eigen::Index>(group.sizes[1]) * (contraction.first_plane() + k));
      double* to = coefficients.data();
      for (int i = 0; i < band.functions; ++i) {
        const double weight = fields.weights ? (*fields.weights)[node + i] : 1;
        for (const double* const displacement : fields.displacements)
          for (int c = 0; c < 3; ++c) *to++ = weight * displacement[3 * (node + i) + c];
        if (fields.places)
          for (int c = 0; c < 3; ++c) *to++ = weight * fields.places->control_points()(c, node + i);
        if (fields.has_weights) *to++ = weight;
      }
      Lanes sums[2 * F] = {};
      for (int i = 0; i < band.functions; ++i) {
        const Lanes value = band.values[static_cast<std::size_t>(2 * i)];
        const Lanes derivative = band.values[static_cast<std::size_t>(2 * i + 1)];
        for (int f = 0; f < F; ++f) {
          const double coefficient = coefficients[static_cast<std::size_t>(F * i + f)];
          sums[f] += coefficient * value;
          sums[F + f] += coefficient * derivative;
        }
      }
      std::copy_n(sums, 2 * F, contraction.plane(r, k));
    }
}

void PatchOperator::spread(const Group& group, const Fields& fields, const LaneBand& band,
                           BoxContraction& contraction) {
  switch (fields.count()) {
    case 1:
      return spread_fields<1>(group, fields, band, contraction);
    case 3:
      return spread_fields<3>(group, fields, band, contraction);
    case 4:
      return spread_fields<4>(group, fields, band, contraction);
    case 6:
      return spread_fields<6>(group, fields, band, contraction);
    case 7:
      return spread_fields<7>(group, fields, band, contraction);
    case 9:
      return spread_fields<9>(group, fields, band, contraction);
    case 12:
      return spread_fields<12>(group, fields, band, contraction);
    case 15:
      return spread_fields<15>(group, fields, band, contraction);
    default:
      return;
  }
}

PatchOperator::Fields PatchOperator::fields_of_map_in_functions() const {
  return {
      {}, is_isoparametric_ ? space_->geometry : nullptr, space_->is_rational() ? &space_->weights : nullptr};
}

PatchOperator::Fields PatchOperator::fields_of_map_in_geometry() const {
  const geometry::NurbsVolume* const volume = space_->geometry;
  return {{},
          is_isoparametric_ ? nullptr : volume,
          !is_isoparametric_ && volume->is_rational() ? &volume->weights() : nullptr};
}

template <class Collect>
void PatchOperator::integrate(const ElementBox& box, const double* displacement, const Group& result_group,
                              const ContractionStages& result_stages, const Evaluate& evaluate,
                              PatchOperatorScratch& scratch, Collect collect) const {
  Fields with_functions = fields_of_map_in_functions();
  if (displacement) with_functions.displacements = {&displacement, 1};
  const Fields with_geometry = fields_of_map_in_geometry();
  const int own_fields = with_functions.count(), geometry_fields = with_geometry.count();
  const bool own_values = with_functions.weights, geometry_values = with_geometry.weights;
  const ContractionStages own_stages = field_stages(own_fields, own_values);
  const ContractionStages geometry_stages = field_stages(geometry_fields, geometry_values);
  if (own_fields > 0) scratch.functions.start(functions_.tables[1], functions_.tables[2], own_stages, box);
  if (geometry_fields > 0)
    scratch.geometry.start(geometry_.tables[1], geometry_.tables[2], geometry_stages, box);
  scratch.results.start(result_group.tables[1], result_group.tables[2], result_stages, box);

  const int points2 = static_cast<int>(elements_[1].elements.front().nodes.size());
  const int points3 = static_cast<int>(elements_[2].elements.front().nodes.size());
  PointLine line =
      lines_of({scratch.functions, own_fields, own_values},
               {scratch.geometry, geometry_fields, geometry_values}, displacement, is_isoparametric_);
  line.points = points2;
  for (int b = box.begin[0]; b < box.end[0]; ++b) {
    const auto band = static_cast<std::size_t>(b);
    line.weights1 = &lane_weights_[band];
    if (own_fields > 0) spread(functions_, with_functions, functions_.bands[band], scratch.functions);
    if (geometry_fields > 0) spread(geometry_, with_geometry, geometry_.bands[band], scratch.geometry);
    scratch.results.clear_planes();
    Lanes smallest = Lanes{} + std::numeric_limits<double>::max();
    for (int e3 = box.begin[2]; e3 < box.end[2]; ++e3) {
      if (own_fields > 0) scratch.functions.expand_layer(e3);
      if (geometry_fields > 0) scratch.geometry.expand_layer(e3);
      scratch.results.clear_rows();
      for (int q3 = 0; q3 < points3; ++q3) {
        line.weight3 = quadrature_[2][static_cast<std::size_t>(e3 * points3 + q3)];
        for (int e2 = box.begin[1]; e2 < box.end[1]; ++e2) {
          line.weights2 = &quadrature_[1][static_cast<std::size_t>(e2 * points2)];
          if (own_fields > 0) scratch.functions.expand_points(e2, q3);
          if (geometry_fields > 0) scratch.geometry.expand_points(e2, q3);
          const Lanes determinants = evaluate(line, scratch.results.point(0));
          smallest = determinants < smallest ? determinants : smallest;
          scratch.results.collect_points(e2, q3);
        }
      }
      scratch.results.collect_layer(e3);
    }
    for (int lane = 0; lane < lane_count; ++lane)
      if (!(smallest[lane] > 0)) refuse_folded(box);
    collect(result_group.bands[band]);
  }
}

void PatchOperator::add_forces(const ElementBox& box, const double* displacement, double* forces,
                               PatchOperatorScratch& scratch) const {
  Evaluate evaluate;
  const auto use = [&]<Denominators D>(Constant<D>) {
    evaluate = [this](const PointLine& line, Lanes* out) {
      return forces_at_points<D>(line, material_, out);
    };
  };
  switch (denominators_) {
    case Denominators::none:
      use(Constant<Denominators::none>());
      break;
    case Denominators::geometry:
      use(Constant<Denominators::geometry>());
      break;
    case Denominators::functions:
      use(Constant<Denominators::functions>());
      break;
    case Denominators::both:
      use(Constant<Denominators::both>());
      break;
    case Denominators::shared:
      use(Constant<Denominators::shared>());
      break;
  }
  const ContractionStages stages = force_stages(space_->is_rational());
  const BoxFunctions functions = functions_of(box);
  integrate(box, displacement, functions_, stages, evaluate, scratch, [&](const LaneBand& band) {
    gather_all<3, 2>(functions_.sizes, functions, band, space_->weights, scratch.results, forces);
  });
}

// The forces of several displacements on one box: the map of the geometry at the points of a line, then each
// displacement's own sum factorization with it.
class PatchOperator::SeveralForces {
 public:
  SeveralForces(const PatchOperator& of, const ElementBox& box, std::span<const double* const> displacements,
                PatchOperatorScratch& scratch)
      : of_(of),
        box_(box),
        displacements_(displacements),
        scratch_(scratch),
        in_functions_(of.fields_of_map_in_functions()),
        in_geometry_(of.fields_of_map_in_geometry()),
        rational_(of.space_->is_rational()),
        fields_(3 * static_cast<int>(displacements.size())),
        functions_stages_(field_stages(in_functions_.count(), in_functions_.has_weights)),
        geometry_stages_(field_stages(in_geometry_.count(), in_geometry_.has_weights)),
        displacement_stages_(field_stages(fields_, rational_)),
        force_stages_(force_stages(rational_, fields_)),
        points_{static_cast<int>(of.elements_[1].elements.front().nodes.size()),
                static_cast<int>(of.elements_[2].elements.front().nodes.size())},
        maps_at_(maps_function(of.denominators_)),
        forces_at_(rational_ ? forces_with_maps<true> : forces_with_maps<false>) {
    start();
  }

  void add(std::span<double* const> forces) {
    const BoxFunctions functions = of_.functions_of(box_);
    for (int b = box_.begin[0]; b < box_.end[0]; ++b) {
      const auto number = static_cast<std::size_t>(b);
      start_band(number);
      Lanes smallest = Lanes{} + std::numeric_limits<double>::max();
      for (int e3 = box_.begin[2]; e3 < box_.end[2]; ++e3) {
        const Lanes determinants = add_layer(e3);
        smallest = determinants < smallest ? determinants : smallest;
      }
      for (int lane = 0; lane < lane_count; ++lane)
        if (!(smallest[lane] > 0)) of_.refuse_folded(box_);
      for (std::size_t i = 0; i < forces.size(); ++i)
        gather_all<3, 2>(of_.functions_.sizes, functions, of_.functions_.bands[number], of_.space_->weights,
                         scratch_.results, forces[i], fields_, 3 * static_cast<int>(i));
    }
  }

 private:
  void start() {
    const auto start = [&](BoxContraction& contraction, const Group& group, const ContractionStages& stages) {
      contraction.start(group.tables[1], group.tables[2], stages, box_);
    };
    if (in_functions_.count() > 0) start(scratch_.functions, of_.functions_, functions_stages_);
    if (in_geometry_.count() > 0) start(scratch_.geometry, of_.geometry_, geometry_stages_);
    start(scratch_.displacements, of_.functions_, displacement_stages_);
    start(scratch_.results, of_.functions_, force_stages_);
    scratch_.maps.resize(static_cast<std::size_t>(points_[0]));
    line_ = lines_of({scratch_.functions, in_functions_.count(), in_functions_.has_weights},
                     {scratch_.geometry, in_geometry_.count(), in_geometry_.has_weights}, false,
                     of_.is_isoparametric_);
    line_.displacement = FieldLayout{scratch_.displacements, fields_, rational_}.from(0);
    line_.points = points_[0];
  }

  void start_band(std::size_t number) {
    const LaneBand& band = of_.functions_.bands[number];
    line_.weights1 = &of_.lane_weights_[number];
    if (in_functions_.count() > 0) spread(of_.functions_, in_functions_, band, scratch_.functions);
    if (in_geometry_.count() > 0)
      spread(of_.geometry_, in_geometry_, of_.geometry_.bands[number], scratch_.geometry);
    spread(of_.functions_, {displacements_, nullptr, in_functions_.weights, false}, band,
           scratch_.displacements);
    scratch_.results.clear_planes();
  }

  // @return  smallest determinant of each lane
  Lanes add_layer(int e3) {
    if (in_functions_.count() > 0) scratch_.functions.expand_layer(e3);
    if (in_geometry_.count() > 0) scratch_.geometry.expand_layer(e3);
    scratch_.displacements.expand_layer(e3);
    scratch_.results.clear_rows();
    Lanes smallest = Lanes{} + std::numeric_limits<double>::max();
    for (int q3 = 0; q3 < points_[1]; ++q3)
      for (int e2 = box_.begin[1]; e2 < box_.end[1]; ++e2) {
        const Lanes determinants = add_line(e2, e3, q3);
        smallest = determinants < smallest ? determinants : smallest;
      }
    scratch_.results.collect_layer(e3);
    return smallest;
  }

  Lanes add_line(int e2, int e3, int q3) {
    line_.weight3 = of_.quadrature_[2][static_cast<std::size_t>(e3 * points_[1] + q3)];
    line_.weights2 = &of_.quadrature_[1][static_cast<std::size_t>(e2 * points_[0])];
    if (in_functions_.count() > 0) scratch_.functions.expand_points(e2, q3);
    if (in_geometry_.count() > 0) scratch_.geometry.expand_points(e2, q3);
    const Lanes determinants = maps_at_(line_, scratch_.maps.data());
    scratch_.displacements.expand_points(e2, q3);
    forces_at_(line_.displacement, static_cast<int>(displacements_.size()), scratch_.maps.data(), points_[0],
               of_.material_, scratch_.results.point(0));
    scratch_.results.collect_points(e2, q3);
    return determinants;
  }

  const PatchOperator& of_;
  const ElementBox& box_;
  std::span<const double* const> displacements_;
  PatchOperatorScratch& scratch_;
  Fields in_functions_, in_geometry_;  // of the map
  bool rational_;
  int fields_;  // of all displacements
  ContractionStages functions_stages_, geometry_stages_, displacement_stages_, force_stages_;
  std::array<int, 2> points_;  // of an element, in directions 2 and 3
  MapsAtPoints maps_at_;
  void (*forces_at_)(const LineFields&, int, const PointMap*, int, const Material&, Lanes*);
  PointLine line_{};
};

void PatchOperator::add_forces(const ElementBox& box, std::span<const double* const> displacements,
                               std::span<double* const> forces, PatchOperatorScratch& scratch) const {
  SeveralForces(*this, box, displacements, scratch).add(forces);
}

void PatchOperator::add_squares(const ElementBox& box, double* sums, PatchOperatorScratch& scratch) const {
  Evaluate evaluate;
  switch (denominators_) {
    case Denominators::none:
      evaluate = squares_at_points<Denominators::none>;
      break;
    case Denominators::geometry:
      evaluate = squares_at_points<Denominators::geometry>;
      break;
    case Denominators::functions:
      evaluate = squares_at_points<Denominators::functions>;
      break;
    case Denominators::both:
      evaluate = squares_at_points<Denominators::both>;
      break;
    case Denominators::shared:
      evaluate = squares_at_points<Denominators::shared>;
      break;
  }
  const ContractionStages stages = square_stages(space_->is_rational());
  const BoxFunctions functions = functions_of(box);
  integrate(box, nullptr, squares_, stages, evaluate, scratch, [&](const LaneBand& band) {
    gather_all<6, 3>(squares_.sizes, functions, band, space_->weights, scratch.results, sums);
  });
}

}  // namespace isopatch::iga

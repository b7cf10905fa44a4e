#include "iga/spaces/internal/element_tensors.hpp"

#include <utility>

namespace isopatch::iga {

ElementTensors::ElementTensors(ElementTables tables, const geometry::NurbsVolume& patch)
    : tables_(std::move(tables)), size_(patch.sizes()) {
  const auto first = tables_.of(0);
  for (std::size_t d = 0; d < 3; ++d) {
    functions_[d] = patch.knots()[d].degree() + 1;
    points_[d] = first[d]->nodes.size();
  }
}

template <int C>
void ElementTensors::resize(TensorBuffers<C>& buffers) const {
  buffers.coefficients.resize(static_cast<std::size_t>(function_count()));
  for (auto& at : buffers.at) at.resize(static_cast<std::size_t>(point_count()));
  const Eigen::Index most = std::max(points_[0], functions_[0]) * std::max(points_[1], functions_[1]) *
                            std::max(points_[2], functions_[2]);
  for (auto& part : buffers.part) part.resize(static_cast<std::size_t>(most));
}

template <int C>
void ElementTensors::values(std::int64_t element, TensorBuffers<C>& b) const {
  resize(b);
  const auto [u, v, w] = tables_.of(element);
  const auto [m, n, o] = functions_;
  const auto [q, r, s] = points_;
  contract<false, false, C>(u->values, 1, n * o, b.coefficients.data(), b.part[0].data());
  contract<false, false, C>(v->values, q, o, b.part[0].data(), b.part[1].data());
  contract<false, false, C>(w->values, q * r, 1, b.part[1].data(), b.at[0].data());
}

template <int C>
void ElementTensors::gradients(std::int64_t element, TensorBuffers<C>& b) const {
  resize(b);
  const auto [u, v, w] = tables_.of(element);
  const auto [m, n, o] = functions_;
  const auto [q, r, s] = points_;
  auto& [value, du, value_value, du_value, value_dv] = b.part;
  contract<false, false, C>(u->values, 1, n * o, b.coefficients.data(), value.data());
  contract<false, false, C>(u->derivatives, 1, n * o, b.coefficients.data(), du.data());
  contract<false, false, C>(v->values, q, o, value.data(), value_value.data());
  contract<false, false, C>(v->values, q, o, du.data(), du_value.data());
  contract<false, false, C>(v->derivatives, q, o, value.data(), value_dv.data());
  contract<false, false, C>(w->values, q * r, 1, value_value.data(), b.at[0].data());
  contract<false, false, C>(w->values, q * r, 1, du_value.data(), b.at[1].data());
  contract<false, false, C>(w->values, q * r, 1, value_dv.data(), b.at[2].data());
  contract<false, false, C>(w->derivatives, q * r, 1, value_value.data(), b.at[3].data());
}

template <int C>
void ElementTensors::test_with_values(std::int64_t element, TensorBuffers<C>& b) const {
  resize(b);
  const auto [u, v, w] = tables_.of(element);
  const auto [m, n, o] = functions_;
  const auto [q, r, s] = points_;
  contract<true, false, C>(w->values, q * r, 1, b.at[0].data(), b.part[0].data());
  contract<true, false, C>(v->values, q, o, b.part[0].data(), b.part[1].data());
  contract<true, false, C>(u->values, 1, n * o, b.part[1].data(), b.coefficients.data());
}

template <int C>
void ElementTensors::test_with_gradients(std::int64_t element, TensorBuffers<C>& b) const {
  resize(b);
  const auto [u, v, w] = tables_.of(element);
  const auto [m, n, o] = functions_;
  const auto [q, r, s] = points_;
  auto& [value, du, dv, value_value, du_value] = b.part;
  contract<true, false, C>(w->values, q * r, 1, b.at[0].data(), value.data());
  contract<true, true, C>(w->derivatives, q * r, 1, b.at[3].data(), value.data());
  contract<true, false, C>(w->values, q * r, 1, b.at[1].data(), du.data());
  contract<true, false, C>(w->values, q * r, 1, b.at[2].data(), dv.data());
  contract<true, false, C>(v->values, q, o, value.data(), value_value.data());
  contract<true, true, C>(v->derivatives, q, o, dv.data(), value_value.data());
  contract<true, false, C>(v->values, q, o, du.data(), du_value.data());
  contract<true, false, C>(u->values, 1, n * o, value_value.data(), b.coefficients.data());
  contract<true, true, C>(u->derivatives, 1, n * o, du_value.data(), b.coefficients.data());
}

#define ISOPATCH_TENSORS(C)                                                                 \
  template void ElementTensors::values<C>(std::int64_t, TensorBuffers<C>&) const;           \
  template void ElementTensors::gradients<C>(std::int64_t, TensorBuffers<C>&) const;        \
  template void ElementTensors::test_with_values<C>(std::int64_t, TensorBuffers<C>&) const; \
  template void ElementTensors::test_with_gradients<C>(std::int64_t, TensorBuffers<C>&) const
ISOPATCH_TENSORS(4);
ISOPATCH_TENSORS(8);
#undef ISOPATCH_TENSORS

void gather(const ElementTensors& tensors, std::int64_t element, const Eigen::Matrix3Xd& columns,
            const Eigen::VectorXd& weights, std::vector<FieldLanes<4>>& out) {
  out.resize(static_cast<std::size_t>(tensors.function_count()));
  const double* x = columns.data();
  const double* weight = weights.data();
  tensors.for_each_function(element, [&](Eigen::Index a, Eigen::Index i) {
    const double w = weight[i];
    out[static_cast<std::size_t>(a)] << w * x[3 * i], w * x[3 * i + 1], w * x[3 * i + 2], w;
  });
}

void gather(const ElementTensors& tensors, std::int64_t element, const geometry::NurbsVolume& patch,
            const double* displacement, std::vector<FieldLanes<8>>& out) {
  out.resize(static_cast<std::size_t>(tensors.function_count()));
  const double* x = patch.control_points().data();
  const double* weight = patch.weights().data();
  tensors.for_each_function(element, [&](Eigen::Index a, Eigen::Index i) {
    const double w = weight[i];
    const double* u = displacement + 3 * i;
    out[static_cast<std::size_t>(a)] << w * x[3 * i], w * x[3 * i + 1], w * x[3 * i + 2], w, w * u[0],
        w * u[1], w * u[2], 0.0;
  });
}

}  // namespace isopatch::iga

#include "iga/assembly/internal/stiffness_integrator.hpp"

#include <algorithm>

#include "iga/internal/native_lanes.hpp"
#include "iga/internal/square_transpose.hpp"

namespace isopatch::iga {
namespace {

constexpr int kinds = 9;         // of sums S after w
constexpr int result_kinds = 4;  // of sums R after u
using solvers::block_entries;
constexpr std::size_t ring_bytes = std::size_t{512} << 10;  // must stay in the second cache

// S_ij = sum over the points of w of x_i y_j, turned into lambda S_ij + mu S_ji + mu delta_ij S_kk.
inline void sum_block(const double* x, const double* y, int points, const Material& material, double* out) {
  constexpr int step = block_entries * native_lane_count;
  NativeLanes sums[3][3] = {};
  for (int q = 0; q < points; ++q, x += step, y += step) {
    const NativeLanes y0 = load(y), y1 = load(y + native_lane_count), y2 = load(y + 2 * native_lane_count);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const NativeLanes xi = load(x + i * native_lane_count);
      sums[i][0] += xi * y0;
      sums[i][1] += xi * y1;
      sums[i][2] += xi * y2;
    }
  }
  const NativeLanes shear = material.mu * (sums[0][0] + sums[1][1] + sums[2][2]);
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i)
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) {
      NativeLanes block = material.lambda * sums[i][j] + material.mu * sums[j][i];
      if (i == j) block += shear;
      store(out + (3 * i + j) * native_lane_count, block);
    }
}

// [s][i]: s = 0 is the parameter of w, which the factors differentiate, with what multiplies the function
// itself; s = 1, 2 the parameters of directions 1 and 2.
template <bool Rational>
inline void scale_point(const double* from, double value, double derivative, double* to) {
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    NativeLanes last = derivative * load(from + (6 + i) * native_lane_count);
    if constexpr (Rational) last += value * load(from + (9 + i) * native_lane_count);
    store(to + i * native_lane_count, last);
    store(to + (3 + i) * native_lane_count, value * load(from + i * native_lane_count));
    store(to + (6 + i) * native_lane_count, value * load(from + (3 + i) * native_lane_count));
  }
}

inline __attribute__((always_inline)) void add_block(const double* from, double factor, double* to) {
  constexpr int whole = block_entries / native_lane_count * native_lane_count;
#pragma GCC unroll 4
  for (int k = 0; k < whole; k += native_lane_count) store(to + k, load(to + k) + factor * load(from + k));
#pragma GCC unroll 1
  for (int k = whole; k < block_entries; ++k) to[k] += factor * from[k];
}

}  // namespace

const double* PointData::block(int v, int block, int w) const {
  return values +
         ((static_cast<std::ptrdiff_t>(v) * blocks + block) * points_w + w) * components * native_lane_count;
}

void StiffnessIntegrator::run(const StiffnessTask& task, const PatchIntegrand& patch, const PointData& points,
                              const BlockTargets& targets, CollectedBlocks& collected,
                              solvers::SymmetricBlockMatrix& matrix) {
  const StiffnessTables& tables = patch.tables;
  tables_ = &tables;
  patch_ = &patch;
  points_ = &points;
  task_ = task;
  const int high = tables.overlap(2, task.a_w).high;
  const int count = high - task.a_w + 1;
  const std::size_t bytes_per_b =
      sizeof(double) * kinds * block_entries *
      static_cast<std::size_t>(tables.points[1] *
                               (tables.most_elements * tables.points[0] + 2 * native_lane_count));
  const int most = std::max(1, static_cast<int>(ring_bytes / bytes_per_b));
  const int groups = (count + most - 1) / most;
  for (int group = 0, begin = task.a_w; group < groups; ++group) {
    group_ = {begin, begin + (high + 1 - begin + groups - group - 1) / (groups - group)};
    begin = group_.end;
    choose_sizes();
    for (int layer = task.layer_begin; layer < task.layer_end; ++layer) {
      int block = tables.overlap(0, task.u_begin).first_element * tables.points[0] / native_lane_count;
      for (int a = task.u_begin; a < task.u_end; ++a) {
        const int needed = (tables.overlap(0, a).last_element + 1) * tables.points[0];
        for (; block * native_lane_count < needed; ++block) contract_w(block, layer);
        contract_u(a);
        contract_v(a, layer);
        add(a, layer, targets, collected, matrix);
      }
    }
  }
}

void StiffnessIntegrator::choose_sizes() {
  const StiffnessTables& t = *tables_;
  per_point_ = block_entries * (group_.end - group_.begin);
  line_ = padded(t.points[1] * per_point_);
  ring_blocks_ = (t.most_elements * t.points[0] + 2 * native_lane_count - 2) / native_lane_count + 1;
  pair_step_ = padded(per_point_);
  const int points_w = t.points[2] * (t.last_layer - t.first_layer);
  const auto grow = [](std::vector<double>& buffer, int size) {
    if (static_cast<int>(buffer.size()) < size) buffer.resize(static_cast<std::size_t>(size));
  };
  grow(operand_a_, points_w * block_entries * native_lane_count);
  grow(operand_b_, points_w * block_entries * native_lane_count);
  grow(sums_, kinds * per_point_ * native_lane_count);
  grow(ring_, ring_blocks_ * native_lane_count * kinds * line_);
  int widest = 0;
  for (const Overlap& overlap : t.overlaps[0]) widest = std::max(widest, overlap.count());
  grow(line_sums_, widest * result_kinds * line_ + native_lane_count);
  grow(blocks_, (t.degrees[1] + 1) * (t.degrees[1] + 1) * widest * pair_step_);
  products_u_ = SmallProducts(t.degrees[0] + 1, line_);
  products_v_ = SmallProducts((t.degrees[1] + 1) * (t.degrees[1] + 1), per_point_);
  choose_offsets();
}

void StiffnessIntegrator::choose_offsets() {
  const StiffnessTables& t = *tables_;
  offsets_u_.clear();
  for (int e = 0; e < t.elements(0); ++e)
    for (const StiffnessTables::Term& term : t.terms_u) {
      const int point = (e * t.points[0] + term.point) % (ring_blocks_ * native_lane_count);
      offsets_u_.push_back((point * kinds + term.kind) * line_);
    }
  offsets_v_.clear();
  for (int kind = 0; kind < result_kinds; ++kind)
    for (int q = 0; q < t.points[1]; ++q) offsets_v_.push_back(kind * line_ + q * per_point_);
}

// Points of w in the common support of a and b, from the part's first layer on.
StiffnessIntegrator::Range StiffnessIntegrator::common_points(int b) const {
  const StiffnessTables& t = *tables_;
  const int begin = t.overlap(2, b).first_element;
  const int end = t.overlap(2, task_.a_w).last_element + 1;
  return {t.points[2] * (begin - t.first_layer), t.points[2] * (end - t.first_layer)};
}

void StiffnessIntegrator::contract_w(int block, int layer) {
  const StiffnessTables& t = *tables_;
  const int per_lane = kinds * line_;
  double* const slot =
      ring_.data() + static_cast<std::ptrdiff_t>(block % ring_blocks_) * native_lane_count * per_lane;
  for (int q = 0; q < t.points[1]; ++q) {
    contract_w_at(points_->block((layer - points_->layer_begin) * t.points[1] + q, block, 0));
    double* lanes[native_lane_count];
    for (int lane = 0; lane < native_lane_count; ++lane)
      lanes[lane] = slot + lane * per_lane + q * per_point_;
    for (int kind = 0; kind < kinds; ++kind) {
      const double* const from =
          sums_.data() + static_cast<std::ptrdiff_t>(kind) * per_point_ * native_lane_count;
      for (int entry = 0; entry < per_point_; entry += native_lane_count) {
        // The last square overlaps the one before it.
        const int start = std::min(entry, per_point_ - native_lane_count);
        transpose(from + start * native_lane_count, lanes, kind * line_ + start);
      }
    }
  }
}

// X of function a, or Y of function b: the numbers of a register of points of u, at the points `range` of w,
// times the function and its derivative.
void StiffnessIntegrator::scale_points(const double* from, int function, const Range& range,
                                       double* to) const {
  const StiffnessTables& t = *tables_;
  const int own_begin = t.points[2] * (t.overlap(2, function).first_element - t.first_layer);
  const double* factors =
      t.factors_w[static_cast<std::size_t>(function)].data() + 2 * (range.begin - own_begin);
  const int step = points_->components * native_lane_count;
  from += static_cast<std::ptrdiff_t>(range.begin) * step;
  const bool rational = points_->components != block_entries;
  for (int q = range.begin; q < range.end;
       ++q, factors += 2, from += step, to += block_entries * native_lane_count) {
    if (rational)
      scale_point<true>(from, factors[0], factors[1], to);
    else
      scale_point<false>(from, factors[0], factors[1], to);
  }
}

// One register of points of u, at one point of v.
void StiffnessIntegrator::contract_w_at(const double* from) {
  constexpr int operand_step = block_entries * native_lane_count;
  const Range own = common_points(task_.a_w);
  scale_points(from, task_.a_w, own, operand_a_.data());
  double* out = sums_.data();
  for (int b = group_.begin; b < group_.end; ++b, out += operand_step) {
    const Range common = common_points(b);
    if (b != task_.a_w) scale_points(from, b, common, operand_b_.data());
    const double* const x = operand_a_.data() + (common.begin - own.begin) * operand_step;
    const double* const y = b == task_.a_w ? x : operand_b_.data();
    for (int s = 0; s < 3; ++s)
      for (int r = 0; r < 3; ++r)
        sum_block(x + 3 * s * native_lane_count, y + 3 * r * native_lane_count, common.end - common.begin,
                  patch_->material,
                  out + static_cast<std::ptrdiff_t>(3 * s + r) * per_point_ * native_lane_count);
  }
}

void StiffnessIntegrator::contract_u(int a) {
  const StiffnessTables& t = *tables_;
  const Overlap& overlap = t.overlap(0, a);
  const int step = result_kinds * line_;
  const int count = t.degrees[0] + 1;
  const int terms = static_cast<int>(t.terms_u.size());
  // The sums of the first element's functions are set, the others start from zero.
  std::fill_n(line_sums_.begin() + count * step, (overlap.count() - count) * step, 0.0);
  for (int e = overlap.first_element; e <= overlap.last_element; ++e) {
    const int first = t.first[0][static_cast<std::size_t>(e)];
    const double* const factors = t.factors_u[static_cast<std::size_t>(e)].data() +
                                  static_cast<std::ptrdiff_t>(a - first) * terms * count;
    const int* const offsets = offsets_u_.data() + static_cast<std::ptrdiff_t>(e) * terms;
    for (int kind = 0; kind < result_kinds; ++kind) {
      const int begin = t.kind_begin_u[static_cast<std::size_t>(kind)];
      const int end = t.kind_begin_u[static_cast<std::size_t>(kind) + 1];
      const SmallProducts::Operands operands = {
          factors + begin * count,
          offsets + begin,
          end - begin,
          ring_.data(),
          line_sums_.data() + (first - overlap.low) * step + kind * line_,
          step};
      if (e == overlap.first_element)
        products_u_.multiply(operands);
      else
        products_u_.multiply_add(operands);
    }
  }
}

void StiffnessIntegrator::contract_v(int a, int layer) {
  const StiffnessTables& t = *tables_;
  const int width = t.overlap(0, a).count();
  const double* const factors = t.factors_v[static_cast<std::size_t>(layer)].data();
  for (int b = 0; b < width; ++b)
    products_v_.multiply({factors, offsets_v_.data(), static_cast<int>(offsets_v_.size()),
                          line_sums_.data() + static_cast<std::ptrdiff_t>(b) * result_kinds * line_,
                          blocks_.data() + static_cast<std::ptrdiff_t>(b) * pair_step_, width * pair_step_});
}

void StiffnessIntegrator::add(int a, int layer, const BlockTargets& targets, CollectedBlocks& collected,
                              solvers::SymmetricBlockMatrix& matrix) const {
  using Where = Target::Where;
  const StiffnessTables& t = *tables_;
  const Overlap& overlap = t.overlap(0, a);
  const int width = overlap.count();
  const int first_v = t.first[1][static_cast<std::size_t>(layer)];
  const int count = t.degrees[1] + 1;
  const double* const weights = patch_->weights;
  const auto node = [&](int i, int j, int k) { return i + t.sizes[0] * (j + t.sizes[1] * k); };
  const double* pair = blocks_.data();
  for (int j = 0; j < count; ++j) {
    const int own = node(a, first_v + j, task_.a_w);
    const auto row_start = [&](int of) {
      return block_entries * matrix.row_start[static_cast<std::size_t>(patch_->rows.row_of_node[of])];
    };
    // The next function's row comes into the cache meanwhile; its blocks lie about as far behind.
    const std::ptrdiff_t ahead = a + 1 < task_.u_end ? row_start(own + 1) - row_start(own) : 0;
    double* const row = matrix.values.data() + row_start(own);
    for (int l = 0; l < count; ++l, pair += static_cast<std::ptrdiff_t>(width) * pair_step_) {
      for (int k = group_.begin; k < group_.end; ++k) {
        const Target* const target = targets.line(a, first_v + j, first_v + l, k);
        const double* from = pair + block_entries * (k - group_.begin);
        const int other = node(overlap.low, first_v + l, k);
        const auto factor = [&](int m) {
          return weights == nullptr ? 1.0 : weights[own] * weights[other + m];
        };
        if (target->where == Where::run) {
          double* to = row + block_entries * static_cast<std::ptrdiff_t>(target->at);
          for (int m = 0; m < width; ++m, from += pair_step_, to += block_entries) {
            __builtin_prefetch(to + ahead, 1);
            add_block(from, factor(m), to);
          }
          continue;
        }
        for (int m = 0; m < width; ++m, from += pair_step_) {
          if (target[m].where == Where::nowhere) continue;
          const auto at = static_cast<std::ptrdiff_t>(target[m].at);
          add_block(from, factor(m),
                    target[m].where == Where::a_row ? row + block_entries * at : collected.block(at));
        }
      }
    }
  }
}

}  // namespace isopatch::iga

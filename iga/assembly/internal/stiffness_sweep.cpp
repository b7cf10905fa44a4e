#include "iga/assembly/internal/stiffness_sweep.hpp"

#include <algorithm>

#include "iga/internal/registers.hpp"
#include "iga/internal/square_transpose.hpp"

namespace isopatch::iga {
namespace {

constexpr int kinds = 9;         // of sums after direction 3
constexpr int result_kinds = 4;  // after direction 1
constexpr int block_entries = 9;
constexpr std::size_t ring_bytes = std::size_t{512} << 10;  // must stay in the second cache

// The nine sums over the points of direction 3 of x_i y_j, turned into a block of the stiffness.
inline void sum_block(const double* x, const double* y, int points, const Material& material, double* out) {
  constexpr int step = block_entries * register_size;
  Register sums[3][3] = {};
  for (int q = 0; q < points; ++q, x += step, y += step) {
    const Register y0 = load(y), y1 = load(y + register_size), y2 = load(y + 2 * register_size);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const Register xi = load(x + i * register_size);
      sums[i][0] += xi * y0;
      sums[i][1] += xi * y1;
      sums[i][2] += xi * y2;
    }
  }
  const Register shear = material.mu * (sums[0][0] + sums[1][1] + sums[2][2]);
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i)
#pragma GCC unroll 3
    for (int j = 0; j < 3; ++j) {
      Register block = material.lambda * sums[i][j] + material.mu * sums[j][i];
      if (i == j) block += shear;
      store(out + (3 * i + j) * register_size, block);
    }
}

// [s][i]: s = 0 is the parameter of direction 3, which the factors differentiate, with what multiplies the
// function itself; s = 1, 2 the parameters of directions 1 and 2.
template <bool Rational>
inline void scale_point(const double* from, double value, double derivative, double* to) {
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    Register last = derivative * load(from + (6 + i) * register_size);
    if constexpr (Rational) last += value * load(from + (9 + i) * register_size);
    store(to + i * register_size, last);
    store(to + (3 + i) * register_size, value * load(from + i * register_size));
    store(to + (6 + i) * register_size, value * load(from + (3 + i) * register_size));
  }
}

inline __attribute__((always_inline)) void add_block(const double* from, double factor, double* to) {
  constexpr int whole = block_entries / register_size * register_size;
#pragma GCC unroll 4
  for (int k = 0; k < whole; k += register_size) store(to + k, load(to + k) + factor * load(from + k));
#pragma GCC unroll 1
  for (int k = whole; k < block_entries; ++k) to[k] += factor * from[k];
}

}  // namespace

const double* PointData::block(int second, int block, int third) const {
  return values + ((static_cast<std::ptrdiff_t>(second) * blocks + block) * thirds + third) * components *
                      register_size;
}

void StiffnessSweep::run(const StiffnessTask& task, const StiffnessTables& tables, const PointData& points,
                         const Material& material, const double* weights, const PatchRows& rows,
                         const BlockTargets& targets, CollectedBlocks& collected,
                         solvers::SymmetricBlockMatrix& matrix) {
  tables_ = &tables;
  points_ = &points;
  material_ = material;
  weights_ = weights;
  task_ = task;
  const int high = tables.overlap(2, task.third).high;
  const int count = high - task.third + 1;
  const std::size_t bytes_per_b =
      sizeof(double) * kinds * block_entries *
      static_cast<std::size_t>(tables.points[1] *
                               (tables.most_elements * tables.points[0] + 2 * register_size));
  const int most = std::max(1, static_cast<int>(ring_bytes / bytes_per_b));
  const int groups = (count + most - 1) / most;
  for (int group = 0, begin = task.third; group < groups; ++group) {
    group_ = {begin, begin + (high + 1 - begin + groups - group - 1) / (groups - group)};
    begin = group_.end;
    choose_sizes();
    for (int layer = task.layer_begin; layer < task.layer_end; ++layer) {
      int block = tables.overlap(0, task.first_begin).first_element * tables.points[0] / register_size;
      for (int a = task.first_begin; a < task.first_end; ++a) {
        const int needed = (tables.overlap(0, a).last_element + 1) * tables.points[0];
        for (; block * register_size < needed; ++block) contract_third(block, layer);
        contract_first(a);
        contract_second(a, layer);
        add(a, layer, rows, targets, collected, matrix);
      }
    }
  }
}

void StiffnessSweep::choose_sizes() {
  const StiffnessTables& t = *tables_;
  per_point_ = block_entries * (group_.end - group_.begin);
  line_ = padded(t.points[1] * per_point_);
  ring_blocks_ = (t.most_elements * t.points[0] + 2 * register_size - 2) / register_size + 1;
  pair_step_ = padded(per_point_);
  const int thirds = t.points[2] * (t.last_layer - t.first_layer);
  const auto grow = [](std::vector<double>& buffer, int size) {
    if (static_cast<int>(buffer.size()) < size) buffer.resize(static_cast<std::size_t>(size));
  };
  grow(first_operand_, thirds * block_entries * register_size);
  grow(second_operand_, thirds * block_entries * register_size);
  grow(sums_, kinds * per_point_ * register_size);
  grow(ring_, ring_blocks_ * register_size * kinds * line_);
  int widest = 0;
  for (const Overlap& overlap : t.overlaps[0]) widest = std::max(widest, overlap.count());
  grow(line_sums_, widest * result_kinds * line_ + register_size);
  grow(blocks_, (t.degrees[1] + 1) * (t.degrees[1] + 1) * widest * pair_step_);
  first_products_ = SmallProducts(t.degrees[0] + 1, line_);
  second_products_ = SmallProducts((t.degrees[1] + 1) * (t.degrees[1] + 1), per_point_);
  choose_offsets();
}

void StiffnessSweep::choose_offsets() {
  const StiffnessTables& t = *tables_;
  first_offsets_.clear();
  for (int e = 0; e < t.elements(0); ++e)
    for (const StiffnessTables::Term& term : t.first_terms) {
      const int point = (e * t.points[0] + term.point) % (ring_blocks_ * register_size);
      first_offsets_.push_back((point * kinds + term.kind) * line_);
    }
  second_offsets_.clear();
  for (int kind = 0; kind < result_kinds; ++kind)
    for (int q = 0; q < t.points[1]; ++q) second_offsets_.push_back(kind * line_ + q * per_point_);
}

// Points of direction 3 in the common support of a and b, from the part's first layer on.
StiffnessSweep::Range StiffnessSweep::third_points(int b) const {
  const StiffnessTables& t = *tables_;
  const int begin = t.overlap(2, b).first_element;
  const int end = t.overlap(2, task_.third).last_element + 1;
  return {t.points[2] * (begin - t.first_layer), t.points[2] * (end - t.first_layer)};
}

void StiffnessSweep::contract_third(int block, int layer) {
  const StiffnessTables& t = *tables_;
  const int per_lane = kinds * line_;
  double* const slot =
      ring_.data() + static_cast<std::ptrdiff_t>(block % ring_blocks_) * register_size * per_lane;
  for (int q = 0; q < t.points[1]; ++q) {
    contract_third_at(points_->block((layer - points_->layer_begin) * t.points[1] + q, block, 0));
    double* lanes[register_size];
    for (int lane = 0; lane < register_size; ++lane) lanes[lane] = slot + lane * per_lane + q * per_point_;
    for (int kind = 0; kind < kinds; ++kind) {
      const double* const from =
          sums_.data() + static_cast<std::ptrdiff_t>(kind) * per_point_ * register_size;
      for (int entry = 0; entry < per_point_; entry += register_size) {
        // The last square overlaps the one before it.
        const int start = std::min(entry, per_point_ - register_size);
        transpose(from + start * register_size, lanes, kind * line_ + start);
      }
    }
  }
}

// The numbers of one register of points of direction 1 along direction 3, times a function and its
// derivative.
void StiffnessSweep::scale_points(const double* from, int function, const Range& range, double* to) const {
  const StiffnessTables& t = *tables_;
  const int own_begin = t.points[2] * (t.overlap(2, function).first_element - t.first_layer);
  const double* factors =
      t.third_factors[static_cast<std::size_t>(function)].data() + 2 * (range.begin - own_begin);
  const int step = points_->components * register_size;
  from += static_cast<std::ptrdiff_t>(range.begin) * step;
  const bool rational = points_->components != block_entries;
  for (int q = range.begin; q < range.end;
       ++q, factors += 2, from += step, to += block_entries * register_size) {
    if (rational)
      scale_point<true>(from, factors[0], factors[1], to);
    else
      scale_point<false>(from, factors[0], factors[1], to);
  }
}

// One register of points of direction 1, at one point of direction 2.
void StiffnessSweep::contract_third_at(const double* from) {
  constexpr int operand_step = block_entries * register_size;
  const Range own = third_points(task_.third);
  scale_points(from, task_.third, own, first_operand_.data());
  double* out = sums_.data();
  for (int b = group_.begin; b < group_.end; ++b, out += operand_step) {
    const Range common = third_points(b);
    if (b != task_.third) scale_points(from, b, common, second_operand_.data());
    const double* const x = first_operand_.data() + (common.begin - own.begin) * operand_step;
    const double* const y = b == task_.third ? x : second_operand_.data();
    for (int s = 0; s < 3; ++s)
      for (int u = 0; u < 3; ++u)
        sum_block(x + 3 * s * register_size, y + 3 * u * register_size, common.end - common.begin, material_,
                  out + static_cast<std::ptrdiff_t>(3 * s + u) * per_point_ * register_size);
  }
}

void StiffnessSweep::contract_first(int a) {
  const StiffnessTables& t = *tables_;
  const Overlap& overlap = t.overlap(0, a);
  const int step = result_kinds * line_;
  const int count = t.degrees[0] + 1;
  const int terms = static_cast<int>(t.first_terms.size());
  // The sums of the first element's functions are set, the others start from zero.
  std::fill_n(line_sums_.begin() + count * step, (overlap.count() - count) * step, 0.0);
  for (int e = overlap.first_element; e <= overlap.last_element; ++e) {
    const int first = t.first[0][static_cast<std::size_t>(e)];
    const double* const factors = t.first_factors[static_cast<std::size_t>(e)].data() +
                                  static_cast<std::ptrdiff_t>(a - first) * terms * count;
    const int* const offsets = first_offsets_.data() + static_cast<std::ptrdiff_t>(e) * terms;
    for (int kind = 0; kind < result_kinds; ++kind) {
      const int begin = t.first_kind_begin[static_cast<std::size_t>(kind)];
      const int end = t.first_kind_begin[static_cast<std::size_t>(kind) + 1];
      const SmallProducts::Operands operands = {
          factors + begin * count,
          offsets + begin,
          end - begin,
          ring_.data(),
          line_sums_.data() + (first - overlap.low) * step + kind * line_,
          step};
      if (e == overlap.first_element)
        first_products_.multiply(operands);
      else
        first_products_.multiply_add(operands);
    }
  }
}

void StiffnessSweep::contract_second(int a, int layer) {
  const StiffnessTables& t = *tables_;
  const int width = t.overlap(0, a).count();
  const double* const factors = t.second_factors[static_cast<std::size_t>(layer)].data();
  for (int b = 0; b < width; ++b)
    second_products_.multiply({factors, second_offsets_.data(), static_cast<int>(second_offsets_.size()),
                               line_sums_.data() + static_cast<std::ptrdiff_t>(b) * result_kinds * line_,
                               blocks_.data() + static_cast<std::ptrdiff_t>(b) * pair_step_,
                               width * pair_step_});
}

void StiffnessSweep::add(int a, int layer, const PatchRows& rows, const BlockTargets& targets,
                         CollectedBlocks& collected, solvers::SymmetricBlockMatrix& matrix) {
  const StiffnessTables& t = *tables_;
  const Overlap& overlap = t.overlap(0, a);
  const int width = overlap.count();
  const int first_second = t.first[1][static_cast<std::size_t>(layer)];
  const int count = t.degrees[1] + 1;
  const auto node = [&](int i, int j, int k) { return i + t.sizes[0] * (j + t.sizes[1] * k); };
  const double* pair = blocks_.data();
  for (int j = 0; j < count; ++j) {
    const int own = node(a, first_second + j, task_.third);
    const auto row_start = [&](int of) {
      return 9 * matrix.row_start[static_cast<std::size_t>(rows.row_of_node[of])];
    };
    // The next function's row comes into the cache meanwhile; its blocks lie about as far behind.
    const std::ptrdiff_t ahead = a + 1 < task_.first_end ? row_start(own + 1) - row_start(own) : 0;
    double* const row = matrix.values.data() + row_start(own);
    for (int l = 0; l < count; ++l, pair += static_cast<std::ptrdiff_t>(width) * pair_step_) {
      for (int k = group_.begin; k < group_.end; ++k) {
        const auto line = targets.line(a, first_second + j, first_second + l, k);
        const double* from = pair + block_entries * (k - group_.begin);
        const int other = node(overlap.low, first_second + l, k);
        const auto factor = [&](int m) {
          return weights_ == nullptr ? 1.0 : weights_[own] * weights_[other + m];
        };
        if (line.in_a_row) {
          double* to = row + 9 * static_cast<std::ptrdiff_t>(line.targets[0]);
          for (int m = 0; m < width; ++m, from += pair_step_, to += block_entries) {
            __builtin_prefetch(to + ahead, 1);
            add_block(from, factor(m), to);
          }
          continue;
        }
        for (int m = 0; m < width; ++m, from += pair_step_) {
          const std::int32_t target = line.targets[m];
          if (target == BlockTargets::nowhere) continue;
          double* const to = target >= 0 ? row + 9 * static_cast<std::ptrdiff_t>(target)
                                         : collected.values() + 9 * static_cast<std::ptrdiff_t>(-2 - target);
          add_block(from, factor(m), to);
        }
      }
    }
  }
}

}  // namespace isopatch::iga

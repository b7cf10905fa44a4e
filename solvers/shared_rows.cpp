#include "solvers/shared_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solvers/internal/mpi_session.hpp"

namespace isopatch::solvers {
namespace {

// Another process, and the local rows that it has as well, in the order of the whole system.
struct Neighbour {
  int rank = 0;
  std::vector<int> rows;
};

// Consecutive block rows.
struct Run {
  int begin = 0;
  int end = 0;
};

std::vector<Run> runs(const std::vector<int>& rows) {
  std::vector<Run> result;
  for (const int row : rows) {
    if (result.empty() || result.back().end != row) result.push_back({row, row});
    ++result.back().end;
  }
  return result;
}

template <class Vector>
Vector packed(const Vector& x, const std::vector<int>& rows, int size) {
  Vector values(size * static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    values.segment(size * static_cast<Eigen::Index>(i), size) =
        x.segment(size * static_cast<Eigen::Index>(rows[i]), size);
  return values;
}

template <class Vector>
void add(const Vector& values, const std::vector<int>& rows, int size, Vector& x) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    x.segment(size * static_cast<Eigen::Index>(rows[i]), size) +=
        values.segment(size * static_cast<Eigen::Index>(i), size);
}

MPI_Datatype type_of(const Eigen::VectorXd&) {
  return MPI_DOUBLE;
}
MPI_Datatype type_of(const SharedRows::ExtendedVector&) {
  return MPI_LONG_DOUBLE;
}

// What each neighbour has at the shared rows.
template <class Vector>
std::vector<Vector> exchanged(const Vector& x, const std::vector<Neighbour>& neighbours, int size) {
  constexpr int tag = 3;
  std::vector<Vector> sent, received;
  std::vector<MPI_Request> requests(2 * neighbours.size());
  sent.reserve(neighbours.size());
  for (const Neighbour& neighbour : neighbours) {
    sent.push_back(packed(x, neighbour.rows, size));
    received.emplace_back(sent.back().size());
  }
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const auto count = static_cast<int>(sent[i].size());
    MPI_Irecv(received[i].data(), count, type_of(x), neighbours[i].rank, tag, MPI_COMM_WORLD,
              &requests[2 * i]);
    MPI_Isend(sent[i].data(), count, type_of(x), neighbours[i].rank, tag, MPI_COMM_WORLD,
              &requests[2 * i + 1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return received;
}

}  // namespace

struct SharedRows::State {
  Processes processes;
  int block_size = solvers::block_size;
  int global_rows = 0;
  std::vector<int> global_of_local;
  std::vector<int> owned;
  std::vector<Run> owned_runs;
  std::vector<Neighbour> neighbours;  // increasing ranks
  std::vector<int> shared;            // local rows of any neighbour, increasing

  // Every process adds in the order of the ranks, so all get the same bits.
  template <class Vector>
  void sum(Vector& x) const {
    if (neighbours.empty()) return;
    const std::vector<Vector> received = exchanged(x, neighbours, block_size);
    const Vector own = packed(x, shared, block_size);
    for (const int row : shared) x.segment(block_size * static_cast<Eigen::Index>(row), block_size).setZero();
    std::size_t i = 0;
    for (; i < neighbours.size() && neighbours[i].rank < processes.rank(); ++i)
      add(received[i], neighbours[i].rows, block_size, x);
    add(own, shared, block_size, x);
    for (; i < neighbours.size(); ++i) add(received[i], neighbours[i].rows, block_size, x);
  }

  double owned_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    double result = 0;
    for (const Run& run : owned_runs) {
      const Eigen::Index begin = block_size * static_cast<Eigen::Index>(run.begin);
      const Eigen::Index length = block_size * static_cast<Eigen::Index>(run.end - run.begin);
      result += a.segment(begin, length).dot(b.segment(begin, length));
    }
    return result;
  }
};

SharedRows::SharedRows(int block_rows) {
  State state;
  state.global_rows = block_rows;
  state.global_of_local.resize(static_cast<std::size_t>(block_rows));
  std::iota(state.global_of_local.begin(), state.global_of_local.end(), 0);
  state.owned = state.global_of_local;
  state_ = std::make_shared<const State>(std::move(state));
}

SharedRows::SharedRows(const std::vector<std::vector<int>>& processes_of_row, const Processes& processes,
                       int unknowns_per_row) {
  State state;
  state.processes = processes;
  state.block_size = unknowns_per_row;
  state.global_rows = static_cast<int>(processes_of_row.size());
  std::vector<std::vector<int>> with(static_cast<std::size_t>(processes.count()));
  for (int row = 0; row < state.global_rows; ++row) {
    const std::vector<int>& sharing = processes_of_row[static_cast<std::size_t>(row)];
    if (!std::binary_search(sharing.begin(), sharing.end(), processes.rank())) continue;
    const auto local = static_cast<int>(state.global_of_local.size());
    state.global_of_local.push_back(row);
    if (sharing.front() == processes.rank()) state.owned.push_back(local);
    if (sharing.size() == 1) continue;
    state.shared.push_back(local);
    for (const int other : sharing) with[static_cast<std::size_t>(other)].push_back(local);
  }
  for (int other = 0; other < processes.count(); ++other)
    if (other != processes.rank() && !with[static_cast<std::size_t>(other)].empty())
      state.neighbours.push_back({other, std::move(with[static_cast<std::size_t>(other)])});
  state.owned_runs = runs(state.owned);
  state_ = std::make_shared<const State>(std::move(state));
}

int SharedRows::local_rows() const {
  return static_cast<int>(state_->global_of_local.size());
}
int SharedRows::global_rows() const {
  return state_->global_rows;
}
const std::vector<int>& SharedRows::global_of_local() const {
  return state_->global_of_local;
}
const std::vector<int>& SharedRows::owned() const {
  return state_->owned;
}
bool SharedRows::is_distributed() const {
  return state_->processes.count() > 1;
}
const Processes& SharedRows::processes() const {
  return state_->processes;
}

void SharedRows::sum(Eigen::VectorXd& x) const {
  state_->sum(x);
}
void SharedRows::sum(ExtendedVector& x) const {
  state_->sum(x);
}

double SharedRows::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  if (!is_distributed()) return a.dot(b);
  return state_->processes.sum(state_->owned_dot(a, b));
}

double SharedRows::norm(const Eigen::VectorXd& x) const {
  // Eigen's largest coefficient passes over what is no number, and with it the stable norm.
  if (!is_distributed()) return x.allFinite() ? x.stableNorm() : std::numeric_limits<double>::quiet_NaN();
  const double own = x.size() == 0 ? 0 : x.cwiseAbs().maxCoeff();
  const double size =
      state_->processes.largest(x.allFinite() ? own : std::numeric_limits<double>::infinity());
  if (size == 0) return 0;
  const Eigen::VectorXd unit = x / size;
  return size * std::sqrt(dot(unit, unit));
}

Eigen::VectorXd SharedRows::whole(const Eigen::VectorXd& x) const {
  if (!is_distributed()) return x;
  const int size = state_->block_size;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(size * static_cast<Eigen::Index>(global_rows()));
  for (const int row : owned())
    result.segment(size * static_cast<Eigen::Index>(global_of_local()[static_cast<std::size_t>(row)]), size) =
        x.segment(size * static_cast<Eigen::Index>(row), size);
  state_->processes.sum(result);
  return result;
}

Eigen::VectorXd SharedRows::part(const Eigen::VectorXd& whole) const {
  return is_distributed() ? packed(whole, global_of_local(), state_->block_size) : whole;
}

}  // namespace isopatch::solvers

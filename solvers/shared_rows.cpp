#include "solvers/shared_rows.hpp"

#include <numeric>

namespace isopatch::solvers {

struct SharedRows::State {
  int global_rows = 0;
  std::vector<int> global_of_local;
  std::vector<int> owned;
};

SharedRows::SharedRows(int block_rows) {
  State state;
  state.global_rows = block_rows;
  state.global_of_local.resize(static_cast<std::size_t>(block_rows));
  std::iota(state.global_of_local.begin(), state.global_of_local.end(), 0);
  state.owned = state.global_of_local;
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
  return false;
}
void SharedRows::sum(Eigen::VectorXd&) const {}

double SharedRows::dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return a.dot(b);
}

}  // namespace isopatch::solvers

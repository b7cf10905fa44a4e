#include "solvers/process_failure.hpp"

#include <chrono>
#include <thread>

#include "solvers/internal/mpi_session.hpp"

namespace isopatch::solvers {
namespace {

constexpr int failure_tag = 911;

// Takes news of failures until all of `awaited` have come or time is up. Returns who is still missing.
std::vector<int> receive_failures(std::vector<int> awaited) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(2);
  while (true) {
    std::erase_if(awaited, [](int rank) {
      int arrived = 0;
      MPI_Iprobe(rank, failure_tag, MPI_COMM_WORLD, &arrived, MPI_STATUS_IGNORE);
      if (arrived) MPI_Recv(nullptr, 0, MPI_BYTE, rank, failure_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      return arrived != 0;
    });
    if (awaited.empty() || Clock::now() > end) return awaited;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

ProcessFailure::ProcessFailure(const Processes& processes) {
  std::vector<int> lower;
  for (int other = 0; other < processes.count(); ++other) {
    if (other == processes.rank()) continue;
    MPI_Request request;
    MPI_Isend(nullptr, 0, MPI_BYTE, other, failure_tag, MPI_COMM_WORLD, &request);
    MPI_Request_free(&request);
    (other < processes.rank() ? lower : silent_).push_back(other);
  }
  if (lower.empty()) return;
  const std::vector<int> still_silent = receive_failures(lower);
  is_to_report_ = still_silent.size() == lower.size();
  silent_.insert(silent_.end(), still_silent.begin(), still_silent.end());
}

void ProcessFailure::leave_or_abort(int exit_code) {
  if (silent_.empty()) return;
  silent_ = receive_failures(std::move(silent_));
  if (!silent_.empty()) MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace isopatch::solvers

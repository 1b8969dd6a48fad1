// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fem/mpi_session.hpp"

// The headers of deal.II cause warnings that this project treats as errors.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#include <deal.II/base/mpi.h>
#pragma GCC diagnostic pop
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <thread>

#include "direct_solver.hpp"

namespace strainwave::fem {

struct MpiSession::Impl {
  dealii::Utilities::MPI::MPI_InitFinalize session;
  std::chrono::duration<double> patience;
  /// separate channel for faults, because other ranks may wait for any other message
  MPI_Comm ends = MPI_COMM_NULL;

  static constexpr int kNobody = std::numeric_limits<int>::max();
  /// The least number of all ranks.  A rank with a complaint waits only for a limited time, because
  /// the others may be waiting for it elsewhere.
  [[nodiscard]] int least(int mine, const std::function<void()>& complain) const {
    int result = kNobody;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&mine, &result, 1, MPI_INT, MPI_MIN, ends, &request);
    const auto start = std::chrono::steady_clock::now();
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0;) {
      if (complain && std::chrono::steady_clock::now() - start > patience) {
        complain();
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return result;
  }
};

MpiSession::MpiSession(int& argc, char**& argv, std::chrono::duration<double> patience) {
  prepare_blas();
  // Without mpirun, Open MPI needs no daemon, because the program does not start further processes.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  impl_ = new Impl{dealii::Utilities::MPI::MPI_InitFinalize(argc, argv, 1), patience};
  MPI_Comm_dup(MPI_COMM_WORLD, &impl_->ends);
}
MpiSession::~MpiSession() {
  MPI_Comm_free(&impl_->ends);
  delete impl_;
}
int MpiSession::rank() const {
  return static_cast<int>(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
}
int MpiSession::size() const {
  return static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
}
int MpiSession::on_this_machine() const {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int ranks = 1;
  MPI_Comm_size(machine, &ranks);
  MPI_Comm_free(&machine);
  return ranks;
}
std::string MpiSession::from_first(const std::string& text) const {
  return dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, text, 0);
}
bool MpiSession::all(bool here) const {
  return dealii::Utilities::MPI::min(here ? 1 : 0, MPI_COMM_WORLD) == 1;
}
int MpiSession::last_code(int code, const std::function<void()>& complain) const {
  constexpr int kCodes = 1000;  // more than the number of codes
  const int mine = complain ? rank() * kCodes + code : Impl::kNobody;
  const int first = impl_->least(mine, complain);
  if (first == Impl::kNobody) return code;
  if (first == mine) complain();
  return first % kCodes;
}
void MpiSession::agree(const std::exception_ptr& fault, const std::string& words) const {
  const int here = rank();
  std::function<void()> complain;
  // The sentence is written at once, because mpirun puts its own words between two writes.
  if (fault) complain = [&] { std::cerr << fmt::format("rank {}: {}\n", here, words); };
  const int first = impl_->least(fault ? here : Impl::kNobody, complain);
  if (first == Impl::kNobody) return;
  const std::string others =
      dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, words, static_cast<unsigned>(first));
  if (fault) std::rethrow_exception(fault);
  throw OtherRankError(others);
}

}  // namespace strainwave::fem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "strainwave/core/ranks.hpp"

namespace strainwave::fem {

/// The MPI ranks.  The object initialises MPI, PETSc and the BLAS kernels for its lifetime.  A
/// program must have only one.
class MpiSession : public Ranks {
 public:
  /// @param patience  how long a rank with a fault waits for other ranks, which may be waiting for
  ///                  it
  MpiSession(int& argc, char**& argv,
             std::chrono::duration<double> patience = std::chrono::seconds(10));
  ~MpiSession() override;
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
  MpiSession(MpiSession&&) = delete;
  MpiSession& operator=(MpiSession&&) = delete;

  [[nodiscard]] int rank() const override;
  [[nodiscard]] int size() const override;
  [[nodiscard]] int on_this_machine() const override;
  [[nodiscard]] std::string from_first(const std::string& text) const override;
  [[nodiscard]] bool all(bool here) const override;
  [[nodiscard]] int last_code(int code, const std::function<void()>& complain) const override;

 private:
  void agree(const std::exception_ptr& fault, const std::string& words) const override;

  struct Impl;
  Impl* impl_ = nullptr;
};

}  // namespace strainwave::fem

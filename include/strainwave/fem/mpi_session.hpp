// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <string>

#include "strainwave/core/error.hpp"

namespace strainwave::fem {

/// Another rank failed, and says why; this one did not.
class OtherRankError : public Error {
 public:
  using Error::Error;
};

/// Initialises MPI, PETSc and the kernels of BLAS for as long as it lives; one per program.
class MpiSession {
 public:
  /// @param patience  how long a rank that has a fault waits for the others, which may wait for it
  MpiSession(int& argc, char**& argv,
             std::chrono::duration<double> patience = std::chrono::seconds(10));
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  [[nodiscard]] int rank() const;
  [[nodiscard]] int size() const;
  /// Ranks on this machine; they share its memory.
  [[nodiscard]] int on_this_machine() const;
  /// The first rank's text on every rank; all must call it.
  [[nodiscard]] std::string from_first(const std::string& text) const;
  /// The text of the first rank that has one on every rank; all must call it.
  [[nodiscard]] std::string from_any(const std::string& text) const;
  /// True if it is so on every rank; all of them must ask.
  [[nodiscard]] bool all(bool here) const;

  /// Does a part of the work; where it fails on any rank, it ends on all.
  ///
  /// All must call it.  A rank that fails while others wait for it within `part` loses patience,
  /// says so on standard error, and ends them all.
  /// @throws  what `part` threw here, else OtherRankError if it threw elsewhere
  template <class Part>
  void together(const Part& part) const {
    std::exception_ptr fault;
    std::string words;
    try {
      part();
    } catch (const std::exception& error) {
      fault = std::current_exception();
      words = error.what();
    }
    agree(fault, words);
  }

  /// The last call of a program, by every rank.  The first rank that has a fault speaks, for all.
  ///
  /// Where a rank has a fault alone, while others still calculate or wait for it, it loses
  /// patience, speaks, and ends them all.
  /// @param code      exit code of this rank
  /// @param complain  says what its fault is; none if it has none of its own
  /// @return the code of the first rank that has a fault, else `code`
  [[nodiscard]] int last_code(int code, const std::function<void()>& complain) const;

 private:
  void agree(const std::exception_ptr& fault, const std::string& words) const;

  struct Impl;
  Impl* impl_ = nullptr;
};

}  // namespace strainwave::fem

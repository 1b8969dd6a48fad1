// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "strainwave/core/error.hpp"

namespace strainwave {

/// Thrown on a rank that did not fail itself, while another rank failed and reports why.
class OtherRankError : public Error {
 public:
  using Error::Error;
};

/// The processes (ranks) that run one computation together, as seen from this process.  This base
/// class represents a single process.
class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  Ranks(Ranks&&) = delete;
  Ranks& operator=(Ranks&&) = delete;

  /// Number of this process, from 0 to size() - 1.
  [[nodiscard]] virtual int rank() const { return 0; }
  /// Number of processes, 1 or more.
  [[nodiscard]] virtual int size() const { return 1; }
  /// Number of ranks on this machine, which share its memory.
  [[nodiscard]] virtual int on_this_machine() const { return 1; }
  /// Returns the first rank's text on every rank; all ranks must call it.
  [[nodiscard]] virtual std::string from_first(const std::string& text) const { return text; }
  /// Returns whether `here` is true on every rank; all ranks must call it.
  [[nodiscard]] virtual bool all(bool here) const { return here; }
  /// Whether this is the first process, rank 0.
  [[nodiscard]] bool first() const { return rank() == 0; }

  /// Does a part of the work.  If the part fails on any rank, it ends on all ranks.
  ///
  /// All ranks must call it.  If a rank fails while others wait for it inside `part`, it waits for
  /// a while, reports the failure on standard error, and ends all ranks.
  /// @throws  the exception of `part` on this rank, else OtherRankError if `part` threw on another
  ///          rank
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

  /// The last call of a program, made by every rank.  The first rank with a fault reports it for
  /// all.
  ///
  /// If a rank fails while others still compute or wait for it, it waits for a while, reports its
  /// fault, and ends all ranks.
  /// @param code      exit code of this rank
  /// @param complain  reports the fault of this rank; empty if this rank has no fault of its own
  /// @return the code of the first rank with a fault, else `code`
  [[nodiscard]] virtual int last_code(int code, const std::function<void()>& complain) const {
    if (complain) complain();
    return code;
  }

 private:
  virtual void agree(const std::exception_ptr& fault, const std::string&) const {
    if (fault) std::rethrow_exception(fault);
  }
};

}  // namespace strainwave

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "strainwave/core/error.hpp"

namespace strainwave {

/// Another rank failed, and says why; this one did not.
class OtherRankError : public Error {
 public:
  using Error::Error;
};

/// The processes that run one computation together, as this one of them sees them.  This class
/// stands for a process that is alone.
class Ranks {
 public:
  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  Ranks(Ranks&&) = delete;
  Ranks& operator=(Ranks&&) = delete;

  [[nodiscard]] virtual int rank() const { return 0; }
  [[nodiscard]] virtual int size() const { return 1; }
  /// Ranks on this machine; they share its memory.
  [[nodiscard]] virtual int on_this_machine() const { return 1; }
  /// The first rank's text on every rank; all must call it.
  [[nodiscard]] virtual std::string from_first(const std::string& text) const { return text; }
  /// True if it is so on every rank; all of them must ask.
  [[nodiscard]] virtual bool all(bool here) const { return here; }
  [[nodiscard]] bool first() const { return rank() == 0; }

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

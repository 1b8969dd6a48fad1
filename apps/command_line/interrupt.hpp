// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace strainwave::cli {

/// While it lives, the first SIGINT does not end the process; what reports its progress to it stops
/// instead.  The second one ends it.  There is at most one at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  Interrupt(Interrupt&&) = delete;
  Interrupt& operator=(Interrupt&&) = delete;

  /// @return  whether there was none yet
  [[nodiscard]] bool operator()(double) const;

 private:
  struct sigaction before_ {};
};

}  // namespace strainwave::cli

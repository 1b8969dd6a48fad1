// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

#include "strainwave/core/progress.hpp"

namespace strainwave::cli {

/// While it lives, the first SIGINT does not end the process; what reports to `progress` stops
/// instead.  The second one ends it.  There is at most one at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  Interrupt(Interrupt&&) = delete;
  Interrupt& operator=(Interrupt&&) = delete;

  [[nodiscard]] Progress progress() const;

 private:
  struct sigaction before_ {};
};

}  // namespace strainwave::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace strainwave::cli {

/// While this object exists, the first SIGINT does not end the process; computations that report
/// their progress to the object stop instead.  The second SIGINT ends the process.  Only one object
/// may exist at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  Interrupt(Interrupt&&) = delete;
  Interrupt& operator=(Interrupt&&) = delete;

  /// @return  true if no SIGINT has arrived yet
  [[nodiscard]] bool operator()(double) const;

 private:
  struct sigaction before_ {};
};

}  // namespace strainwave::cli

// SPDX-License-Identifier: Apache-2.0
#include "interrupt.hpp"

namespace strainwave::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void remember(int) { interrupted = 1; }

}  // namespace

Interrupt::Interrupt() {
  ::sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler == SIG_IGN) return;  // jobs in the background ignore SIGINT
  struct sigaction action {};
  action.sa_handler = remember;
  // SA_RESTART is not set, so the signal also ends a wait for the reader of a pipe.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &action, nullptr);
}

Interrupt::~Interrupt() { ::sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::operator()(double) const { return interrupted == 0; }

}  // namespace strainwave::cli

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// SIGINT and SIGTERM. The first one sets the cancel token, and the job ends at its next look at it; where that does
/// not come within a second the program ends all the same. A second signal ends the program at once. Commands that only
/// read (check, info) are not asked to look: there the first signal ends the program.
#pragma once

#include <atomic>
#include <csignal>

namespace geomesh::app {

void install_signal_handlers();

/// Set by the first signal; for RunContext::cancel.
const std::atomic<bool>& cancel_token();

/// From now on the first signal ends the program.
void leave_at_once_when_signalled();

/// 130 or 143, after a signal was received.
int status_of_signal();

/// Holds signals back while alive: for writing a file that must be complete or absent.
class SignalsHeldBack {
 public:
  SignalsHeldBack();
  ~SignalsHeldBack();
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  sigset_t before_;
};

}  // namespace geomesh::app

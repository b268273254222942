// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Handles SIGINT and SIGTERM. The first signal sets the cancel token, and the job ends when it next checks it; if that
/// does not happen within a second, the program ends anyway. A second signal ends the program at once. Commands that
/// only read (check, info) do not check the token: the first signal ends them.
#pragma once

#include <atomic>
#include <csignal>

namespace geomesh::app {

void install_signal_handlers();

/// Returns the token for RunContext::cancel, which the first signal sets.
const std::atomic<bool>& cancel_token();

/// After this call the first signal, instead of the second, ends the program at once.
void leave_at_once_when_signalled();

/// Returns the exit status after a signal was received: 130 or 143.
int status_of_signal();

/// Blocks signals while it exists, for writing a file that must be complete or absent.
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

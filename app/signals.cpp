// SPDX-License-Identifier: GPL-3.0-or-later
#include "signals.hpp"

#include <unistd.h>

#include "geomesh/geomodel/writers.hpp"

namespace geomesh::app {
namespace {

std::atomic<bool> cancelled{false}, at_once{false};
std::atomic<int> received{0};

/// Returns the exit status that shells use for a program ended by a signal.
int status_of(int number) { return 128 + number; }

/// Time after which the program ends even if the cancel token was not checked. Some steps check the token rarely:
/// libraries, and loops over one large surface.
constexpr unsigned seconds_to_end = 1;

extern "C" void on_signal(int number) {
  if (at_once || cancelled.exchange(true)) {
    geomodel::remove_files_being_written();
    _exit(status_of(number));
  }
  received = number;
  alarm(seconds_to_end);
}

/// Ends the program. Complete files already have their names; only the file being written is removed.
extern "C" void on_alarm(int) {
  geomodel::remove_files_being_written();
  constexpr char text[] = "\ninterrupted: nothing more was written\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, text, sizeof text - 1);
  _exit(status_of(received));
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = on_alarm;
  sigaction(SIGALRM, &action, nullptr);
  // A file that exceeds the allowed size is treated as a failed write, so that it is removed and reported.
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
}

const std::atomic<bool>& cancel_token() { return cancelled; }

void leave_at_once_when_signalled() { at_once = true; }

int status_of_signal() { return status_of(received != 0 ? received.load() : SIGINT); }

SignalsHeldBack::SignalsHeldBack() {
  sigset_t held;
  sigemptyset(&held);
  sigaddset(&held, SIGINT);
  sigaddset(&held, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &held, &before_);
}

SignalsHeldBack::~SignalsHeldBack() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace geomesh::app

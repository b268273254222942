// SPDX-License-Identifier: GPL-3.0-or-later
#include "signals.hpp"

#include <unistd.h>

#include "geomesh/geomodel/writers.hpp"

namespace geomesh::app {
namespace {

std::atomic<bool> cancelled{false}, at_once{false};
std::atomic<int> received{0};

/// The shell's convention for a program that a signal ended.
int status_of(int number) { return 128 + number; }

/// Some steps look at the token less often: libraries, and loops over one large surface. A user who has asked for an
/// end does not wait for them.
constexpr unsigned seconds_to_end = 1;

extern "C" void on_signal(int number) {
  if (at_once || cancelled.exchange(true)) {
    geomodel::remove_files_being_written();
    _exit(status_of(number));
  }
  received = number;
  alarm(seconds_to_end);
}

/// Files that are complete have their names already; what was being written is removed.
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
  // A file that outgrows the allowed size is a failed write like any other, to be tidied up and reported.
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

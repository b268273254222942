// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line, catches every error once and maps it to an exit status; a signal sets the cancel token.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>

#include "commands.hpp"

namespace {

std::atomic<bool> cancelled{false};
std::atomic<int> signal_received{0};

extern "C" void on_signal(int number) {
  if (cancelled.exchange(true)) _exit(128 + number);  // asked twice: leave at once
  signal_received = number;
}

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

constexpr int status_bug = 1;

int report_error(const char* kind, const char* text, int status) {
  std::fprintf(stderr, "%s: %s\n", kind, text);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace geomesh;
  install_signal_handlers();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  try {
    const app::CommandLine line = app::parse_command_line(argc, argv);
    RunContext context;
    context.cancel = &cancelled;
    context.threads = line.threads;
    app::Progress progress(line.verbosity, terminal);
    progress.attach(context);
    return app::run(line, context);
  } catch (const Error& error) {
    if (terminal) std::fputs("\r\033[K", stderr);
    if (error.kind() == ErrorKind::interrupted) {
      const int number = signal_received != 0 ? signal_received.load() : SIGINT;
      return report_error("interrupted", "nothing more was written", 128 + number);
    }
    return report_error("error", error.what(), static_cast<int>(error.kind()));
  } catch (const std::bad_alloc&) {
    return report_error("error", "out of memory: the model needs more than this machine has", static_cast<int>(ErrorKind::cannot_mesh));
  } catch (const std::filesystem::filesystem_error& error) {
    return report_error("error", error.what(), static_cast<int>(ErrorKind::usage));
  } catch (const std::exception& error) {
    return report_error("internal error", error.what(), status_bug);
  }
}

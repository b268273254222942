// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line, catches every error once and maps it to an exit status; signals set the cancel token.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "commands.hpp"
#include "signals.hpp"

namespace {

constexpr int status_bug = 1;

int report_error(const std::string& kind, const char* text, int status) {
  std::fprintf(stderr, "%s %s\n", geomesh::app::Colours::of(STDERR_FILENO).error(kind + ":").c_str(), text);
  return status;
}

/// Opens /dev/null in place of standard streams that the caller closed. Otherwise the next opened file would get the
/// number of such a stream, and messages would be written to that file.
void occupy_standard_streams() {
  for (int descriptor = open("/dev/null", O_RDWR); descriptor >= 0; descriptor = dup(descriptor)) {
    if (descriptor <= STDERR_FILENO) continue;
    close(descriptor);
    return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace geomesh;
  occupy_standard_streams();
  app::install_signal_handlers();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  try {
    const app::CommandLine line = app::parse_command_line(argc, argv);
    RunContext context;
    context.cancel = &app::cancel_token();
    context.threads = line.threads;
    app::Progress progress(line.verbosity,
                           line.json_progress ? app::ProgressStyle::json
                           : terminal         ? app::ProgressStyle::terminal
                                              : app::ProgressStyle::lines,
                           app::Colours::of(STDERR_FILENO));
    progress.attach(context);
    const int status = app::run(line, context);
    const bool printed = static_cast<bool>(std::cout.flush());
    progress.tell_warnings();
    if (!printed)
      throw Error(ErrorKind::usage,
                  "what was to be printed could not be written to the standard output (a full disk?)");
    return status;
  } catch (const Error& error) {
    if (terminal) std::fputs("\r\033[K", stderr);
    if (error.kind() == ErrorKind::interrupted) {
      return report_error("interrupted", "nothing more was written", app::status_of_signal());
    }
    return report_error("error", error.what(), static_cast<int>(error.kind()));
  } catch (const std::bad_alloc&) {
    return report_error("error", "out of memory: the model needs more than this machine has",
                        static_cast<int>(ErrorKind::cannot_mesh));
  } catch (const std::filesystem::filesystem_error& error) {
    return report_error("error", error.what(), static_cast<int>(ErrorKind::usage));
  } catch (const std::system_error& error) {  // for example, if the system allows no more threads
    return report_error(
        "error", (std::string("the system refuses what the run needs: ") + error.what() + "; try --threads 1").c_str(),
        static_cast<int>(ErrorKind::cannot_mesh));
  } catch (const std::exception& error) {
    return report_error("internal error", error.what(), status_bug);
  }
}

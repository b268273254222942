// SPDX-License-Identifier: GPL-3.0-or-later
// In a browser no other program can be started: what emscripten's C library lacks, with the answer that callers report.
#include <errno.h>
#include <spawn.h>

int posix_spawnp(pid_t* child, const char* file, const posix_spawn_file_actions_t* actions, const posix_spawnattr_t* attributes,
                 char* const arguments[], char* const environment[]) {
  (void)child, (void)file, (void)actions, (void)attributes, (void)arguments, (void)environment;
  return ENOSYS;
}

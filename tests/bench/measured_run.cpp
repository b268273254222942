// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_run.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace geomesh::bench {
namespace {

/// What crosses the pipe.
struct Packet {
  bool ok;
  double cpu_s, wall_s;
  std::size_t peak_bytes;
  Answer answer;
  char message[200];
};

double cpu_now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::size_t status_bytes(const char* key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  std::size_t kib = 0;
  while (status >> word)
    if (word == key) {
      status >> kib;
      break;
    }
  return 1024 * kib;
}

void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

Packet run(const Job& job) {
  Packet r{};
  reset_peak();
  const std::size_t before = status_bytes("VmRSS:");
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpu_now();
  try {
    r.answer = job();
    r.ok = true;
  } catch (const std::exception& e) {
    std::strncpy(r.message, e.what(), sizeof r.message - 1);
  }
  r.cpu_s = cpu_now() - cpu;
  r.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  const std::size_t peak = status_bytes("VmHWM:");
  r.peak_bytes = peak > before ? peak - before : 0;
  return r;
}

}  // namespace

void limit_cpu_seconds(double seconds) {
  const auto limit = static_cast<rlim_t>(cpu_now() + seconds + 1);
  const rlimit both{limit, limit + 5};
  setrlimit(RLIMIT_CPU, &both);
}

std::vector<Measurement> measure(const std::vector<Job>& side_by_side) {
  std::vector<int> pipes;
  std::vector<pid_t> children;
  for (const Job& job : side_by_side) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("cannot open a pipe");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) {
      const Packet packet = run(job);
      const bool sent = write(ends[1], &packet, sizeof packet) == static_cast<ssize_t>(sizeof packet);
      _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    pipes.push_back(ends[0]);
    children.push_back(child);
  }
  std::vector<Measurement> results;
  for (std::size_t i = 0; i < children.size(); ++i) {
    Packet packet{};
    Measurement m;
    const bool received = read(pipes[i], &packet, sizeof packet) == static_cast<ssize_t>(sizeof packet);
    close(pipes[i]);
    int status = 0;
    waitpid(children[i], &status, 0);
    if (received)
      m = {packet.ok, packet.message, packet.cpu_s, packet.wall_s, packet.peak_bytes, packet.answer};
    else
      m.message = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? "exceeds its time"
                  : WIFSIGNALED(status) ? "died of signal " + std::to_string(WTERMSIG(status))
                                        : "ended without an answer";
    results.push_back(m);
  }
  return results;
}

}  // namespace geomesh::bench

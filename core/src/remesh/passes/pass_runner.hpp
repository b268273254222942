// SPDX-License-Identifier: MIT
/// @file
/// Named passes over the whole mesh: what the schedules of refinement and improvement are lists of.
#pragma once

#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <string_view>

#include "geomesh/core/run_context.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// CPU seconds of all threads, and of this one: where they are the same, the others had nothing to do.
struct CpuSeconds {
  double all, own;
  static CpuSeconds now() {
    timespec own{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &own);
    return {static_cast<double>(std::clock()) / CLOCKS_PER_SEC,
            static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec)};
  }
  std::string since(const CpuSeconds& start) const {
    char text[64];
    std::snprintf(text, sizeof text, "%.2f CPU s, %.2f on the first thread", all - start.all, own - start.own);
    return text;
  }
};

/// Whether a pass needs another round.
enum class Next : bool { again, done };

struct Pass {
  std::string_view name;  ///< what is done, for notes
  std::function<Next(unsigned round)> round;
  unsigned most_rounds = 1;
  bool applies = true;
};

/// Runs passes of one schedule, one after the other. Each round is noted (debug) with its CPU seconds and, in builds
/// with GEOMESH_EXPENSIVE_CHECKS, followed by the validator of the mesh.
class PassRunner {
 public:
  /// No round begins once `out_of_time` says so.
  PassRunner(const DomainMesh& mesh, const RunContext& context, std::function<bool()> out_of_time)
      : mesh_(mesh), context_(context), out_of_time_(std::move(out_of_time)) {}

  /// Rounds from 0 on until one is the last, `most_rounds` were run, or time is up. None where the pass does not apply.
  void run(const Pass& pass) const {
    for (unsigned k = 0; pass.applies && k < pass.most_rounds && !out_of_time_(); ++k) {
      if (pass.most_rounds > 1) context_.report(k, pass.most_rounds);
      const CpuSeconds start = CpuSeconds::now();
      const Next next = pass.round(k);
      const std::string seconds = CpuSeconds::now().since(start);
      GEOMESH_EXPENSIVE_CHECK(mesh_.validate().empty());
      const std::string which = pass.most_rounds > 1 ? ", round " + std::to_string(k + 1) : "";
      context_.note(LogLevel::debug,
                    std::string(pass.name) + which + ": " + std::to_string(mesh_.n_cells()) + " cells, " + seconds);
      if (next == Next::done) return;
    }
  }

  /// A pass of one round.
  void once(std::string_view name, const std::function<void()>& work, bool applies = true) const {
    const auto round = [&](unsigned) {
      work();
      return Next::done;
    };
    run({.name = name, .round = round, .applies = applies});
  }

 private:
  const DomainMesh& mesh_;
  const RunContext& context_;
  std::function<bool()> out_of_time_;
};

}  // namespace geomesh::remesh

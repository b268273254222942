// SPDX-License-Identifier: MIT
/// @file
/// Runs named passes over the whole mesh. The schedules of refinement and improvement are lists of such passes.
#pragma once

#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <string_view>

#include "geomesh/core/run_context.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// CPU seconds of all threads, and of the current one. If they are equal, the other threads were idle.
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
  std::string_view name;  ///< what the pass does, for the log
  std::function<Next(unsigned round)> round;
  unsigned most_rounds = 1;
  bool applies = true;
};

/// Runs the passes of a schedule one after the other. Each round is logged (debug) with its CPU seconds. In builds with
/// GEOMESH_EXPENSIVE_CHECKS, the mesh is validated after each round.
class PassRunner {
 public:
  /// No further round begins once `out_of_time` returns true.
  PassRunner(const DomainMesh& mesh, const RunContext& context, std::function<bool()> out_of_time)
      : mesh_(mesh), context_(context), out_of_time_(std::move(out_of_time)) {}

  /// Runs the rounds of a pass, numbered from 0, until one returns `done`, `most_rounds` have run or the time is up.
  /// Runs no round if the pass does not apply.
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

// SPDX-License-Identifier: MIT
/// @file
/// Communication of a stage with its caller: log sink, progress callback, stage observer, cancel token. The core itself
/// prints nothing.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "geomesh/core/error.hpp"

namespace geomesh {

enum class LogLevel { debug, info, warning };

/// The context of a run, passed by reference through every stage. All members are optional; an empty context runs
/// silently on all cores. The callbacks are called from the thread that called the stage, never concurrently.
struct RunContext {
  std::function<void(LogLevel, std::string_view)> log;
  /// Called with the done and the total work of the running stage, in items of that stage. The total is 0 if unknown.
  std::function<void(std::size_t done, std::size_t total)> progress;
  /// Called when a stage begins (true) or ends (false). Names: read build intersect delaunay recover classify refine
  /// improve verify write.
  std::function<void(std::string_view stage, bool begins)> stage;
  const std::atomic<bool>* cancel = nullptr;
  unsigned threads = 0;  ///< 0: all cores

  void note(LogLevel level, std::string_view text) const {
    if (log) log(level, text);
  }
  void report(std::size_t done, std::size_t total) const {
    if (progress) progress(done, total);
  }
  /// Throws Error{interrupted} once the cancel token is set. Must be called at least a few times a second.
  void check_cancelled() const {
    if (cancel && cancel->load(std::memory_order_relaxed)) throw Error(ErrorKind::interrupted, "interrupted");
  }
};

/// Reports the begin and the end of a stage to the observer, also in case of an exception.
class StageScope {
 public:
  StageScope(const RunContext& context, std::string_view name) : context_(context), name_(name) {
    if (context_.stage) context_.stage(name_, true);
  }
  ~StageScope() {
    if (context_.stage) context_.stage(name_, false);
  }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

 private:
  const RunContext& context_;
  std::string name_;
};

}  // namespace geomesh

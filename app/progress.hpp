// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Draws what a job says while it runs: one line a stage, with counts, time and time left. On a terminal the running
/// stage's line is redrawn in place; elsewhere only finished lines are printed.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "geomesh/core/run_context.hpp"

namespace geomesh::app {

enum class Verbosity { quiet, normal, verbose };

/// Prints to standard error. Keep it alive as long as the context made by `attach` is used.
class Progress {
 public:
  Progress(Verbosity verbosity, bool terminal) : verbosity_(verbosity), terminal_(terminal) {}
  void attach(RunContext& context);

 private:
  using Clock = std::chrono::steady_clock;
  void on_stage(std::string_view name, bool begins);
  void on_progress(std::size_t done, std::size_t total);
  void on_log(LogLevel level, std::string_view text);
  void clear_line() const;

  Verbosity verbosity_;
  bool terminal_;
  std::string stage_, note_;
  Clock::time_point start_, last_drawn_;
};

/// "0.42 s", "75 s", "12 min".
std::string seconds_words(double seconds);

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Displays the progress of a job: one line per stage, with its share, time and remaining time. The stages delaunay,
/// recover and classify share one line, `mesh`, unless everything is printed. On a terminal the line of the running
/// stage is redrawn in place, every second even if the stage reports nothing; elsewhere only finished lines are
/// printed. For programs, one JSON object per line is printed (docs/command-line.md).
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "colours.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::app {

enum class Verbosity { quiet, normal, verbose };
enum class ProgressStyle {
  lines,     ///< one line is printed for each finished stage
  terminal,  ///< lines of finished stages are printed, and that of the running stage is redrawn in place
  json,      ///< JSON objects whose `event` is stage, progress or log
};

/// Prints progress and messages to standard error. Must exist as long as the context made by `attach` is used.
class Progress {
 public:
  Progress(Verbosity verbosity, ProgressStyle style, Colours colours)
      : verbosity_(verbosity), style_(style), colours_(colours) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void attach(RunContext& context);
  /// Prints the collected warnings with their number, grouped by causes: the first warning of each of the first ten
  /// causes. It is called after the result has been printed, so that warnings come last; if an error has ended the run,
  /// they are printed when the object is destroyed. With --verbose, and for programs, warnings are printed immediately.
  void tell_warnings();

 private:
  using Clock = std::chrono::steady_clock;
  void on_stage(std::string_view name, bool begins);
  void begin_stage(std::string_view name);
  void finish_line();
  void on_progress(std::size_t done, std::size_t total);
  void on_log(LogLevel level, std::string_view text);
  void tick();
  void draw();
  void print_stage_event(bool begins) const;
  void print_progress_event() const;
  void clear_line() const;
  double seconds_spent() const;
  double seconds_left() const;
  void keep_warning(std::string_view warning);
  void stop_ticker();

  Verbosity verbosity_;
  ProgressStyle style_;
  Colours colours_;
  std::mutex mutex_;  ///< locked by a thread that uses the members below or standard error
  std::condition_variable ends_;
  bool ended_ = false;
  std::string stage_, note_;   ///< name of the running stage, and the text about what it has counted
  std::string remark_;         ///< last remark of the stage about a surface, printed if the stage makes only one
  std::size_t n_remarks_ = 0;  ///< number of remarks about surfaces in the running stage
  bool is_held_ = false;  ///< whether the stage has ended, and the next stage may be shown in the same line of output
  int percent_ = -1;      ///< shown percentage of the stage, which never decreases
  std::size_t done_ = 0, total_ = 0;
  std::size_t first_done_ = 0;  ///< finished items at the time `counted_since_`; the rate is computed from there on
  struct Kind {
    std::string cause, first;  ///< warning
    std::size_t count = 0;
  };
  std::vector<Kind> warnings_;  ///< warnings not printed yet, grouped by cause
  Clock::time_point start_, last_drawn_, counted_since_;
  std::thread ticker_;
};

/// Formats a time: "0.42 s", "75 s", "12 min".
std::string seconds_words(double seconds);

/// "1,234,567".
std::string count_words(std::size_t n);

}  // namespace geomesh::app

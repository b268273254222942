// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Draws what a job says while it runs: one line a stage, with its share, time and time left. The stages delaunay,
/// recover and classify are one line, `mesh`, unless all is printed. On a terminal the running stage's line is redrawn
/// in place, every second even where the stage says nothing; elsewhere only finished lines are printed. For programs:
/// one JSON object a line (docs/command-line.md).
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
  lines,     ///< finished stages alone
  terminal,  ///< the running one too, in place
  json,      ///< objects with `event`: stage, progress, log
};

/// Prints to standard error. Keep it alive as long as the context made by `attach` is used.
class Progress {
 public:
  Progress(Verbosity verbosity, ProgressStyle style, Colours colours)
      : verbosity_(verbosity), style_(style), colours_(colours) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void attach(RunContext& context);
  /// Prints the warnings that came, with their count, by their causes: the first of each of the first ten. Called once
  /// the result has been printed, so that they stand last; at the end of an object's life they are printed too, where
  /// an error has ended the run. With --verbose, and for programs, warnings are printed as they come.
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
  std::mutex mutex_;  ///< of all below, and of the standard error
  std::condition_variable ends_;
  bool ended_ = false;
  std::string stage_, note_;   ///< the note: what the stage has counted
  std::string remark_;         ///< the last one about a surface: shown where it is the only one
  std::size_t n_remarks_ = 0;  ///< of the stage so far
  bool is_held_ = false;       ///< the stage has ended, its line waits for others that belong to it
  int percent_ = -1;           ///< shown of the stage so far: never less
  std::size_t done_ = 0, total_ = 0;
  std::size_t first_done_ = 0;  ///< of this total, at `counted_since_`: rate and time left are told from there
  struct Kind {
    std::string cause, first;  ///< warning
    std::size_t count = 0;
  };
  std::vector<Kind> warnings_;  ///< not printed yet, in the order of the first of each cause
  Clock::time_point start_, last_drawn_, counted_since_;
  std::thread ticker_;
};

/// "0.42 s", "75 s", "12 min".
std::string seconds_words(double seconds);

/// "1,234,567".
std::string count_words(std::size_t n);

}  // namespace geomesh::app

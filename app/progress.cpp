// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <cstdio>

namespace geomesh::app {

std::string seconds_words(double seconds) {
  char text[32];
  if (seconds < 10) {
    std::snprintf(text, sizeof text, "%.2f s", seconds);
  } else if (seconds < 180) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  }
  return text;
}

void Progress::attach(RunContext& context) {
  context.stage = [this](std::string_view name, bool begins) { on_stage(name, begins); };
  context.progress = [this](std::size_t done, std::size_t total) { on_progress(done, total); };
  context.log = [this](LogLevel level, std::string_view text) { on_log(level, text); };
}

void Progress::clear_line() const {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::on_stage(std::string_view name, bool begins) {
  if (verbosity_ == Verbosity::quiet) return;
  if (begins) {
    stage_ = name;
    note_.clear();
    start_ = last_drawn_ = Clock::now();
    if (terminal_) std::fprintf(stderr, "%-10s ...", stage_.c_str());
    return;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  clear_line();
  std::fprintf(stderr, "%-10s %8s   %s\n", stage_.c_str(), seconds_words(seconds).c_str(), note_.c_str());
  stage_.clear();
}

void Progress::on_progress(std::size_t done, std::size_t total) {
  if (verbosity_ == Verbosity::quiet || !terminal_) return;
  const auto now = Clock::now();
  if (now - last_drawn_ < std::chrono::milliseconds(200)) return;
  last_drawn_ = now;
  clear_line();
  std::fprintf(stderr, "%-10s %zu", stage_.c_str(), done);
  if (total > 0 && done > 0 && done <= total) {
    const double spent = std::chrono::duration<double>(now - start_).count();
    const double left = spent * static_cast<double>(total - done) / static_cast<double>(done);
    std::fprintf(stderr, " of %zu, about %s left", total, seconds_words(left).c_str());
  }
}

void Progress::on_log(LogLevel level, std::string_view text) {
  if (level == LogLevel::info) note_ = text;
  const bool show = level == LogLevel::warning || verbosity_ == Verbosity::verbose;
  if (!show) return;
  clear_line();
  const char* label = level == LogLevel::warning ? "warning: " : "  ";
  std::fprintf(stderr, "%s%.*s\n", label, static_cast<int>(text.size()), text.data());
}

}  // namespace geomesh::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <algorithm>
#include <cstdio>

#include "geomesh/geomodel/announcement.hpp"
#include "geomesh/geomodel/warnings.hpp"

namespace geomesh::app {
namespace {

constexpr double seconds_until_rate = 1;  ///< time after which rates and remaining times are displayed
constexpr auto redraw_interval = std::chrono::milliseconds(200);
constexpr auto tick_interval = std::chrono::seconds(1);

std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      quoted += code;
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// Returns the name of the step to which a stage belongs in the view of users; empty if the stage is a step of its own.
std::string_view step_of(std::string_view stage) {
  return stage == "delaunay" || stage == "recover" || stage == "classify" ? "mesh" : "";
}

const char* word(LogLevel level) {
  return level == LogLevel::debug ? "debug" : level == LogLevel::info ? "info" : "warning";
}

}  // namespace

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

std::string count_words(std::size_t n) {
  const std::string digits = std::to_string(n);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ',';
    grouped += digits[i];
  }
  return grouped;
}

Progress::~Progress() {
  stop_ticker();
  finish_line();
  tell_warnings();  // prints warnings if an error has ended the run
}

void Progress::stop_ticker() {
  if (!ticker_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ends_.notify_all();
  ticker_.join();
}

void Progress::attach(RunContext& context) {
  context.stage = [this](std::string_view name, bool begins) { on_stage(name, begins); };
  context.progress = [this](std::size_t done, std::size_t total) { on_progress(done, total); };
  context.log = [this](LogLevel level, std::string_view text) { on_log(level, text); };
  if (verbosity_ == Verbosity::quiet || style_ == ProgressStyle::lines) return;
  try {
    ticker_ = std::thread([this] { tick(); });
  } catch (const std::system_error&) {
    // No thread available, as in a browser: only the stages themselves report their progress.
  }
}

/// Redraws the line of the running stage every second, so that a stage that reports nothing for a while is seen to run.
void Progress::tick() {
  std::unique_lock lock(mutex_);
  while (!ends_.wait_for(lock, tick_interval, [&] { return ended_; }))
    if (!stage_.empty() && !is_held_ && Clock::now() - last_drawn_ >= tick_interval) draw();
}

void Progress::clear_line() const {
  if (style_ == ProgressStyle::terminal) std::fputs("\r\033[K", stderr);
}

double Progress::seconds_spent() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

/// Returns the estimated time until the end of the stage; negative if it is not known.
double Progress::seconds_left() const {
  const double spent = std::chrono::duration<double>(Clock::now() - counted_since_).count();
  if (total_ == 0 || done_ > total_ || done_ <= first_done_ || spent < seconds_until_rate) return -1;
  return spent * static_cast<double>(total_ - done_) / static_cast<double>(done_ - first_done_);
}

void Progress::on_stage(std::string_view name, bool begins) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::quiet) return;
  if (begins) begin_stage(name);
  if (style_ == ProgressStyle::json) {
    print_stage_event(begins);
    if (!begins) stage_.clear();
    return;
  }
  if (begins) return;
  is_held_ = true;
  if (verbosity_ == Verbosity::verbose || step_of(name).empty()) finish_line();
}

/// Begins a line of progress, unless the stage belongs to the same step as the one before, whose line it continues.
void Progress::begin_stage(std::string_view name) {
  const bool goes_on = is_held_ && !step_of(name).empty() && style_ != ProgressStyle::json;
  if (!goes_on) finish_line();
  is_held_ = false;
  const bool is_in_step = verbosity_ != Verbosity::verbose && style_ != ProgressStyle::json && !step_of(name).empty();
  stage_ = is_in_step ? step_of(name) : name;
  done_ = total_ = first_done_ = 0;
  percent_ = -1;
  counted_since_ = Clock::now();
  if (goes_on) return;
  note_.clear();
  remark_.clear();
  n_remarks_ = 0;
  start_ = last_drawn_ = counted_since_;
  if (style_ == ProgressStyle::terminal) std::fprintf(stderr, "%-10s ...", stage_.c_str());
}

void Progress::finish_line() {
  if (!is_held_) return;
  is_held_ = false;
  clear_line();
  const std::string remarks = count_words(n_remarks_) + " notes about surfaces (--verbose prints them)";
  std::fprintf(stderr, "%-10s %8s   %s\n", stage_.c_str(), seconds_words(seconds_spent()).c_str(),
               n_remarks_ > 1 && note_.empty() ? remarks.c_str()
               : note_.empty()                 ? remark_.c_str()
                                               : note_.c_str());
  stage_.clear();
}

void Progress::on_progress(std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  if (total != total_ || done < first_done_) {
    first_done_ = done;
    counted_since_ = Clock::now();
  }
  done_ = done;
  total_ = total;
  if (verbosity_ == Verbosity::quiet || style_ == ProgressStyle::lines || stage_.empty()) return;
  if (Clock::now() - last_drawn_ >= redraw_interval) draw();
}

/// Draws the line of the running stage, with its percentage unless it has few rounds, which do not measure time.
void Progress::draw() {
  constexpr std::size_t few = 20;
  last_drawn_ = Clock::now();
  if (style_ == ProgressStyle::json) return print_progress_event();
  clear_line();
  std::string line;
  if (total_ > few && done_ <= total_) {
    percent_ = std::max(percent_, static_cast<int>(100.0 * static_cast<double>(done_) / static_cast<double>(total_)));
    line = std::to_string(percent_) + " %";
    if (const double left = seconds_left(); left >= 0 && percent_ < 100)
      line += ", about " + seconds_words(left) + " left";
  }
  std::fprintf(stderr, "%-10s %8s   %s", stage_.c_str(), seconds_words(seconds_spent()).c_str(), line.c_str());
  std::fflush(stderr);
}

void Progress::print_stage_event(bool begins) const {
  std::fprintf(stderr, "{\"event\": \"stage\", \"stage\": %s, \"begins\": %s, \"seconds\": %.3f}\n",
               json_string(stage_).c_str(), begins ? "true" : "false", begins ? 0.0 : seconds_spent());
}

void Progress::print_progress_event() const {
  const double spent = seconds_spent(), left = seconds_left();
  std::fprintf(stderr, "{\"event\": \"progress\", \"stage\": %s, \"done\": %zu, \"total\": %zu, \"seconds\": %.3f",
               json_string(stage_).c_str(), done_, total_, spent);
  if (left >= 0) std::fprintf(stderr, ", \"seconds_left\": %.1f", left);
  std::fputs("}\n", stderr);
}

void Progress::on_log(LogLevel level, std::string_view text) {
  const std::lock_guard lock(mutex_);
  const bool is_for_all = text.starts_with(geomodel::announcement_start) && verbosity_ != Verbosity::quiet;
  if (level == LogLevel::info && !is_for_all) {
    const bool is_count = !text.empty() && text.front() >= '0' && text.front() <= '9';
    (is_count ? note_ : remark_) = text;
    if (!is_count) ++n_remarks_;
  }
  const bool chatty = verbosity_ == Verbosity::verbose || (style_ == ProgressStyle::json && level == LogLevel::info);
  if (level != LogLevel::warning && !is_for_all && (!chatty || verbosity_ == Verbosity::quiet)) return;
  if (style_ == ProgressStyle::json) {
    std::fprintf(stderr, "{\"event\": \"log\", \"level\": \"%s\", \"text\": %s}\n", word(level),
                 json_string(text).c_str());
    return;
  }
  if (level == LogLevel::warning && verbosity_ != Verbosity::verbose) return keep_warning(text);
  finish_line();
  clear_line();
  const std::string label = level == LogLevel::warning ? colours_.warning("warning:") + " " : is_for_all ? "" : "  ";
  std::fprintf(stderr, "%s%.*s\n", label.c_str(), static_cast<int>(text.size()), text.data());
}

void Progress::keep_warning(std::string_view warning) {
  const std::string cause = geomodel::warning_cause(warning);
  const auto known = std::find_if(warnings_.begin(), warnings_.end(), [&](const Kind& k) { return k.cause == cause; });
  if (known == warnings_.end()) {
    warnings_.push_back({cause, std::string(warning), 1});
  } else {
    ++known->count;
  }
}

void Progress::tell_warnings() {
  constexpr std::size_t most_kinds = 10;
  const std::lock_guard lock(mutex_);
  std::size_t n = 0, n_shown = 0, n_other = 0;
  for (const Kind& kind : warnings_) n += kind.count;
  if (n == 0) return;
  clear_line();
  std::fprintf(stderr, "%s warning%s:\n", count_words(n).c_str(), n > 1 ? "s" : "");
  for (const Kind& kind : warnings_) {
    if (n_shown == most_kinds) {
      n_other += kind.count;
      continue;
    }
    ++n_shown;
    std::fprintf(stderr, "%s %s\n", colours_.warning("warning:").c_str(), kind.first.c_str());
    if (kind.count > 1)
      std::fprintf(stderr, "  and %s more like \"%s\"\n", count_words(kind.count - 1).c_str(),
                   geomodel::warning_statement(kind.first).c_str());
  }
  if (n_other > 0) std::fprintf(stderr, "%s more warnings of other kinds\n", count_words(n_other).c_str());
  if (n > n_shown) std::fputs("The report lists all warnings; --verbose prints them.\n", stderr);
  warnings_.clear();
}

}  // namespace geomesh::app

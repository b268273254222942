// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <algorithm>
#include <cstdio>

#include "geomesh/geomodel/warnings.hpp"

namespace geomesh::app {
namespace {

constexpr double seconds_until_rate = 1;  ///< rates and times left are told from then on
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
  tell_warnings();  // where an error has ended the run
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
  if (verbosity_ != Verbosity::quiet && style_ != ProgressStyle::lines) ticker_ = std::thread([this] { tick(); });
}

/// Stages that say nothing for a while are seen to run.
void Progress::tick() {
  std::unique_lock lock(mutex_);
  while (!ends_.wait_for(lock, tick_interval, [&] { return ended_; }))
    if (!stage_.empty() && Clock::now() - last_drawn_ >= tick_interval) draw();
}

void Progress::clear_line() const {
  if (style_ == ProgressStyle::terminal) std::fputs("\r\033[K", stderr);
}

double Progress::seconds_spent() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

/// Since counts of this total began. Zero where it is not known.
double Progress::items_a_second() const {
  const double spent = std::chrono::duration<double>(Clock::now() - counted_since_).count();
  if (done_ <= first_done_ || spent < seconds_until_rate) return 0;
  return static_cast<double>(done_ - first_done_) / spent;
}

/// Negative where it is not known.
double Progress::seconds_left() const {
  const double rate = items_a_second();
  return total_ == 0 || done_ > total_ || rate == 0 ? -1 : static_cast<double>(total_ - done_) / rate;
}

void Progress::on_stage(std::string_view name, bool begins) {
  const std::lock_guard lock(mutex_);
  if (verbosity_ == Verbosity::quiet) return;
  if (begins) {
    stage_ = name;
    note_.clear();
    done_ = total_ = first_done_ = 0;
    start_ = last_drawn_ = counted_since_ = Clock::now();
  }
  if (style_ == ProgressStyle::json) {
    print_stage_event(begins);
  } else if (begins) {
    if (style_ == ProgressStyle::terminal) std::fprintf(stderr, "%-10s ...", stage_.c_str());
  } else {
    clear_line();
    std::fprintf(stderr, "%-10s %8s   %s\n", stage_.c_str(), seconds_words(seconds_spent()).c_str(), note_.c_str());
  }
  if (!begins) stage_.clear();
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

void Progress::draw() {
  last_drawn_ = Clock::now();
  if (style_ == ProgressStyle::json) return print_progress_event();
  clear_line();
  const double spent = seconds_spent(), left = seconds_left();
  std::string line = count_words(done_);
  if (total_ > 0 && done_ <= total_) line += " of " + count_words(total_);
  if (const double rate = items_a_second(); rate > 0)
    line += ", " + count_words(static_cast<std::size_t>(rate)) + " a second";
  if (left >= 0) line += ", about " + seconds_words(left) + " left";
  std::fprintf(stderr, "%-10s %8s   %s", stage_.c_str(), seconds_words(spent).c_str(), done_ > 0 ? line.c_str() : "");
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
  if (level == LogLevel::info) note_ = text;
  const bool chatty = verbosity_ == Verbosity::verbose || (style_ == ProgressStyle::json && level == LogLevel::info);
  if (level != LogLevel::warning && (!chatty || verbosity_ == Verbosity::quiet)) return;
  if (style_ == ProgressStyle::json) {
    std::fprintf(stderr, "{\"event\": \"log\", \"level\": \"%s\", \"text\": %s}\n", word(level),
                 json_string(text).c_str());
    return;
  }
  if (level == LogLevel::warning && verbosity_ != Verbosity::verbose) return keep_warning(text);
  clear_line();
  const char* label = level == LogLevel::warning ? "warning: " : "  ";
  std::fprintf(stderr, "%s%.*s\n", label, static_cast<int>(text.size()), text.data());
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
    std::fprintf(stderr, "warning: %s\n", kind.first.c_str());
    if (kind.count > 1)
      std::fprintf(stderr, "  and %s more like \"%s\"\n", count_words(kind.count - 1).c_str(),
                   geomodel::warning_statement(kind.first).c_str());
  }
  if (n_other > 0) std::fprintf(stderr, "%s more warnings of other kinds\n", count_words(n_other).c_str());
  if (n > n_shown) std::fputs("The report lists all warnings; --verbose prints them.\n", stderr);
  warnings_.clear();
}

}  // namespace geomesh::app

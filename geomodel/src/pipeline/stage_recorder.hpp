// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures the stages of a job for the report while passing everything on to the caller's context.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

/// Thrown at the beginning of the stage that follows the one to stop after. Internal to the pipeline; never leaves it.
struct StopRequested {};

/// Keep it alive as long as `context()` is in use.
class StageRecorder {
 public:
  /// `stop_after`: empty to run to the end.
  StageRecorder(const RunContext& outer, std::string stop_after);
  StageRecorder(const StageRecorder&) = delete;
  StageRecorder& operator=(const StageRecorder&) = delete;

  const RunContext& context() const { return inner_; }
  /// One record a stage name, in the order of their first beginning; a stage that ran twice adds up.
  const std::vector<StageRecord>& records() const { return records_; }
  const std::string& stop_after() const { return stop_after_; }

 private:
  void on_stage(std::string_view name, bool begins);

  RunContext inner_;
  std::string stop_after_;
  bool stop_ = false;
  std::vector<StageRecord> records_;
  std::chrono::steady_clock::time_point wall_start_;
  double cpu_start_ = 0;
};

/// User plus system seconds of all threads of this process so far.
double process_cpu_seconds();
/// Peak resident size of this process so far, in bytes.
std::size_t process_peak_bytes();

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures the stages of a job for the report while passing everything to the caller's context.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

/// Thrown at the beginning of the stage after the one to stop after. Internal to the pipeline; it never leaves it.
struct StopRequested {};

/// Must be kept alive as long as `context()` is in use.
class StageRecorder {
 public:
  /// `stop_after` is empty to run to the end.
  StageRecorder(const RunContext& outer, std::string stop_after);
  StageRecorder(const StageRecorder&) = delete;
  StageRecorder& operator=(const StageRecorder&) = delete;

  const RunContext& context() const { return inner_; }
  /// Returns one record per stage name, in the order of their first start; a stage that ran twice is summed.
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

/// Returns user plus system seconds of all threads of this process so far.
double process_cpu_seconds();
/// Returns the peak resident size of this process so far, in bytes.
std::size_t process_peak_bytes();

}  // namespace geomesh::geomodel

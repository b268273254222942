// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures time and memory of the stages of a job for the report, and passes messages on to the caller's context.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

/// Exception that ends a run when the stage begins that follows the last requested one. The pipeline catches it.
struct StopRequested {};

/// Measures the stages of a job. It must be kept alive as long as `context()` is in use.
class StageRecorder {
 public:
  /// `stop_after` names the last stage to run; empty to run to the end.
  StageRecorder(const RunContext& outer, std::string stop_after);
  StageRecorder(const StageRecorder&) = delete;
  StageRecorder& operator=(const StageRecorder&) = delete;

  const RunContext& context() const { return inner_; }
  /// Returns one record for each stage name, in the order of first starts; the times of a repeated stage are summed.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stage_recorder.hpp"

#include <algorithm>

#include "common/operating_system.hpp"

namespace geomesh::geomodel {

double process_cpu_seconds() { return use_of_this_process().cpu_seconds; }

std::size_t process_peak_bytes() { return use_of_this_process().peak_bytes; }

StageRecorder::StageRecorder(const RunContext& outer, std::string stop_after)
    : inner_(outer), stop_after_(std::move(stop_after)) {
  inner_.stage = [this, outer_stage = outer.stage](std::string_view name, bool begins) {
    on_stage(name, begins);
    if (outer_stage) outer_stage(name, begins);
  };
}

void StageRecorder::on_stage(std::string_view name, bool begins) {
  const auto now = std::chrono::steady_clock::now();
  if (begins) {
    if (stop_) throw StopRequested{};
    wall_start_ = now;
    cpu_start_ = process_cpu_seconds();
    return;
  }
  auto record = std::find_if(records_.begin(), records_.end(), [&](const StageRecord& r) { return r.name == name; });
  if (record == records_.end())
    record = records_.insert(records_.end(), StageRecord{.name = std::string(name), .runs = 0});
  ++record->runs;
  record->wall_s += std::chrono::duration<double>(now - wall_start_).count();
  record->cpu_s += process_cpu_seconds() - cpu_start_;
  record->peak_bytes = process_peak_bytes();
  stop_ = stop_ || name == stop_after_;
}

}  // namespace geomesh::geomodel

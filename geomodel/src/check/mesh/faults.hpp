// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects the locations where a mesh fails a check. They are reported as one failure with a count and examples.
#pragma once

#include <string>
#include <utility>

#include "geomesh/geomodel/check.hpp"

namespace geomesh::geomodel::checking {

/// Collects the places at which a mesh fails one check: call add() for each of them, then report(). `id` is the fixed
/// name of this kind of failure.
class FaultCollector {
 public:
  explicit FaultCollector(std::string id) { fault_.id = std::move(id); }

  void add(std::size_t example, const Vec3& place) {
    constexpr std::size_t max_examples = 10;
    if (fault_.count == 0) fault_.place = place;
    ++fault_.count;
    if (fault_.examples.size() < max_examples) fault_.examples.push_back(example);
  }
  std::size_t count() const { return fault_.count; }

  /// If the mesh failed the check anywhere, appends the failure to the result as "<count> <what>".
  void report(CheckResult& result, const std::string& what) {
    if (fault_.count == 0) return;
    fault_.what = std::to_string(fault_.count) + " " + what;
    result.faults.push_back(std::move(fault_));
  }

 private:
  CheckFault fault_;
};

}  // namespace geomesh::geomodel::checking

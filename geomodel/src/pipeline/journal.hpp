// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects the notes and warnings of a run.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/core/run_context.hpp"

namespace geomesh::geomodel {

/// Collects notes and warnings for the report, in the order in which stages give them, and logs them immediately.
class Journal {
 public:
  explicit Journal(const RunContext& context) : context_(context) {}

  const RunContext& context() const { return context_; }

  /// Adds a note: a finding in the surfaces before meshing, or a change made by rules.
  void note(std::string text) {
    context_.note(LogLevel::info, text);
    notes_.push_back(std::move(text));
  }
  void warn(std::string text) {
    context_.note(LogLevel::warning, text);
    warnings_.push_back(std::move(text));
  }
  void warn_all(std::vector<std::string> texts) {
    for (std::string& text : texts) warn(std::move(text));
  }
  /// Adds warnings to the report that were already passed to the log.
  void keep_warnings(const std::vector<std::string>& texts) {
    warnings_.insert(warnings_.end(), texts.begin(), texts.end());
  }

  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  const RunContext& context_;
  std::vector<std::string> notes_, warnings_;
};

}  // namespace geomesh::geomodel

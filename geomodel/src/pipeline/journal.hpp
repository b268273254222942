// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The notes and warnings of a run.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/core/run_context.hpp"

namespace geomesh::geomodel {

/// Notes and warnings are kept for the report, in the order in which stages tell them, and passed on to the log at
/// once.
class Journal {
 public:
  /// The context outlives the journal.
  explicit Journal(const RunContext& context) : context_(context) {}

  /// The caller's context: log, progress, cancellation, threads.
  const RunContext& context() const { return context_; }

  /// Findings before meshing, and changes by rules.
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
  /// Warnings that the log has already.
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

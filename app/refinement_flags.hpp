// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Command-line options for sizes and shapes (docs/meshing.md).
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/geomodel/refinement.hpp"

namespace geomesh::app {

class RefinementFlags {
 public:
  void add_to(CLI::App& app);
  /// Returns the settings for refinement. Any option except those for cell arrays and limits turns refinement on.
  geomodel::RefinementSettings settings() const;

 private:
  std::optional<double> size_, gradation_, curvature_, tolerance_, time_budget_;
  std::optional<std::size_t> max_elements_;
  bool inside_only_ = false;
  std::string quality_, quality_measure_, size_from_;
  std::vector<std::string> cell_arrays_;
};

}  // namespace geomesh::app

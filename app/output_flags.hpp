// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Options for the content of a mesh file, like `output:` of a project.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::app {

class OutputFlags {
 public:
  void add_to(CLI::App& app);
  geomodel::WriteOptions options() const;
  bool tells_order() const { return order_ != 0; }
  /// Returns the requested format, or else the format of the output's extension.
  std::string format_of(const std::filesystem::path& output) const;

 private:
  std::string format_, groups_ = "whole", region_array_ = "region", compression_ = "fast";
  std::vector<std::string> split_, zones_, fields_, point_fields_;
  bool no_inner_faces_ = false, no_curves_ = false, single_grid_ = false, node_arrays_ = false, cohesive_ = false,
       starter_ = false, fractures_only_ = false;
  int order_ = 0;  // 0: not said
  unsigned partitions_ = 1;
};

}  // namespace geomesh::app

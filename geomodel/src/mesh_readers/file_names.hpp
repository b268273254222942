// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the JSON beside a mesh file that geomesh wrote: full names and kinds for the names in the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A region, surface, curve, point or other node set, with the names of the file's sets of which it is the union.
struct FullName {
  std::string name, kind;
  std::vector<std::string> sets;
  std::map<std::string, double> attributes{};  ///< of regions
};

struct FileNames {
  std::vector<FullName> regions, surfaces, curves, points, node_sets;
  std::map<std::string, std::string> field_units;  ///< unit of each mapped property, by its name; empty: not known
  std::map<std::string, std::vector<std::int32_t>> region_groups;
  std::map<std::int32_t, std::string> region_ids;
  std::string unit;
  std::optional<Vec3> origin;
  bool empty() const { return regions.empty() && surfaces.empty(); }
};

/// Reads the JSON file beside a mesh file. Returns empty names if there is none or if geomesh did not write it.
FileNames read_file_names(const std::filesystem::path& mesh_file);

}  // namespace geomesh::geomodel

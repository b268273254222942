// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The JSON beside a mesh file of ours: full names and kinds for the names in the file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// A region, surface, curve, point or other node set with the sets of the file whose union it is.
struct FullName {
  std::string name, kind;
  std::vector<std::string> sets;
};

struct FileNames {
  std::vector<FullName> regions, surfaces, curves, points, node_sets;
  bool empty() const { return regions.empty() && surfaces.empty(); }
};

/// Empty where there is no such file or it is not one of ours.
FileNames read_file_names(const std::filesystem::path& mesh_file);

}  // namespace geomesh::geomodel

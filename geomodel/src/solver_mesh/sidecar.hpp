// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The JSON file beside a solver file: what each name in the file represents, and which groups make up a whole surface
/// or curve.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// One group of a solver file: a physical group, element set, node set or surface.
struct SidecarGroup {
  std::string type;  ///< term of the solver for the group: "physical", "elset", "nset", "surface"
  int dimension;
  std::int32_t id;   ///< number of the group in the file; 0 if the format has none
  std::string name;  ///< name of the group as in the file
  std::string full_name;
  std::vector<std::int32_t>
      members;  ///< Ids of the regions, surfaces, curves or points of the mesh of which the group is a part.
};

/// Writes MESH_FILE.json. It lists the groups of the mesh file, and the regions, surfaces, curves and points of the
/// mesh, each with its full name and the names of the groups whose union it is. It also has `region_groups` by region
/// ids if there are any, attributes of regions, names and units of properties, the unit and origin of the mesh, and the
/// further numbers in `counts`. Returns the path of the file. If it cannot be written, MESH_FILE, which exists already,
/// is removed.
std::filesystem::path write_sidecar(const ModelMesh& mesh, const std::vector<SidecarGroup>& groups,
                                    const std::filesystem::path& mesh_file,
                                    const std::map<std::string, std::size_t>& counts = {});

}  // namespace geomesh::geomodel

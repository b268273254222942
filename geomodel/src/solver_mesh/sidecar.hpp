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

/// One group (physical group, element set, node set, surface) of a solver file.
struct SidecarGroup {
  std::string type;  ///< the solver's term: "physical", "elset", "nset", "surface"
  int dimension;
  std::int32_t id;   ///< number in the file; 0 if the format has none
  std::string name;  ///< name as in the file
  std::string full_name;
  std::vector<std::int32_t>
      members;  ///< ids of the regions, surfaces, curves or points of the mesh to which the group belongs
};

/// Writes MESH_FILE.json: `groups`, and `regions`, `surfaces`, `curves`, `points` of the mesh each with its full name
/// and `groups`, the names in the file whose union it is; `region_groups` by region ids if there are any; attributes of
/// regions, names and units of fields, the mesh's unit and origin. Returns its name; if it cannot be written, removes
/// MESH_FILE, which exists already. `counts` are further numbers by name.
std::filesystem::path write_sidecar(const ModelMesh& mesh, const std::vector<SidecarGroup>& groups,
                                    const std::filesystem::path& mesh_file,
                                    const std::map<std::string, std::size_t>& counts = {});

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a starter input says of a mesh: its regions with their materials, and the two outer surfaces with conditions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A number of a material in SI units, and where it is from.
struct MaterialValue {
  double value;
  bool is_given;  ///< an attribute of the project, or computed of some; else a usual value of rock
};

struct StarterMaterial {
  MaterialValue conductivity;  ///< W/(m K)
  MaterialValue density;       ///< kg/m3
  MaterialValue vp, vs;        ///< m/s
};

/// A group in the file: its name, and its number where the format has numbers.
struct StarterGroup {
  std::string name, full_name;
  std::int32_t id = 0;
};

struct StarterRegion {
  StarterGroup group;
  StarterMaterial material;
};

struct StarterModel {
  std::vector<StarterRegion> regions;
  std::string lowest, highest;  ///< full names of the outer surfaces with the least and greatest mean height
  /// Groups of the file that make up a surface, of one type ("nset", "tag", "mesh", "node set").
  std::vector<StarterGroup> groups_of(const std::string& full_name, const std::string& type) const;

  struct Listed {
    std::string type;
    int dimension;
    StarterGroup group;
    std::vector<std::string> wholes;  ///< full names of the surfaces that it is a part of
  };
  std::vector<Listed> groups;  ///< of the JSON beside the mesh
};

/// Attributes are found by name: conductivity or thermal_conductivity; density; vp; vs; young with poisson. `type`: of
/// groups of solids in the file. Throws Error{usage} where no surface bounds the mesh.
StarterModel starter_model(const ModelMesh& mesh, const std::filesystem::path& mesh_file, const std::string& type);

/// "from the project" or "not given in the project: a usual value of rock".
const char* origin_of(const MaterialValue& value);

/// Conditions on the highest and the lowest surface, in degrees.
inline constexpr double temperature_above = 10, temperature_below = 100;

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects the data of a solver's starter input: the regions of a mesh with their materials, and the two outer
/// surfaces with boundary conditions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A material parameter in SI units, and whether the project gives it.
struct MaterialValue {
  double value;
  /// Whether the project gives the value, or attributes from which it is computed; if not, it is typical of rock.
  bool is_given;
};

struct StarterMaterial {
  MaterialValue conductivity;  ///< W/(m K)
  MaterialValue density;       ///< kg/m3
  MaterialValue vp, vs;        ///< m/s
};

/// A group of elements in the mesh file: its name, and its number if the format has numbers.
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
  /// Returns the groups of one type ("nset", "tag", "mesh", "node set") in the file that make up a surface.
  std::vector<StarterGroup> groups_of(const std::string& full_name, const std::string& type) const;

  struct Listed {
    std::string type;
    int dimension;
    StarterGroup group;
    std::vector<std::string> wholes;  ///< full names of the surfaces that this group of elements is a part of
  };
  std::vector<Listed> groups;  ///< all groups of elements in the JSON file beside the mesh
};

/// Collects the starter data of a mesh. Material parameters are attributes found by name: conductivity or
/// thermal_conductivity; density; vp; vs; young with poisson. `type` is that of groups of solids in the file. Throws
/// Error{usage} if no surface bounds the mesh.
StarterModel starter_model(const ModelMesh& mesh, const std::filesystem::path& mesh_file, const std::string& type);

/// Describes the source of a material value: "from the project" or "not given in the project: a usual value of rock".
const char* origin_of(const MaterialValue& value);

/// Boundary temperatures on the highest and the lowest outer surface, in degrees Celsius.
inline constexpr double temperature_above = 10, temperature_below = 100;

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh check`: exact verification of any tool's mesh. Shares only file reading and the exact number type with what it judges:
/// no code of the engine, the arrangement, the naming or the writers is used here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct CheckRequest {
  std::filesystem::path mesh;                    ///< .vtu (any tool's), .msh, .inp as far as readers go
  std::filesystem::path project;                 ///< empty: none
  std::vector<std::filesystem::path> surfaces;   ///< each triangle must be covered by mesh faces
  bool delaunay = false;
};

struct CheckFault {
  std::string what;  ///< one sentence with counts
  std::size_t count = 0;
  std::vector<std::size_t> examples;  ///< cells, faces or points, at most ten
  Vec3 place;
};

struct CheckResult {
  std::size_t n_points = 0, n_tetrahedra = 0;
  double volume = 0;
  struct RegionVolume {
    std::int32_t id;
    std::string name;
    std::size_t n_tetrahedra;
    double volume;
  };
  std::vector<RegionVolume> regions;
  std::vector<std::string> checks_done;  ///< what was checked, in words
  std::vector<CheckFault> faults;        ///< empty: the mesh passes
};

CheckResult check_mesh(const CheckRequest& request);

}  // namespace geomesh::geomodel

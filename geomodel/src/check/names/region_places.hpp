// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The location of each region of the mesh: its extreme points, its centroid, and points well inside it.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

struct RegionPlace {
  Vec3 least, greatest;  ///< Least and greatest vertex of the region, ordered by x, then y, then z.
  Vec3 centroid;         ///< of its volume
  double volume = 0;
  std::vector<Vec3> samples{};  ///< centroids of the region's largest tetrahedra, the largest first
};

/// Returns the location of each region by id, with at most `n_samples` sampled points in each.
std::map<std::int32_t, RegionPlace> region_places(const CheckedMesh& mesh, std::size_t n_samples);

/// Returns the regions whose closed tetrahedra contain p, decided exactly.
std::vector<std::int32_t> regions_at(const CheckedMesh& mesh, const Vec3& p);

bool comes_before(const Vec3& a, const Vec3& b);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_verdict/velocities.hpp"

#include <algorithm>

#include "geomesh/geomodel/solver_verdict.hpp"

namespace geomesh::geomodel {

std::vector<double> velocity_by_region(const ModelMesh& mesh) {
  std::vector<double> velocity(mesh.regions.size(), 0);
  for (const RegionAttribute& a : mesh.attributes)
    if (a.name == velocity_attribute)
      for (std::size_t r = 0; r < std::min(velocity.size(), a.by_region.size()); ++r)
        if (a.by_region[r] > 0) velocity[r] = a.by_region[r];
  return velocity;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mean_edge.hpp"

#include <cmath>

namespace geomesh::geomodel {

double mean_edge(const ModelMesh& mesh) {
  double sum = 0;
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = i + 1; j < 4; ++j) {
        const Vec3 edge = mesh.points[t[i]] - mesh.points[t[j]];
        sum += std::hypot(edge.x, edge.y, edge.z);
      }
  return mesh.tetrahedra.empty() ? 0 : sum / (6 * static_cast<double>(mesh.tetrahedra.size()));
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A quality report for tests of what is made of one.
#pragma once

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel::testing {

/// Statistics of the mesh by region, and its two worst elements with made-up causes.
inline QualityReport quality_of(const ModelMesh& mesh) {
  QualityReport q;
  q.measured.whole = measure_shapes(mesh.points, mesh.tetrahedra);
  for (const Region& r : mesh.regions) {
    std::vector<Tetrahedron> inside;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
      if (mesh.tet_region[t] == r.id) inside.push_back(mesh.tetrahedra[t]);
    q.measured.per_component.push_back(measure_shapes(mesh.points, inside));
  }
  WorstElement forced;
  forced.tetrahedron = 1;
  forced.cause = ShapeCause::thin_gap;
  q.measured.worst = {WorstElement{}, forced};
  q.measured.worst[0].tetrahedron = 0;
  q.causes = {"nothing in the input forces it", "gap of 0.5 between horizon upper and horizon lower"};
  q.has_sizes = true;
  return q;
}

}  // namespace geomesh::geomodel::testing

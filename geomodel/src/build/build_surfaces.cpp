// SPDX-License-Identifier: GPL-3.0-or-later
#include "build/extend.hpp"
#include "geomesh/core/error.hpp"
#include "sets/sheets.hpp"

namespace geomesh::geomodel {

BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  const BuildLog log{built.notes, built.warnings};
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    TriangulatedSurface& surface = built.surfaces[s];
    const SurfaceRules rule = rules.of(s);
    if (rule.extend != Extend::none && !rules.box)
      throw Error(ErrorKind::usage, "surface " + surface.name + ": extend needs a box to extend to; give the project a box");
    built.n_given_triangles.push_back(static_cast<Index>(surface.triangles.size()));
    if (rule.fill_holes > 0) fill_holes(surface, rule.fill_holes, log);
    if (surface.kind == SurfaceKind::body) {
      if (rule.close_at_box && rules.box && !is_closed(surface)) close_body(surface, *rules.box, log);
    } else if (rule.extend != Extend::none) {
      extend_to_box(surface, rule.extend, *rules.box, log);
    }
  }
  return built;
}

}  // namespace geomesh::geomodel

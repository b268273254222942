// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "build/extend.hpp"
#include "build/thin_layers.hpp"
#include "build/throw_blocks.hpp"
#include "geomesh/core/error.hpp"
#include "sets/sheets.hpp"

namespace geomesh::geomodel {
namespace {

/// The blocks of a horizon with throw, each continued on its own.
std::vector<Index> build_blocks(TriangulatedSurface& surface, const SurfaceRules& rule, const std::vector<TriangulatedSurface>& surfaces,
                                const Box3& box, const BuildLog& log) {
  std::vector<const TriangulatedSurface*> faults;
  for (const std::string& name : rule.throw_at) {
    const auto fault = std::find_if(surfaces.begin(), surfaces.end(), [&](const TriangulatedSurface& s) { return s.name == name; });
    if (fault == surfaces.end()) throw Error(ErrorKind::usage, "horizon " + surface.name + ": throw_at names " + name + ", which is no surface");
    faults.push_back(&*fault);
  }
  std::vector<Index> block = sort_into_blocks(surface, faults);
  if (*std::max_element(block.begin(), block.end()) == 0)
    log.warnings.push_back("horizon " + surface.name + ": all of it lies on one side of the faults across which it is to have throw");
  extend_blocks(surface, block, rule.extend == Extend::none ? Extend::flat : rule.extend, box, log);
  return block;
}

}  // namespace

BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  built.rows.block_of_triangle.resize(surfaces.size());
  const BuildLog log{built.notes, built.warnings};
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    TriangulatedSurface& surface = built.surfaces[s];
    const SurfaceRules rule = rules.of(s);
    if ((rule.extend != Extend::none || !rule.throw_at.empty()) && !rules.box)
      throw Error(ErrorKind::usage, "surface " + surface.name + ": extend needs a box to extend to; give the project a box");
    built.rows.n_given_triangles.push_back(static_cast<Index>(surface.triangles.size()));
    if (rule.fill_holes > 0) fill_holes(surface, rule.fill_holes, log);
    if (surface.kind == SurfaceKind::body) {
      if (rule.close_at_box && rules.box && !is_closed(surface)) close_body(surface, *rules.box, log);
    } else if (!rule.throw_at.empty() && !surface.triangles.empty()) {
      built.rows.block_of_triangle[s] = build_blocks(surface, rule, surfaces, *rules.box, log);
    } else if (rule.extend != Extend::none) {
      extend_to_box(surface, rule.extend, *rules.box, log);
    }
  }
  if (rules.min_thickness > 0) apply_min_thickness(built, rules);
  return built;
}

}  // namespace geomesh::geomodel

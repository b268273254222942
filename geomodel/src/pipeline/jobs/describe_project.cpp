// SPDX-License-Identifier: GPL-3.0-or-later
// What a project file holds, declared in geomesh/geomodel/info.hpp.
#include "geomesh/geomodel/info.hpp"
#include "pipeline/jobs/prepare.hpp"

namespace geomesh::geomodel {

FileInfo describe_project(const std::filesystem::path& path) {
  const Project project = read_project(path);
  PreparedModel model;
  prepare_project(project, model, {});
  FileInfo info;
  info.file = path.filename().string();
  info.format = "geomesh project, surfaces intersected";
  for (const TriangulatedSurface& surface : model.surfaces)
    if (surface.kind != SurfaceKind::box) info.surfaces.push_back(measure_surface(surface));
  info.n_named_points = model.points.size();
  info.n_facets = model.arrangement.soup.facets.size();
  info.notes = std::move(model.notes);
  info.warnings = std::move(model.warnings);
  return info;
}

}  // namespace geomesh::geomodel

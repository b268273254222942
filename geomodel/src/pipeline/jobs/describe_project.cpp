// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the contents of a project file, declared in geomesh/geomodel/info.hpp.
#include "geomesh/geomodel/info.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {

FileInfo describe_project(const std::filesystem::path& path) {
  const Project project = read_project(path);
  const RunContext context;
  Journal journal(context);
  const Inputs inputs = read_project_model(project, journal);
  const Built built = build_model(inputs, journal);
  const Arranged arranged = intersect(inputs, built, journal);
  FileInfo info;
  info.file = path.filename().string();
  info.format = "geomesh project, surfaces intersected";
  for (const TriangulatedSurface& surface : arranged.surfaces)
    if (surface.kind != SurfaceKind::box) info.surfaces.push_back(measure_surface(surface));
  info.n_named_points = inputs.points.size();
  info.n_facets = arranged.arrangement.soup.facets.size();
  info.notes = journal.notes();
  info.warnings = journal.warnings();
  return info;
}

}  // namespace geomesh::geomodel

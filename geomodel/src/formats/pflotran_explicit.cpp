// SPDX-License-Identifier: GPL-3.0-or-later
// Writes an explicit unstructured grid for PFLOTRAN, the Voronoi dual of the mesh: NAME.uge (cells with volumes,
// connections with areas), NAME_REGION.txt (cells of a region, for REGION / FILE) and NAME_SURFACE.ex (connections to a
// boundary). Cells are numbered from 1. Source: PFLOTRAN's user guide, GRID card, TYPE unstructured_explicit, and its
// explicit unstructured grid format.
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "voronoi/control_volumes.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

void write_grid(OutputText& out, const ModelMesh& mesh, const ControlVolumes& grid) {
  out << "CELLS " << mesh.points.size() << "\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    out << v + 1 << " " << mesh.points[v] << " " << grid.volume[v] << "\n";
  out << "CONNECTIONS " << grid.connections.size() << "\n";
  for (const auto& c : grid.connections)
    out << c.a + std::size_t{1} << " " << c.b + std::size_t{1} << " " << 0.5 * (mesh.points[c.a] + mesh.points[c.b])
        << " " << c.area << "\n";
}

std::vector<std::filesystem::path> write_pflotran_explicit(const ModelMesh& mesh, const WriteOptions&,
                                                           const std::filesystem::path& stem) {
  const ControlVolumes grid = control_volumes(mesh);
  const std::filesystem::path file = stem.string() + ".uge";
  WrittenFiles written;
  write_output_text(file, [&](OutputText& out) { write_grid(out, mesh, grid); });
  written.add(file);
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  const auto add = [&](int dimension, std::int32_t id, const std::string& name, const char* ending, auto&& compose) {
    const std::filesystem::path part = stem.string() + "_" + names.give(name) + ending;
    write_output_text(part, compose);
    written.add(part);
    sidecar.push_back({"file", dimension, 0, part.filename().string(), name, {id}});
  };
  for (const Region& region : mesh.regions)
    add(3, region.id, region.name, ".txt", [&](OutputText& out) {
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        if (grid.region[v] == region.id) out << v + 1 << "\n";
    });
  for (const NamedSurface& surface : mesh.surfaces) {
    const std::vector<BoundaryShare> shares = boundary_shares(mesh, surface.id);
    if (shares.empty()) continue;
    add(2, surface.id, surface.name, ".ex", [&](OutputText& out) {
      out << "CONNECTIONS " << shares.size() << "\n";
      for (const BoundaryShare& s : shares)
        out << s.point + std::size_t{1} << " " << mesh.points[s.point] << " " << s.area << "\n";
    });
  }
  written.add(write_sidecar(mesh, sidecar, file, {{"negative_areas", grid.n_negative_areas}}));
  return written.keep();
}

}  // namespace

Format pflotran_explicit_format() {
  return {"pflotran-explicit", {".uge"}, "PFLOTRAN explicit grid (Voronoi)", {}, write_pflotran_explicit, nullptr};
}

}  // namespace geomesh::geomodel

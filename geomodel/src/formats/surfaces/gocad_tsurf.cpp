// SPDX-License-Identifier: GPL-3.0-or-later
// Writes GOCAD TSurf (.ts, text), for SKUA, Petrel and Leapfrog: one object with its name for each surface. A face that
// lies on two surfaces is in both objects. Faces between the same two regions form a part (TFACE). Source: "GOCAD ASCII
// File Format" (GOCAD 2.5).
#include "formats/format_list.hpp"
#include "formats/surfaces/face_nodes.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/gocad_header.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

const char* feature_of(SurfaceKind kind) {
  if (kind == SurfaceKind::horizon) return "top";
  if (kind == SurfaceKind::fault) return "fault";
  if (kind == SurfaceKind::body) return "intrusive";
  if (kind == SurfaceKind::box) return "boundary";
  return "";
}

std::string feature_lines(const ModelMesh& model, const CellGroup& group, const std::string& name) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.id == group.members.front() && *feature_of(surface.kind) != '\0')
      return "GEOLOGICAL_FEATURE " + name + "\nGEOLOGICAL_TYPE " + feature_of(surface.kind) + "\n";
  return "";
}

void write_surface(OutputText& out, const SolverMesh& mesh, const CellGroup& group, const std::string& name) {
  const FaceNodes nodes = face_nodes(mesh, group.blocks);
  out << gocad_header("TSurf", name, mesh.source->unit) << feature_lines(*mesh.source, group, name);
  std::vector<bool> is_written(nodes.rows.size(), false);
  for (const std::size_t b : group.blocks) {
    out << "TFACE\n";
    for (const VertexIndex v : mesh.blocks[b].nodes) {
      const std::uint32_t number = nodes.number_of[v];
      if (is_written[number]) continue;
      is_written[number] = true;
      out << "VRTX " << number + std::size_t{1} << " " << mesh.node(v) << "\n";
    }
    for (std::size_t i = 0; i < mesh.blocks[b].nodes.size(); ++i)
      out << (i % 3 == 0 ? "TRGL " : " ") << nodes.number_of[mesh.blocks[b].nodes[i]] + std::size_t{1}
          << (i % 3 == 2 ? "\n" : "");
  }
  out << "END\n";
}

std::vector<std::filesystem::path> write_gocad_tsurf(const ModelMesh& model, const WriteOptions& options,
                                                     const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, options);
  const std::filesystem::path file = stem.string() + ".ts";
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) {
    for (const CellGroup& group : mesh.groups) {
      if (group.dimension != 2) continue;
      const std::string name = names.give(group.full_name);
      write_surface(out, mesh, group, name);
      sidecar.push_back({"tsurf", 2, 0, name, group.full_name, group.members});
    }
  });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format gocad_tsurf_format() {
  return {"tsurf",           {".ts"}, "GOCAD TSurf of the surfaces", {.overlapping = true, .triangles_alone = true},
          write_gocad_tsurf, nullptr};
}

}  // namespace geomesh::geomodel

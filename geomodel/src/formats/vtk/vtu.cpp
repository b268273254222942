// SPDX-License-Identifier: GPL-3.0-or-later
// Writes NAME.vtu: tetrahedra of named regions; also faces, curves and points if a single grid is requested; a mesh in
// parts is written to NAME.pvtu. If only fractures are written, they are the cells of the single grid.
#include "formats/format_list.hpp"
#include "formats/given_part.hpp"
#include "formats/vtk/pvtu.hpp"
#include "formats/vtk/vtp.hpp"
#include "formats/vtk/vtu_grid.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns the names and ids of regions, surfaces and curves as in the cell arrays `region`, `surface` and `curve`.
std::vector<SidecarGroup> groups_of(const ModelMesh& mesh) {
  std::vector<SidecarGroup> groups;
  const auto add = [&](int dimension, std::int32_t id, const std::string& name) {
    groups.push_back({"cells", dimension, id, name, name, {id}});
  };
  for (const Region& region : mesh.regions) add(3, region.id, region.name);
  for (const CohesiveLayer& layer : mesh.cohesive_layers) add(3, layer.id, layer.name);
  for (const NamedSurface& surface : mesh.surfaces) add(2, surface.id, surface.name);
  for (const NamedCurve& curve : mesh.curves) add(1, curve.id, curve.name);
  for (const auto& point : mesh.marked_points) add(0, point.id, point.name);
  return groups;
}

void write_beside(const ModelMesh& mesh, const WriteOptions& options, const std::filesystem::path& stem,
                  const std::filesystem::path& file, WrittenFiles& written) {
  if (!options.single_grid) {
    const std::filesystem::path faces = stem.string() + ".faces.vtp", curves = stem.string() + ".curves.vtp";
    write_faces_vtp(mesh, options.compression, faces);
    written.add(faces);
    if (options.curves) {
      write_curves_vtp(mesh, options.compression, curves);
      written.add(curves);
    }
  }
  written.add(write_sidecar(mesh, groups_of(mesh), file));
}

std::vector<std::filesystem::path> write_vtu(const ModelMesh& mesh, const WriteOptions& given,
                                             const std::filesystem::path& stem) {
  WriteOptions options = given;
  options.single_grid |= options.fractures_only;
  WrittenFiles written;
  const bool in_parts = options.partitions > 1;
  const std::filesystem::path file = stem.string() + (in_parts ? ".pvtu" : ".vtu");
  if (in_parts) {
    written.add(write_pvtu(mesh, options, stem));
  } else {
    const VtuLayout layout(mesh, options);
    write_vtk_document(vtu_document(mesh, options, layout), options.compression, file);
    written.add(file);
  }
  write_beside(mesh, options, stem, file, written);
  return written.keep();
}

}  // namespace

std::vector<std::filesystem::path> write_vtu_part(const ModelMesh& mesh, const MeshParts& parts, std::int32_t number,
                                                  const WriteOptions& options, const std::filesystem::path& stem) {
  WrittenFiles written;
  written.add(write_pvtu(mesh, parts, options, stem));
  if (number == 0) write_beside(mesh, options, stem, stem.string() + ".pvtu", written);
  return written.keep();
}

Format vtu_format() {
  return {"vtu",
          {".vtu", ".pvtu"},
          "VTK (ParaView, PyVista, meshio, GEOS)",
          {.second_order = true,
           .prisms = true,
           .curves = true,
           .overlapping = true,
           .partitions = true,
           .triangles_alone = true},
          write_vtu,
          read_vtu_mesh};
}

}  // namespace geomesh::geomodel

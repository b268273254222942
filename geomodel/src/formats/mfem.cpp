// SPDX-License-Identifier: GPL-3.0-or-later
// Writes an MFEM mesh v1.0: attributes of elements are region ids, attributes of boundary elements are surface ids
// (inner faces are boundary elements too); names are in a JSON file beside the mesh. If only fractures are written, the
// elements are triangles in space, and edges on curves are the boundary. Source: "Mesh Formats" of MFEM 4.7.
#include <algorithm>

#include "formats/format_list.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

/// Writes the MFEM elements of one dimension, as `ATTRIBUTE TYPE NODES`, under a title.
void write_cells(OutputText& out, const SolverMesh& mesh, const char* title, int dimension) {
  out << "\n" << title << "\n" << mesh.count(dimension) << "\n";
  for (const CellGroup& label : mesh.labels) {
    if (label.dimension != dimension) continue;
    for (const std::size_t b : label.blocks) {
      const CellBlock& block = mesh.blocks[b];
      const int type = block.shape == CellShape::edge       ? 1
                       : block.shape == CellShape::triangle ? 2
                       : block.shape == CellShape::prism    ? 6
                                                            : 4;
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        out << label.id << " " << type;
        for (std::size_t i = 0; i < block.nodes_per_cell; ++i) out << " " << block.nodes[c * block.nodes_per_cell + i];
        out << "\n";
      }
    }
  }
}

std::vector<std::filesystem::path> write_mfem(const ModelMesh& model, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  WriteOptions one_tag = options;
  if (one_tag.groups == GroupChoice::both) one_tag.groups = GroupChoice::whole;  // an MFEM face has only one attribute
  const SolverMesh mesh = make_solver_mesh(model, one_tag);
  const int dimension = mesh.count(3) > 0 ? 3 : 2;
  const std::filesystem::path file = stem.string() + ".mesh";
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& label : mesh.labels)
    if (label.dimension >= dimension - 1)
      sidecar.push_back({"attribute", label.dimension, label.id, label.full_name, label.full_name, label.members});
  write_output_text(file, [&](OutputText& out) {
    out << "MFEM mesh v1.0\n\ndimension\n" << dimension << "\n";
    write_cells(out, mesh, "elements", dimension);
    write_cells(out, mesh, "boundary", dimension - 1);
    out << "\nvertices\n" << mesh.n_nodes() << "\n3\n";
    for (std::size_t v = 0; v < mesh.n_nodes(); ++v) out << mesh.node(v) << "\n";
  });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format mfem_format() {
  return {"mfem", {".mesh"}, "MFEM mesh v1.0", {.names = false, .triangles_alone = true}, write_mfem, read_mfem_mesh};
}

}  // namespace geomesh::geomodel

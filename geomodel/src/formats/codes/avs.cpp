// SPDX-License-Identifier: GPL-3.0-or-later
// Writes AVS UCD (text), which LaGriT reads and writes: NAME.avs has the tetrahedra with the region as material,
// NAME.faces.avs the faces with the surface as material and, as node attribute idnode0, the number of the node in
// NAME.avs. If only fractures are written, NAME.avs holds their triangles, as files of dfnWorks do. Source: "read/avs"
// of the LaGriT manual, and the reader of meshio. LaGriT uses the extension .inp for such files, which is also that of
// Abaqus.
#include <map>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

void write_counts(OutputText& out, std::size_t n_nodes, std::size_t n_cells, int node_attributes) {
  out << n_nodes << " " << n_cells << " " << node_attributes << " 0 0\n";
}

/// AVS orients tetrahedra differently from VTK: their last two nodes are exchanged.
void write_tetrahedra(OutputText& out, const SolverMesh& mesh) {
  write_counts(out, mesh.n_nodes(), mesh.count(3), 0);
  for (std::size_t v = 0; v < mesh.n_nodes(); ++v) out << v + 1 << " " << mesh.node(v) << "\n";
  std::size_t number = 0;
  for_each_cell(mesh, 3, [&](const CellGroup& label, const CellBlock&, std::size_t, auto nodes) {
    out << ++number << " " << label.id << " tet";
    for (const std::size_t i : {0, 1, 3, 2}) out << " " << nodes[i] + std::size_t{1};
    out << "\n";
  });
}

/// Writes faces as an AVS file. With `beside_volume`, each node has as attribute its number in the tetrahedra's file.
void write_faces(OutputText& out, const SolverMesh& mesh, bool beside_volume) {
  std::map<VertexIndex, std::size_t> number_of;  // AVS number of each node of the faces, in the order of the mesh
  for_each_cell(mesh, 2, [&](const CellGroup&, const CellBlock&, std::size_t, auto nodes) {
    for (const VertexIndex v : nodes) number_of[v] = 0;
  });
  std::size_t n = 0;
  for (auto& [v, number] : number_of) number = ++n;
  write_counts(out, n, mesh.count(2), beside_volume ? 1 : 0);
  for (const auto& [v, number] : number_of) out << number << " " << mesh.node(v) << "\n";
  std::size_t face = 0;
  for_each_cell(mesh, 2, [&](const CellGroup& label, const CellBlock&, std::size_t, auto nodes) {
    out << ++face << " " << label.id << " tri";
    for (const VertexIndex v : nodes) out << " " << number_of[v];
    out << "\n";
  });
  if (!beside_volume) return;
  out << "1 1\nidnode0, integer\n";
  for (const auto& [v, number] : number_of) out << number << " " << v + std::size_t{1} << "\n";
}

std::vector<std::filesystem::path> write_avs(const ModelMesh& model, const WriteOptions& options,
                                             const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  const std::filesystem::path file = stem.string() + ".avs", faces = stem.string() + ".faces.avs";
  WrittenFiles written;
  const bool is_volume = mesh.count(3) > 0;
  write_output_text(file,
                    [&](OutputText& out) { is_volume ? write_tetrahedra(out, mesh) : write_faces(out, mesh, false); });
  written.add(file);
  if (is_volume && mesh.count(2) > 0) {
    write_output_text(faces, [&](OutputText& out) { write_faces(out, mesh, true); });
    written.add(faces);
  }
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& label : mesh.labels)
    if (label.dimension > 1)
      sidecar.push_back({"material", label.dimension, label.id, label.full_name, label.full_name, label.members});
  written.add(write_sidecar(model, sidecar, file));
  return written.keep();
}

}  // namespace

Format avs_format() {
  return {"avs", {".avs"}, "AVS UCD (LaGriT)", {.names = false, .triangles_alone = true}, write_avs, nullptr};
}

}  // namespace geomesh::geomodel

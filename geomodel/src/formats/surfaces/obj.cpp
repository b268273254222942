// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the surfaces as Wavefront OBJ: one object for each surface, with colours in NAME.mtl. Source: "Object Files
// (.obj)", Wavefront Advanced Visualizer, appendix B.
#include "formats/format_list.hpp"
#include "formats/surfaces/face_nodes.hpp"
#include "geomesh/geomodel/palette.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

struct NamedFaces {
  const CellGroup* label;
  std::string name;
};

std::vector<NamedFaces> named_faces(const SolverMesh& mesh) {
  SolverNames names(name_limit_plain);
  std::vector<NamedFaces> named;
  for (const CellGroup& label : mesh.labels)
    if (label.dimension == 2) named.push_back({&label, names.give(label.full_name)});
  return named;
}

void write_objects(OutputText& out, const SolverMesh& mesh, const std::vector<NamedFaces>& named,
                   const std::string& colours_file) {
  const FaceNodes nodes = face_nodes(mesh);
  out << "# written by geomesh\nmtllib " << colours_file << "\n";
  for (const VertexIndex v : nodes.rows) out << "v " << mesh.node(v) << "\n";
  for (const NamedFaces& faces : named) {
    out << "o " << faces.name << "\ng " << faces.name << "\nusemtl " << faces.name << "\n";
    for (const std::size_t b : faces.label->blocks)
      for (std::size_t i = 0; i < mesh.blocks[b].nodes.size(); ++i)
        out << (i % 3 == 0 ? "f " : " ") << nodes.number_of[mesh.blocks[b].nodes[i]] + std::size_t{1}
            << (i % 3 == 2 ? "\n" : "");
  }
}

void write_colours(OutputText& out, const std::vector<NamedFaces>& named) {
  Palette surfaces(Palette::Of::surfaces);
  for (const NamedFaces& faces : named) {
    const Colour c = surfaces.colour_of(faces.name);
    out << "newmtl " << faces.name << "\nKd " << c[0] << " " << c[1] << " " << c[2] << "\n";
  }
}

std::vector<std::filesystem::path> write_obj(const ModelMesh& model, const WriteOptions& options,
                                             const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  const std::vector<NamedFaces> named = named_faces(mesh);
  const std::filesystem::path file = stem.string() + ".obj", colours_file = stem.string() + ".mtl";
  WrittenFiles written;
  write_output_text(file, [&](OutputText& out) { write_objects(out, mesh, named, colours_file.filename().string()); });
  written.add(file);
  write_output_text(colours_file, [&](OutputText& out) { write_colours(out, named); });
  written.add(colours_file);
  std::vector<SidecarGroup> sidecar;
  for (const NamedFaces& faces : named)
    sidecar.push_back({"object", 2, 0, faces.name, faces.label->full_name, faces.label->members});
  written.add(write_sidecar(model, sidecar, file));
  return written.keep();
}

}  // namespace

Format obj_format() {
  return {"obj", {".obj"}, "Wavefront OBJ of the surfaces", {.triangles_alone = true}, write_obj, nullptr};
}

}  // namespace geomesh::geomodel

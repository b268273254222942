// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the surfaces as STL (text): one solid with its name for each surface. Text is used because the binary form has
// neither names nor doubles. Source: "StereoLithography Interface Specification", 3D Systems, 1989.
#include <cmath>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const double length = std::sqrt(dot(normal, normal));
  return length > 0 ? (1 / length) * normal : Vec3{0, 0, 0};
}

void write_solid(OutputText& out, const SolverMesh& mesh, const CellGroup& label, const std::string& name) {
  out << "solid " << name << "\n";
  for (const std::size_t b : label.blocks) {
    const std::vector<VertexIndex>& nodes = mesh.blocks[b].nodes;
    for (std::size_t i = 0; i < nodes.size(); i += 3) {
      const Vec3 &p = mesh.node(nodes[i]), &q = mesh.node(nodes[i + 1]), &r = mesh.node(nodes[i + 2]);
      out << "facet normal " << unit_normal(p, q, r) << "\nouter loop\n";
      for (const Vec3* corner : {&p, &q, &r}) out << "vertex " << *corner << "\n";
      out << "endloop\nendfacet\n";
    }
  }
  out << "endsolid " << name << "\n";
}

std::vector<std::filesystem::path> write_stl(const ModelMesh& model, const WriteOptions& options,
                                             const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  const std::filesystem::path file = stem.string() + ".stl";
  SolverNames names(name_limit_plain);
  std::vector<SidecarGroup> sidecar;
  write_output_text(file, [&](OutputText& out) {
    for (const CellGroup& label : mesh.labels) {
      if (label.dimension != 2) continue;
      const std::string name = names.give(label.full_name);
      write_solid(out, mesh, label, name);
      sidecar.push_back({"solid", 2, 0, name, label.full_name, label.members});
    }
  });
  return {file, write_sidecar(model, sidecar, file)};
}

}  // namespace

Format stl_format() { return {"stl", {".stl"}, "STL of the surfaces", {.triangles_alone = true}, write_stl, nullptr}; }

}  // namespace geomesh::geomodel

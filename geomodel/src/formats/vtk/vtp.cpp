// SPDX-License-Identifier: GPL-3.0-or-later
// Writes NAME.faces.vtp with the constrained faces, and NAME.curves.vtp with curves and named points.
#include "formats/vtk/vtp.hpp"

#include "writers/vtk_names.hpp"
#include "writers/vtk_xml.hpp"

namespace geomesh::geomodel {

namespace {

/// The points used by a set of cells, in the order of the mesh. The array `mesh_point` has their rows in the mesh.
class PointSubset {
 public:
  explicit PointSubset(const ModelMesh& mesh) : mesh_(&mesh), row_(mesh.points.size(), no_vertex) {}
  void use(VertexIndex v) { row_[v] = 0; }
  void number() {
    for (VertexIndex v = 0; v < row_.size(); ++v) {
      if (row_[v] == no_vertex) continue;
      row_[v] = static_cast<VertexIndex>(rows_.size());
      rows_.push_back(v);
    }
  }
  std::size_t size() const { return rows_.size(); }
  VertexIndex operator[](VertexIndex v) const { return row_[v]; }
  VtkSection point_data() const {
    return {
        "PointData", "", {vtk_array<std::int32_t>("mesh_point", size(), [this](std::size_t i) { return rows_[i]; })}};
  }
  VtkSection points() const {
    const auto coordinate = [this](std::size_t i) { return mesh_->points[rows_[i / 3]][i % 3]; };
    return {"Points", "", {vtk_array<double>("Points", 3 * size(), coordinate, 3)}};
  }

 private:
  const ModelMesh* mesh_;
  std::vector<VertexIndex> row_, rows_;
};

/// Makes a VTK section of `n` cells with `nodes` nodes each; `node` returns their nodes.
template <class F>
VtkSection cells(const char* tag, std::size_t n, std::size_t nodes, F node) {
  return {
      tag,
      "",
      {vtk_array<std::int32_t>("connectivity", n * nodes, [=](std::size_t i) { return node(i / nodes, i % nodes); }),
       vtk_array<std::int32_t>("offsets", n, [=](std::size_t i) { return (i + 1) * nodes; })}};
}

struct PieceCounts {
  std::size_t points, verts, lines, polys;
};
std::string piece_attributes(const PieceCounts& n) {
  return "NumberOfPoints=\"" + std::to_string(n.points) + "\" NumberOfVerts=\"" + std::to_string(n.verts) +
         "\" NumberOfLines=\"" + std::to_string(n.lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(n.polys) + "\"";
}

}  // namespace

void write_faces_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file) {
  PointSubset points(mesh);
  for (const auto& face : mesh.faces)
    for (const VertexIndex v : face.vertices) points.use(v);
  points.number();
  const std::size_t n = mesh.faces.size();
  VtkSection data{"CellData", "", {}};
  const auto add = [&](const char* name, std::int32_t ModelMesh::Face::*member) {
    data.arrays.push_back(
        vtk_array<std::int32_t>(name, n, [&mesh, member](std::size_t i) { return mesh.faces[i].*member; }));
  };
  add("surface", &ModelMesh::Face::surface);
  add("surface_set", &ModelMesh::Face::surface_set);
  add("patch", &ModelMesh::Face::patch);
  add("region_minus", &ModelMesh::Face::region_minus);
  add("region_plus", &ModelMesh::Face::region_plus);
  add("source_triangle", &ModelMesh::Face::source_triangle);
  VtkDocument document{"PolyData", piece_attributes({points.size(), 0, 0, n}), {}, origin_of(mesh), {}};
  add_surface_fields(mesh, document.fields);
  add_region_fields(mesh, document.fields);
  const auto node = [&](std::size_t f, std::size_t i) { return points[mesh.faces[f].vertices[i]]; };
  document.sections = {points.point_data(), std::move(data), points.points(), cells("Polys", n, 3, node)};
  write_vtk_document(document, compression, file);
}

void write_curves_vtp(const ModelMesh& mesh, Compression compression, const std::filesystem::path& file) {
  PointSubset points(mesh);
  for (const auto& p : mesh.marked_points) points.use(p.v);
  for (const auto& e : mesh.curve_edges) {
    points.use(e.a);
    points.use(e.b);
  }
  points.number();
  const std::size_t n_points = mesh.marked_points.size(), n_edges = mesh.curve_edges.size();
  const auto id = [&](std::size_t i) {
    return i < n_points ? mesh.marked_points[i].id : mesh.curve_edges[i - n_points].curve;
  };
  VtkSection data{"CellData", "", {vtk_array<std::int32_t>("curve", n_points + n_edges, id)}};
  VtkDocument document{"PolyData", piece_attributes({points.size(), n_points, n_edges, 0}), {}, origin_of(mesh), {}};
  add_curve_fields(mesh, document.fields);
  const auto vertex = [&](std::size_t p, std::size_t) { return points[mesh.marked_points[p].v]; };
  const auto end = [&](std::size_t e, std::size_t i) {
    return points[i == 0 ? mesh.curve_edges[e].a : mesh.curve_edges[e].b];
  };
  document.sections = {points.point_data(), std::move(data), points.points(), cells("Verts", n_points, 1, vertex),
                       cells("Lines", n_edges, 2, end)};
  write_vtk_document(document, compression, file);
}

}  // namespace geomesh::geomodel

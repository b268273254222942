// SPDX-License-Identifier: GPL-3.0-or-later
// NAME.vtu: tetrahedra of named regions; with one grid for all also faces, curves and points.
#include <limits>

#include "formats/format_list.hpp"
#include "formats/vtp.hpp"
#include "formats/vtu_cells.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/vtk_names.hpp"
#include "writers/vtk_xml.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Of nodes in the middle of edges in the point array `kind`.
constexpr std::uint8_t kind_of_midpoint = 5;

std::size_t n_nodes(const ModelMesh& mesh) { return mesh.points.size() + mesh.midpoints.points.size(); }

VtkSection points_section(const ModelMesh& mesh) {
  const auto coordinate = [&mesh](std::size_t i) {
    const std::size_t n = mesh.points.size(), v = i / 3;
    return v < n ? mesh.points[v][i % 3] : mesh.midpoints.points[v - n][i % 3];
  };
  return {"Points", "", {vtk_array<double>("Points", 3 * n_nodes(mesh), coordinate, 3)}};
}

/// 32-bit numbers where they suffice: half the bytes to compress.
VtkSection cells_section(const VtuLayout& layout) {
  VtkSection section{"Cells", "", {}};
  const auto node = [&layout](std::size_t i) { return layout.node(i); };
  const auto end = [&layout](std::size_t i) { return layout.end_of(i); };
  const auto type = [&layout](std::size_t i) { return layout.type(i); };
  section.arrays.push_back(vtk_array<std::int32_t>("connectivity", layout.n_entries(), node));
  if (layout.n_entries() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    section.arrays.push_back(vtk_array<std::int32_t>("offsets", layout.n_cells(), end));
  } else {
    section.arrays.push_back(vtk_array<std::int64_t>("offsets", layout.n_cells(), end));
  }
  section.arrays.push_back(vtk_array<std::uint8_t>("types", layout.n_cells(), type));
  return section;
}

/// OpenGeoSys counts materials from 0; elsewhere 0 means none.
std::int32_t first_id(const WriteOptions& options) { return options.region_array == "MaterialIDs" ? 1 : 0; }

/// Numbers that only tetrahedra have: NaN for other cells.
template <class F>
VtkArray tetrahedron_values(std::string name, const VtuLayout& layout, F value) {
  return vtk_array<double>(std::move(name), layout.n_cells(), [&layout, value](std::size_t cell) {
    return layout.visit(cell, [&](VtuCells kind, std::size_t row) {
      return kind == VtuCells::tetrahedra ? value(row) : std::numeric_limits<double>::quiet_NaN();
    });
  });
}

/// Numbers that only faces have: `otherwise` for other cells.
VtkArray face_values(std::string name, const ModelMesh& mesh, const VtuLayout& layout,
                     std::int32_t ModelMesh::Face::*member, std::int32_t otherwise) {
  return vtk_array<std::int32_t>(std::move(name), layout.n_cells(),
                                 [&mesh, &layout, member, otherwise](std::size_t cell) {
                                   return layout.visit(cell, [&](VtuCells kind, std::size_t row) {
                                     return kind == VtuCells::faces ? mesh.faces[row].*member : otherwise;
                                   });
                                 });
}

VtkSection cell_data(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout) {
  VtkSection section{"CellData", "Scalars=\"" + xml_text(options.region_array) + "\"", {}};
  const std::int32_t first = first_id(options);
  section.arrays.push_back(vtk_array<std::int32_t>(
      options.region_array, layout.n_cells(), [&layout, first](std::size_t cell) { return layout.id(cell) - first; }));
  for (const RegionAttribute& attribute : mesh.attributes)
    section.arrays.push_back(tetrahedron_values(attribute.name, layout, [&](std::size_t t) {
      return attribute.by_region[static_cast<std::size_t>(mesh.tet_region[t] - 1)];
    }));
  for (const CellArray& array : mesh.cell_arrays)
    section.arrays.push_back(tetrahedron_values(array.name, layout, [&](std::size_t t) { return array.values[t]; }));
  if (options.single_grid) {
    section.arrays.push_back(face_values("surface_set", mesh, layout, &ModelMesh::Face::surface_set, -1));
    section.arrays.push_back(face_values("patch", mesh, layout, &ModelMesh::Face::patch, 0));
    section.arrays.push_back(face_values("region_minus", mesh, layout, &ModelMesh::Face::region_minus, -1));
    section.arrays.push_back(face_values("region_plus", mesh, layout, &ModelMesh::Face::region_plus, -1));
    section.arrays.push_back(face_values("source_triangle", mesh, layout, &ModelMesh::Face::source_triangle, -1));
  }
  return section;
}

/// Names with the nodes that have them: surfaces, curves, points, other sets.
std::vector<std::pair<std::string, std::vector<bool>>> named_nodes(const ModelMesh& mesh) {
  std::vector<std::pair<std::string, std::vector<bool>>> sets;
  const auto add = [&](const std::string& name) -> std::vector<bool>& {
    return sets.emplace_back("nodes:" + name, std::vector<bool>(n_nodes(mesh), false)).second;
  };
  const Midpoints& mid = mesh.midpoints;
  for (const NamedSurface& surface : mesh.surfaces) {
    std::vector<bool>& nodes = add(surface.name);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (const std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(mesh.faces[f].surface_set)])
        if (id == surface.id) {
          for (const VertexIndex v : mesh.faces[f].vertices) nodes[v] = true;
          if (!mid.empty())
            for (const VertexIndex v : mid.of_face[f]) nodes[v] = true;
        }
  }
  for (const NamedCurve& curve : mesh.curves) {
    std::vector<bool>& nodes = add(curve.name);
    for (std::size_t e = 0; e < mesh.curve_edges.size(); ++e)
      if (mesh.curve_edges[e].curve == curve.id) {
        nodes[mesh.curve_edges[e].a] = nodes[mesh.curve_edges[e].b] = true;
        if (!mid.empty()) nodes[mid.of_curve_edge[e]] = true;
      }
  }
  for (const auto& point : mesh.marked_points) add(point.name)[point.v] = true;
  for (const NodeSet& set : mesh.node_sets) {
    std::vector<bool>& nodes = add(set.name);
    for (const VertexIndex v : set.nodes) nodes[v] = true;
  }
  return sets;
}

VtkSection point_data(const ModelMesh& mesh, const WriteOptions& options) {
  VtkSection section{"PointData", "", {}};
  const std::size_t n = mesh.points.size();
  section.arrays.push_back(vtk_array<std::int32_t>(
      "kind", n_nodes(mesh), [&mesh, n](std::size_t i) { return i < n ? mesh.point_kind[i] : kind_of_midpoint; }));
  section.arrays.push_back(vtk_array<std::int32_t>(
      "input_vertex", n_nodes(mesh), [&mesh, n](std::size_t i) { return i < n ? mesh.input_vertex[i] : -1; }));
  if (options.node_arrays)
    for (auto& [name, nodes] : named_nodes(mesh))
      section.arrays.push_back(
          vtk_array<std::uint8_t>(name, n_nodes(mesh), [nodes = std::move(nodes)](std::size_t i) { return nodes[i]; }));
  return section;
}

void write_grid(const ModelMesh& mesh, const WriteOptions& options, const std::filesystem::path& file) {
  const VtuLayout layout(mesh, options);
  VtkDocument document;
  document.type = "UnstructuredGrid";
  document.piece_attributes = "NumberOfPoints=\"" + std::to_string(n_nodes(mesh)) + "\" NumberOfCells=\"" +
                              std::to_string(layout.n_cells()) + "\"";
  add_region_fields(mesh, document.fields);
  if (options.single_grid) add_surface_fields(mesh, document.fields);
  if (options.single_grid && options.curves) add_curve_fields(mesh, document.fields);
  document.origin = origin_of(mesh);
  document.sections = {point_data(mesh, options), cell_data(mesh, options, layout), points_section(mesh),
                       cells_section(layout)};
  write_vtk_document(document, options.compression, file);
}

/// Names and ids as they stand in the cell arrays `region`, `surface` and `curve`.
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

std::vector<std::filesystem::path> write(const ModelMesh& mesh, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  WrittenFiles written;
  const std::filesystem::path file = stem.string() + ".vtu";
  write_grid(mesh, options, file);
  written.add(file);
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
  return written.keep();
}

}  // namespace

Format vtu_format() {
  return {"vtu",
          {".vtu"},
          "VTK (ParaView, PyVista, meshio, GEOS)",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true},
          write,
          read_vtu_mesh};
}

}  // namespace geomesh::geomodel

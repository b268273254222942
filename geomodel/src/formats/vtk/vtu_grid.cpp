// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/vtk/vtu_grid.hpp"

#include <limits>

#include "writers/vtk_names.hpp"

namespace geomesh::geomodel {

namespace {

/// Value of the point array `kind`, which says how a point arose, at midpoint nodes of second-order elements.
constexpr std::uint8_t kind_of_midpoint = 5;

VtkSection points_section(const ModelMesh& mesh, const VtuLayout& layout) {
  const auto coordinate = [&mesh, &layout](std::size_t i) {
    const std::size_t n = mesh.points.size(), v = layout.node_row(i / 3);
    return v < n ? mesh.points[v][i % 3] : mesh.midpoints.points[v - n][i % 3];
  };
  return {"Points", "", {vtk_array<double>("Points", 3 * layout.n_nodes(), coordinate, 3)}};
}

/// Makes the section `Cells` of a VTU file. Numbers have 32 bits if these suffice, which halves the bytes to compress.
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

/// Returns the number that is subtracted from ids: OpenGeoSys counts materials from 0; in other files 0 means none.
std::int32_t first_id(const WriteOptions& options) { return options.region_array == "MaterialIDs" ? 1 : 0; }

/// Makes a VTU cell array that has values for tetrahedra; other cells have NaN.
template <class F>
VtkArray tetrahedron_values(std::string name, const VtuLayout& layout, F value) {
  return vtk_array<double>(std::move(name), layout.n_cells(), [&layout, value](std::size_t cell) {
    return layout.visit(cell, [&](VtuCells kind, std::size_t row) {
      return kind == VtuCells::tetrahedra ? value(row) : std::numeric_limits<double>::quiet_NaN();
    });
  });
}

/// Makes a VTU cell array that has values for faces; other cells have the value `otherwise`.
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

/// Returns the names of surfaces, curves, points and other sets, each with flags for the nodes that belong to it.
std::vector<std::pair<std::string, std::vector<bool>>> named_nodes(const ModelMesh& mesh) {
  std::vector<std::pair<std::string, std::vector<bool>>> sets;
  const auto add = [&](const std::string& name) -> std::vector<bool>& {
    const std::size_t n = mesh.points.size() + mesh.midpoints.points.size();
    return sets.emplace_back("nodes:" + name, std::vector<bool>(n, false)).second;
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

VtkSection point_data(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout) {
  VtkSection section{"PointData", "", {}};
  const std::size_t n = mesh.points.size();
  section.arrays.push_back(vtk_array<std::int32_t>("kind", layout.n_nodes(), [&mesh, &layout, n](std::size_t i) {
    const std::size_t row = layout.node_row(i);
    return row < n ? mesh.point_kind[row] : kind_of_midpoint;
  }));
  section.arrays.push_back(
      vtk_array<std::int32_t>("input_vertex", layout.n_nodes(), [&mesh, &layout, n](std::size_t i) {
        const std::size_t row = layout.node_row(i);
        return row < n ? mesh.input_vertex[row] : -1;
      }));
  if (!mesh.before_zones.empty())
    section.arrays.push_back(vtk_array<double>(
        "before_zones", 3 * layout.n_nodes(),
        [&mesh, &layout, n](std::size_t i) {
          const std::size_t row = layout.node_row(i / 3);
          return (row < n ? mesh.before_zones[row] : mesh.midpoints.points[row - n])[i % 3];
        },
        3));
  for (const PointArray& array : mesh.point_arrays)
    section.arrays.push_back(vtk_array<double>(
        array.name, layout.n_nodes(), [&layout, &array](std::size_t i) { return array.values[layout.node_row(i)]; }));
  if (options.node_arrays)
    for (auto& [name, nodes] : named_nodes(mesh))
      section.arrays.push_back(vtk_array<std::uint8_t>(
          name, layout.n_nodes(),
          [&layout, nodes = std::move(nodes)](std::size_t i) { return nodes[layout.node_row(i)]; }));
  return section;
}

}  // namespace

VtkDocument vtu_document(const ModelMesh& mesh, const WriteOptions& options, const VtuLayout& layout) {
  VtkDocument document;
  document.type = "UnstructuredGrid";
  document.piece_attributes = "NumberOfPoints=\"" + std::to_string(layout.n_nodes()) + "\" NumberOfCells=\"" +
                              std::to_string(layout.n_cells()) + "\"";
  add_region_fields(mesh, document.fields);
  if (options.single_grid) add_surface_fields(mesh, document.fields);
  if (options.single_grid && options.curves) add_curve_fields(mesh, document.fields);
  document.origin = origin_of(mesh);
  document.sections = {point_data(mesh, options, layout), cell_data(mesh, options, layout),
                       points_section(mesh, layout), cells_section(layout)};
  return document;
}

}  // namespace geomesh::geomodel

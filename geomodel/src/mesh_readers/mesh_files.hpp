// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Meshes and sets of faces as contained in files of any tool. The readers check only indices; everything else is left
/// to the mesh checker.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

struct MeshFile {
  std::string format;
  std::vector<Vec3> points;
  bool single_precision = false;  ///< whether the file has coordinates in single precision
  std::vector<Tetrahedron> tetrahedra;
  /// Six midpoint nodes for each tetrahedron (edges 01 12 20 03 13 23); empty if any tetrahedron has first order.
  std::vector<VertexIndex> midpoints;
  std::vector<std::size_t> cell;   ///< number of each tetrahedron among all cells of the file, for messages
  std::size_t n_other_solids = 0;  ///< hexahedra, prisms ...
  /// Prisms among the file's volume cells, in VTK's order of their nodes (VTK files only).
  std::vector<std::array<VertexIndex, 6>> prisms;
  std::size_t n_lower_cells = 0;     ///< number of triangles, lines and points in the file
  std::vector<std::int32_t> region;  ///< region id of each tetrahedron; empty if the file has no array of region ids
  std::string region_array;          ///< its name
  std::map<std::int32_t, std::string> region_names;
  std::vector<std::string> arrays;  ///< names and types of point arrays and cell arrays (VTK files only)
  std::vector<Triangle> triangles;  ///< triangles of the mesh file besides its tetrahedra (.vtu, and files of solvers)
  std::vector<std::int32_t> triangle_id;  ///< surface id of each triangle; surface_names has the names (VTU files only)
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<std::int32_t> edge_id;
  std::map<std::int32_t, std::string> curve_names;
  /// Row in the input of each mesh point; -1 for added points. Empty if the file has no array of these rows.
  std::vector<std::int32_t> input_vertex;
  std::vector<std::string> missing_arrays;  ///< names of required point arrays that the file lacks (VTK files only)
  std::vector<std::int32_t> kind;           ///< kind of each mesh point (array point_kind); empty if the file has none
  /// Values of cell arrays for each tetrahedron, except for the array "region" (VTK files only).
  std::map<std::string, std::vector<double>> cell_values;
  std::map<std::string, std::vector<double>> point_values;  ///< values of the scalar point arrays (VTK files only)
  std::map<std::string, std::vector<std::int32_t>> region_groups;  ///< region ids of each named group of regions
  std::vector<std::int64_t> global_points;  ///< point array GlobalPointIds; empty if the file has none
  /// Positions of points before fault zones were opened (array before_zones), or empty.
  std::vector<Vec3> before_zones;
  Vec3 origin{0, 0, 0};  ///< vector that was subtracted from the coordinates (field data written by geomesh)
};

struct FacesFile {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> surface, surface_set, patch, region_minus, region_plus, source_triangle;
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::vector<std::int32_t>> surface_sets;
  std::vector<std::string> missing_arrays;  ///< names of arrays that files written by geomesh have and this file lacks
  /// for each point of the file of curves: its row in the mesh; empty if the file lacks these rows
  std::vector<std::int32_t> mesh_point;
  std::map<std::int32_t, std::string> region_names, surface_kinds;
  /// Name of each list of surface ids in surface_sets; empty if the file has none.
  std::vector<std::string> surface_set_names;
};

/// Contents of NAME.curves.vtp: edges of curves and named points.
struct CurvesFile {
  struct Curve {
    std::int32_t id;
    std::string name, kind;
  };
  std::vector<Curve> curves;  ///< curves in the order of the file, including named points
  std::vector<Vec3> points;
  /// for each point of the file of faces: its row in the mesh; empty if the file lacks these rows
  std::vector<std::int32_t> mesh_point;
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<VertexIndex> vertices;                   ///< points that are cells of the file (VTK vertices)
  std::vector<std::int32_t> edge_curve, vertex_curve;  ///< ids
};

/// Reads a mesh file by its extension: .vtu, .vtk (VTK), and other mesh formats that have a reader. Throws Error{usage}
/// if the file cannot be opened, Error{invalid_input} if it cannot be understood.
MeshFile read_mesh_file(const std::filesystem::path& path);
MeshFile read_vtk_mesh(const std::filesystem::path& path);
/// Reads a mesh in parts (.pvtu) and combines its pieces. Midpoints of second-order elements are left out.
MeshFile read_pvtu_mesh(const std::filesystem::path& path);

FacesFile read_faces_file(const std::filesystem::path& path);
CurvesFile read_curves_file(const std::filesystem::path& path);

/// Faces and curves of a .vtu with a single grid for all cells (`output.single_grid`), in the form of separate files.
struct SurfacesOfGrid {
  FacesFile faces;
  CurvesFile curves;
};
/// Reads the faces and curves of a VTU file with cells of all dimensions; nothing if no face has geomesh's arrays.
std::optional<SurfacesOfGrid> read_surfaces_of_grid(const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Meshes and face sets as contained in files of any tool. Only indices are checked here; everything else is left to
/// the checker.
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
  bool single_precision = false;  ///< whether the file has 32-bit coordinates
  std::vector<Tetrahedron> tetrahedra;
  /// Six for each tetrahedron (01 12 20 03 13 23); empty if any tetrahedron has first order.
  std::vector<VertexIndex> midpoints;
  std::vector<std::size_t> cell;   ///< for each tetrahedron: its number among all cells of the file, for messages
  std::size_t n_other_solids = 0;  ///< hexahedra, prisms ...
  std::vector<std::array<VertexIndex, 6>> prisms;  ///< prisms among the other solids, in VTK's order (VTK only)
  std::size_t n_lower_cells = 0;                   ///< number of triangles, lines and points in addition to the solids
  std::vector<std::int32_t> region;                ///< region of each tetrahedron; empty if the file has no such array
  std::string region_array;                        ///< its name
  std::map<std::int32_t, std::string> region_names;
  std::vector<std::string> arrays;        ///< arrays of points and cells with their type (VTK files only)
  std::vector<Triangle> triangles;        ///< triangles in addition to the solids (.vtu, and files of solvers)
  std::vector<std::int32_t> triangle_id;  ///< ids of the triangles, which have names (VTU files only)
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<std::int32_t> edge_id;
  std::map<std::int32_t, std::string> curve_names;
  std::vector<std::int32_t> input_vertex;   ///< for each point, -1 if it was added; empty if the file has no such array
  std::vector<std::string> missing_arrays;  ///< names of missing point arrays of the output contract (VTK files only)
  std::vector<std::int32_t> kind;           ///< for each point; empty if the file has no such array
  std::map<std::string, std::vector<double>> cell_values;   ///< values for each tetrahedron, except "region" (VTK only)
  std::map<std::string, std::vector<double>> point_values;  ///< point arrays of scalars (VTK only)
  std::map<std::string, std::vector<std::int32_t>> region_groups;  ///< named groups of regions
  std::vector<std::int64_t> global_points;  ///< point array GlobalPointIds; empty if the file has none
  std::vector<Vec3> before_zones;           ///< point array `before_zones`; empty if the file has none
  Vec3 origin{0, 0, 0};  ///< vector that was subtracted from the coordinates (field data written by geomesh)
};

struct FacesFile {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> surface, surface_set, patch, region_minus, region_plus, source_triangle;
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::vector<std::int32_t>> surface_sets;
  std::vector<std::string> missing_arrays;  ///< names of missing arrays of the output contract
  std::vector<std::int32_t> mesh_point;     ///< for each point; empty if the file has no such array
  std::map<std::int32_t, std::string> region_names, surface_kinds;
  std::vector<std::string> surface_set_names;  ///< by row of surface_sets; empty if the file has none
};

/// Contents of NAME.curves.vtp: edges of curves and named points.
struct CurvesFile {
  struct Curve {
    std::int32_t id;
    std::string name, kind;
  };
  std::vector<Curve> curves;  ///< in the order of the file, including named points
  std::vector<Vec3> points;
  std::vector<std::int32_t> mesh_point;  ///< for each point; empty if the file has no such array
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<VertexIndex> vertices;                   ///< vertices of the cells with one point
  std::vector<std::int32_t> edge_curve, vertex_curve;  ///< ids
};

/// Chooses the reader by extension: .vtu, .vtk (VTK), and formats of the table that have a reader. Throws Error{usage}
/// if the file cannot be opened, Error{invalid_input} if it cannot be understood.
MeshFile read_mesh_file(const std::filesystem::path& path);
MeshFile read_vtk_mesh(const std::filesystem::path& path);
/// Reads a mesh in parts whose pieces have global numbers. Midpoints of second-order elements are left out.
MeshFile read_pvtu_mesh(const std::filesystem::path& path);

FacesFile read_faces_file(const std::filesystem::path& path);
CurvesFile read_curves_file(const std::filesystem::path& path);

/// The contents of the faces and curves files, read from a .vtu with a single grid for all cells
/// (`output.single_grid`).
struct SurfacesOfGrid {
  FacesFile faces;
  CurvesFile curves;
};
/// Returns nothing if the grid has no face with the arrays of the output contract.
std::optional<SurfacesOfGrid> read_surfaces_of_grid(const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Meshes and face sets as they stand in files, of any tool. Reading only; indices are checked, everything else is left
/// to be judged.
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
  bool single_precision = false;  ///< the file holds 32-bit coordinates
  std::vector<Tetrahedron> tetrahedra;
  std::vector<VertexIndex> midpoints;  ///< six a tetrahedron (01 12 20 03 13 23); empty where any is of first order
  std::vector<std::size_t> cell;       ///< per tetrahedron: its number among all cells of the file, for messages
  std::size_t n_other_solids = 0;      ///< hexahedra, prisms ...
  std::vector<std::array<VertexIndex, 6>> prisms;  ///< those of the other solids, in VTK's order (VTK files only)
  std::size_t n_lower_cells = 0;                   ///< triangles, lines, points beside the solids
  std::vector<std::int32_t> region;                ///< per tetrahedron; empty where the file has no such array
  std::string region_array;                        ///< its name
  std::map<std::int32_t, std::string> region_names;
  std::vector<std::string> arrays;        ///< of points and cells, with their type (VTK files only)
  std::vector<Triangle> triangles;        ///< beside the solids (.vtu, and files of solvers)
  std::vector<std::int32_t> triangle_id;  ///< with their names (VTU files only)
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<std::int32_t> edge_id;
  std::map<std::int32_t, std::string> curve_names;
  std::vector<std::int32_t> input_vertex;   ///< per point, -1 where added; empty where the file has no such array
  std::vector<std::string> missing_arrays;  ///< point arrays of the output contract that are not there (VTK files only)
  std::vector<std::int32_t> kind;           ///< per point; empty where the file has no such array
  std::map<std::string, std::vector<double>> cell_values;          ///< per tetrahedron, but "region" (VTK only)
  std::map<std::string, std::vector<double>> point_values;         ///< point arrays of one number (VTK only)
  std::map<std::string, std::vector<std::int32_t>> region_groups;  ///< regions under one more name
  std::vector<std::int64_t> global_points;  ///< point array GlobalPointIds; empty where the file has none
  std::vector<Vec3> before_zones;           ///< point array; empty where the file has none
  Vec3 origin{0, 0, 0};                     ///< was subtracted from the coordinates (field data of our files)
};

struct FacesFile {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> surface, surface_set, patch, region_minus, region_plus, source_triangle;
  std::map<std::int32_t, std::string> surface_names;
  std::vector<std::vector<std::int32_t>> surface_sets;
  std::vector<std::string> missing_arrays;  ///< of the output contract
  std::vector<std::int32_t> mesh_point;     ///< per point; empty where the file has no such array
  std::map<std::int32_t, std::string> region_names, surface_kinds;
  std::vector<std::string> surface_set_names;  ///< by row of surface_sets; empty where the file has none
};

/// NAME.curves.vtp: edges of curves and named points.
struct CurvesFile {
  struct Curve {
    std::int32_t id;
    std::string name, kind;
  };
  std::vector<Curve> curves;  ///< as listed, named points among them
  std::vector<Vec3> points;
  std::vector<std::int32_t> mesh_point;  ///< per point; empty where the file has no such array
  std::vector<std::array<VertexIndex, 2>> edges;
  std::vector<VertexIndex> vertices;                   ///< of the cells of one point
  std::vector<std::int32_t> edge_curve, vertex_curve;  ///< ids
};

/// By extension: .vtu, .vtk (VTK), and what the table of formats has a reader for. Throws Error{usage} where the file
/// cannot be opened, Error{invalid_input} where it cannot be understood.
MeshFile read_mesh_file(const std::filesystem::path& path);
MeshFile read_vtk_mesh(const std::filesystem::path& path);
/// A mesh in parts whose pieces have global numbers. Midpoints of elements of second order are left out.
MeshFile read_pvtu_mesh(const std::filesystem::path& path);

FacesFile read_faces_file(const std::filesystem::path& path);
CurvesFile read_curves_file(const std::filesystem::path& path);

/// What both files hold, from a .vtu with one grid for all cells (`output.single_grid`).
struct SurfacesOfGrid {
  FacesFile faces;
  CurvesFile curves;
};
/// Nothing where the grid has no face with the arrays of the output contract.
std::optional<SurfacesOfGrid> read_surfaces_of_grid(const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A mesh as contained in a file of any tool: cells of each dimension and named sets, in the file's order.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Cells of one dimension, by their corners; further nodes of cells of higher order are not included.
struct RawCells {
  std::size_t n_corners = 0;
  std::vector<VertexIndex> corners;
  std::size_t size() const { return n_corners == 0 ? 0 : corners.size() / n_corners; }
};

struct RawSet {
  std::string name;
  std::int32_t id = 0;  ///< number of the set of cells or nodes in the mesh file; 0 if it has none
  int dimension = 0;    ///< dimension of the cells in the set; -1 for a set of nodes
  std::vector<std::size_t> rows;
};

/// Limits how many cells and nodes the sets of a mesh file may contain together. A list can be named in a few bytes,
/// and a set of all elements as often as the file has lines: without a bound a short file could fill all memory.
class SetBudget {
 public:
  static constexpr std::size_t always = 10'000'000, a_byte = 10;
  static constexpr const char* message =
      "its sets name more cells and nodes in all than 10,000,000 and ten for each byte of the file";

  explicit SetBudget(std::size_t bytes) : left_(always + a_byte * bytes) {}
  /// Raises the limit on the number of cells and nodes in sets, for one more mesh file of this size in bytes.
  void grow(std::size_t bytes) { left_ += a_byte * bytes; }
  /// Counts `n` more cells or nodes that a mesh file lists in sets. Returns false if their number exceeds the limit.
  [[nodiscard]] bool take(std::size_t n) {
    if (n > left_) return false;
    left_ -= n;
    return true;
  }

 private:
  std::size_t left_;
};

struct RawMesh {
  std::string format, name;
  std::vector<Vec3> points;
  std::array<RawCells, 4> cells{{{1, {}}, {2, {}}, {3, {}}, {4, {}}}};
  std::vector<std::size_t> numbers;  ///< numbers of the tetrahedra among all cells of the file, for messages
  std::vector<RawSet> sets;
  std::size_t n_other_solids = 0;  ///< hexahedra, prisms ...
  bool second_order = false;
  /// Six midpoint nodes for each second-order tetrahedron, on the edges 01 12 20 03 13 23.
  std::vector<VertexIndex> midpoints;
  bool single_precision = false;  ///< whether the file has coordinates in single precision
  /// Kind and input row of each mesh point; empty unless geomesh wrote the file.
  std::vector<std::int32_t> point_kind, input_vertex;
  std::vector<CellArray> cell_arrays;    ///< by tetrahedron
  std::vector<PointArray> point_arrays;  ///< point arrays, with one value for each point of the mesh
  /// Name that a single file of the mesh would have, if it was read from parts; else empty.
  std::filesystem::path whole;
  /// Positions of points before fault zones were opened; empty unless geomesh wrote the file.
  std::vector<Vec3> before_zones;
  Vec3 origin{0, 0, 0};
};

/// Converts the sets of a mesh file to a named mesh: regions from the sets of tetrahedra, surfaces from those of
/// triangles, curves from those of edges, named points, other node sets. If tetrahedra lie in several sets, the sets
/// become groups of regions. Full names and kinds come from FILE.json if it exists. Unused points are dropped, inverted
/// tetrahedra are flipped. Throws Error{invalid_input} if a solid is not a tetrahedron.
ModelMesh to_model_mesh(RawMesh raw, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

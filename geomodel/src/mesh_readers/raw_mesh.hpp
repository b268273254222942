// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A mesh as it stands in a file of any tool: cells of each dimension and named sets of them, in the file's order.
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

/// Cells of one dimension; of cells of higher order the corners.
struct RawCells {
  std::size_t n_corners = 0;
  std::vector<VertexIndex> corners;
  std::size_t size() const { return n_corners == 0 ? 0 : corners.size() / n_corners; }
};

/// A named set of cells or of nodes.
struct RawSet {
  std::string name;
  std::int32_t id = 0;  ///< in the file; 0 where it has none
  int dimension = 0;    ///< of the cells; of a set of nodes -1
  std::vector<std::size_t> rows;
};

/// How many cells and nodes the sets of a mesh file may name together. A list can be named in a few bytes, and a set of
/// all elements as often as the file has lines: without a bound a short file fills all memory.
class SetBudget {
 public:
  static constexpr std::size_t always = 10'000'000, a_byte = 10;
  static constexpr const char* message =
      "its sets name more cells and nodes in all than 10,000,000 and ten for each byte of the file";

  explicit SetBudget(std::size_t bytes) : left_(always + a_byte * bytes) {}
  /// Of one more file.
  void grow(std::size_t bytes) { left_ += a_byte * bytes; }
  /// False where `n` more are too many.
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
  std::array<RawCells, 4> cells{{{1, {}}, {2, {}}, {3, {}}, {4, {}}}};  ///< points, edges, triangles, tetrahedra
  std::vector<std::size_t> numbers;  ///< of tetrahedra, among all cells of the file, for messages
  std::vector<RawSet> sets;
  std::size_t n_other_solids = 0;  ///< hexahedra, prisms ...
  bool second_order = false;
  std::vector<VertexIndex> midpoints;  ///< six a tetrahedron of second order, of the edges 01 12 20 03 13 23
  bool single_precision = false;       ///< the file holds 32-bit coordinates
  std::vector<std::int32_t> point_kind, input_vertex;  ///< of our own files; else empty
  std::vector<CellArray> cell_arrays;                  ///< by tetrahedron
  std::vector<PointArray> point_arrays;                ///< by row of `points`
  std::filesystem::path whole;     ///< of a mesh read from parts: what its one file would be called; else empty
  std::vector<Vec3> before_zones;  ///< of our own files; else empty
  Vec3 origin{0, 0, 0};
};

/// The named mesh: regions from the sets of tetrahedra, surfaces from those of triangles, curves from those of edges,
/// named points, other node sets. Where tetrahedra lie in several sets, the sets become groups of regions. Full names
/// and kinds come from FILE.json where that is there. Points that no cell uses are dropped, tetrahedra that turn the
/// wrong way are turned. Throws Error{invalid_input} where a solid is no tetrahedron.
ModelMesh to_model_mesh(RawMesh raw, const std::filesystem::path& file);

}  // namespace geomesh::geomodel

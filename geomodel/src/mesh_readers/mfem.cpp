// SPDX-License-Identifier: GPL-3.0-or-later
// Reads MFEM meshes v1.0 to v1.3 with vertices: tetrahedra, triangles, their attributes.
#include "mesh_readers/file_cursor.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {
namespace {

/// Number of corners by MFEM's geometry type: point, segment, triangle, square, tetrahedron, cube, prism, pyramid.
constexpr std::array<std::size_t, 8> n_corners{1, 2, 3, 4, 4, 8, 6, 5};

class MfemReader {
 public:
  explicit MfemReader(const std::filesystem::path& path) : in_(path) {}

  RawMesh read() {
    mesh_.format = "MFEM";
    if (!in_.line().starts_with("MFEM mesh v1.")) in_.refuse("no \"MFEM mesh v1.\" in its first line");
    while (!in_.at_end()) {
      const std::string_view section = in_.line();
      if (section == "elements") read_cells(3);
      if (section == "boundary") read_cells(2);
      if (section == "vertices") read_vertices();
    }
    for (const RawCells& cells : mesh_.cells)
      for (const VertexIndex v : cells.corners)
        if (v >= mesh_.points.size()) in_.refuse("vertex " + std::to_string(v) + " is not there");
    for (auto& [key, set] : sets_) mesh_.sets.push_back(std::move(set));
    return std::move(mesh_);
  }

 private:
  void read_cells(int dimension) {
    const int simplex = dimension == 3 ? 4 : 2;
    RawCells& cells = mesh_.cells[static_cast<std::size_t>(dimension)];
    for (auto n = in_.number<std::size_t>(); n > 0; --n) {
      const auto attribute = in_.number<std::int32_t>();
      const int type = in_.number<int>();
      if (type < 0 || type > 7) in_.refuse("geometry type " + std::to_string(type) + " is not known");
      for (std::size_t i = 0; i < n_corners[static_cast<std::size_t>(type)]; ++i) {
        const auto v = in_.number<VertexIndex>();
        if (type == simplex) cells.corners.push_back(v);
      }
      if (dimension == 3) ++n_elements_;
      if (type != simplex) {
        mesh_.n_other_solids += dimension == 3;
        continue;
      }
      if (dimension == 3) mesh_.numbers.push_back(n_elements_ - 1);
      RawSet& set = sets_[{dimension, attribute}];
      set.id = attribute;
      set.dimension = dimension;
      set.rows.push_back(cells.size() - 1);
    }
  }
  void read_vertices() {
    const auto n = in_.number<std::size_t>();
    const std::string_view width = in_.word();
    if (width != "3") in_.refuse("only meshes with vertices of three coordinates are read (order 1)");
    for (std::size_t i = 0; i < n; ++i) {
      const auto x = in_.number<double>(), y = in_.number<double>(), z = in_.number<double>();
      mesh_.points.push_back({x, y, z});
    }
  }

  FileCursor in_;
  RawMesh mesh_;
  std::size_t n_elements_ = 0;
  std::map<std::pair<int, std::int32_t>, RawSet> sets_;
};

}  // namespace

RawMesh read_mfem_mesh(const std::filesystem::path& file) { return MfemReader(file).read(); }

}  // namespace geomesh::geomodel

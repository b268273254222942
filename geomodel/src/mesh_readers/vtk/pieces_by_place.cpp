// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/vtk/pieces_by_place.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>

namespace geomesh::geomodel::checking {
namespace {

using Values = std::map<std::string, std::vector<double>>;

Values common_names(const std::vector<MeshFile>& pieces, Values MeshFile::*values) {
  Values names;
  for (const auto& [name, ignored] : pieces.front().*values) {
    const bool everywhere = std::all_of(pieces.begin(), pieces.end(), [&, &wanted = name](const MeshFile& piece) {
      return (piece.*values).contains(wanted);
    });
    if (everywhere && name != "vtkGhostType") names[name];
  }
  return names;
}

class PlaceMerger {
 public:
  explicit PlaceMerger(const std::vector<MeshFile>& pieces) {
    mesh_.format = "VTK unstructured grid in pieces";
    mesh_.cell_values = common_names(pieces, &MeshFile::cell_values);
    mesh_.point_values = common_names(pieces, &MeshFile::point_values);
    has_regions_ = std::all_of(pieces.begin(), pieces.end(), [](const MeshFile& piece) {
      return piece.region.size() == piece.tetrahedra.size() && !piece.region_array.empty();
    });
    mesh_.missing_arrays = {"kind", "input_vertex"};
  }

  void add(const MeshFile& piece) {
    const auto ghosts = piece.cell_values.find("vtkGhostType");
    rows_.assign(piece.points.size(), no_vertex);
    for (std::size_t t = 0; t < piece.tetrahedra.size(); ++t) {
      if (ghosts != piece.cell_values.end() && ghosts->second[t] != 0) continue;
      Tetrahedron& own = mesh_.tetrahedra.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) own[i] = row_of(piece, piece.tetrahedra[t][i]);
      mesh_.cell.push_back(mesh_.cell.size());
      if (has_regions_) mesh_.region.push_back(piece.region[t]);
      for (auto& [name, values] : mesh_.cell_values) values.push_back(piece.cell_values.at(name)[t]);
    }
    mesh_.single_precision |= piece.single_precision;
    mesh_.n_other_solids += piece.n_other_solids;
    if (has_regions_) mesh_.region_array = piece.region_array;
    mesh_.region_names.insert(piece.region_names.begin(), piece.region_names.end());
    mesh_.region_groups.insert(piece.region_groups.begin(), piece.region_groups.end());
    if (mesh_.arrays.empty()) mesh_.arrays = piece.arrays;
    mesh_.origin = piece.origin;
  }
  MeshFile merged() { return std::move(mesh_); }

 private:
  VertexIndex row_of(const MeshFile& piece, VertexIndex v) {
    if (rows_[v] != no_vertex) return rows_[v];
    const Vec3& p = piece.points[v];
    const auto [entry, is_new] = row_at_.try_emplace(bits_of(p), static_cast<VertexIndex>(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(p);
      for (auto& [name, values] : mesh_.point_values) values.push_back(piece.point_values.at(name)[v]);
    }
    return rows_[v] = entry->second;
  }

  /// Returns the bits of a point's coordinates, by which any numbers can be compared; both zeros have the same bits.
  static std::array<std::uint64_t, 3> bits_of(const Vec3& p) {
    return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
            std::bit_cast<std::uint64_t>(p.z + 0.0)};
  }

  MeshFile mesh_;
  bool has_regions_ = false;
  std::vector<VertexIndex> rows_;  // for each point of the piece of a mesh: its row in the whole mesh
  std::map<std::array<std::uint64_t, 3>, VertexIndex> row_at_;
};

}  // namespace

MeshFile merged_by_place(std::vector<MeshFile> pieces) {
  PlaceMerger merger(pieces);
  for (const MeshFile& piece : pieces) merger.add(piece);
  return merger.merged();
}

}  // namespace geomesh::geomodel::checking

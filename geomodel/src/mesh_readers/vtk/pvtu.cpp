// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh in parts (.pvtu): its pieces are combined by their global numbers, or by the coordinates of their points
// if no piece has such numbers; copies of other pieces' cells (ghosts) are left out.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>

#include "geomesh/core/error.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk/pieces_by_place.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Largest size in bytes of a .pvtu file, which names the pieces of a mesh.
constexpr std::size_t most_bytes = std::size_t{1} << 26;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": " + why);
}

std::string unescaped(std::string text) {
  for (const auto& [from, to] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; ++at)
      text.replace(at, std::string_view(from).size(), to);
  return text;
}

std::vector<std::filesystem::path> pieces_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
  std::string text;
  for (char block[1 << 16]; in.read(block, sizeof block) || in.gcount() > 0;) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (text.size() > most_bytes) refuse(path, "is too large for a file that names pieces");
  }
  if (text.find("<PUnstructuredGrid") == std::string::npos || text.find("</VTKFile>") == std::string::npos)
    refuse(path, "is no complete VTK XML file of type PUnstructuredGrid");
  constexpr std::string_view element = "<Piece", source = "Source=\"";
  std::vector<std::filesystem::path> pieces;
  std::set<std::filesystem::path> known;
  for (std::size_t at = text.find(element), end = 0; at != std::string::npos; at = text.find(element, end)) {
    end = text.find('>', at);
    if (end == std::string::npos) break;
    const std::size_t name = std::string_view(text).substr(at, end - at).find(source);
    if (name == std::string_view::npos) continue;
    const std::size_t first = at + name + source.size(), last = text.find('"', first);
    if (last == std::string::npos) break;
    end = last;
    pieces.push_back(path.parent_path() / unescaped(text.substr(first, last - first)));
    if (!known.insert(pieces.back()).second)
      refuse(path, "names its piece " + pieces.back().filename().string() + " twice");
  }
  if (pieces.empty()) refuse(path, "names no pieces");
  return pieces;
}

struct Piece {
  std::filesystem::path file;
  MeshFile mesh;
};

bool is_ghost(const MeshFile& piece, std::size_t t) {
  const auto ghosts = piece.cell_values.find("vtkGhostType");
  return ghosts != piece.cell_values.end() && ghosts->second[t] != 0;
}

class PieceMerger {
 public:
  /// Prepares to merge the pieces (files) of a mesh in parts. Global numbers must count all points and cells of the
  /// pieces without gaps, so that they cannot require more memory than the files.
  PieceMerger(const std::filesystem::path& path, const std::vector<Piece>& pieces) : path_(path) {
    std::size_t n_cells = 0;
    for (const Piece& piece : pieces) {
      most_points_ += piece.mesh.points.size();
      for (std::size_t t = 0; t < piece.mesh.tetrahedra.size(); ++t) n_cells += !is_ghost(piece.mesh, t);
    }
    mesh_.cell.resize(n_cells, no_row);
    mesh_.tetrahedra.resize(n_cells);
    for (const Piece& piece : pieces) {
      if (!piece.mesh.region.empty()) mesh_.region.resize(n_cells);
      for (const auto& [name, values] : piece.mesh.cell_values)
        if (name != "GlobalCellIds" && name != "vtkGhostType" && name != "partition")
          mesh_.cell_values[name].resize(n_cells);
    }
  }

  void add(MeshFile piece, const std::filesystem::path& file) {
    const auto cells = piece.cell_values.find("GlobalCellIds");
    if (piece.global_points.size() != piece.points.size() || cells == piece.cell_values.end())
      refuse(path_,
             "its piece " + file.filename().string() +
                 " has no global numbers (point array GlobalPointIds, cell array GlobalCellIds), by which pieces "
                 "are put together");
    for (std::size_t t = 0; t < piece.tetrahedra.size(); ++t) {
      if (is_ghost(piece, t)) continue;
      const std::size_t row = row_of(cells->second[t], mesh_.cell.size(), file);
      if (mesh_.cell[row] != no_row) refuse(path_, "cell " + std::to_string(row) + " is owned by two pieces");
      mesh_.cell[row] = row;
      for (std::size_t i = 0; i < 4; ++i) mesh_.tetrahedra[row][i] = point_of(piece, piece.tetrahedra[t][i], file);
      if (!piece.region.empty()) mesh_.region[row] = piece.region[t];
      for (auto& [name, values] : mesh_.cell_values)
        if (const auto own = piece.cell_values.find(name); own != piece.cell_values.end()) values[row] = own->second[t];
    }
    take_rest(std::move(piece));
  }

  MeshFile merged() {
    if (std::find(mesh_.cell.begin(), mesh_.cell.end(), no_row) != mesh_.cell.end() ||
        std::find(is_known_.begin(), is_known_.end(), false) != is_known_.end())
      refuse(path_, "global numbers of its pieces have gaps: a piece is missing");
    for (auto& [name, values] : mesh_.point_values) values.resize(mesh_.points.size());
    mesh_.format = "VTK unstructured grid in pieces";
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t no_row = SIZE_MAX;

  std::size_t row_of(double number, std::size_t n, const std::filesystem::path& file) const {
    if (!(number >= 0) || number >= static_cast<double>(n))
      refuse(path_, "a global number in " + file.filename().string() +
                        " is out of range: global numbers have gaps, or a piece is missing");
    return static_cast<std::size_t>(number);
  }
  VertexIndex point_of(const MeshFile& piece, VertexIndex local, const std::filesystem::path& file) {
    const std::size_t row = row_of(static_cast<double>(piece.global_points[local]), most_points_, file);
    if (row >= is_known_.size()) {
      is_known_.resize(row + 1, false);
      mesh_.points.resize(row + 1);
      mesh_.kind.resize(row + 1);
      mesh_.input_vertex.resize(row + 1, -1);
    }
    if (is_known_[row] && !(mesh_.points[row] == piece.points[local]))
      refuse(path_, "point " + std::to_string(row) + " has different places in two pieces");
    is_known_[row] = true;
    for (const auto& [name, values] : piece.point_values) {
      std::vector<double>& all = mesh_.point_values[name];
      if (all.size() <= row) all.resize(row + 1);
      all[row] = values[local];
    }
    mesh_.points[row] = piece.points[local];
    if (local < piece.kind.size()) mesh_.kind[row] = piece.kind[local];
    if (local < piece.input_vertex.size()) mesh_.input_vertex[row] = piece.input_vertex[local];
    return static_cast<VertexIndex>(row);
  }
  void take_rest(MeshFile piece) {
    mesh_.single_precision |= piece.single_precision;
    mesh_.n_other_solids += piece.n_other_solids;
    mesh_.region_array = piece.region_array;
    mesh_.region_names.merge(piece.region_names);
    mesh_.region_groups.merge(piece.region_groups);
    if (mesh_.arrays.empty()) mesh_.arrays = std::move(piece.arrays);
    mesh_.missing_arrays = std::move(piece.missing_arrays);
    mesh_.origin = piece.origin;
  }

  const std::filesystem::path& path_;
  std::size_t most_points_ = 0;  // sum of the numbers of points of all pieces of the mesh, some of them in several
  MeshFile mesh_;
  std::vector<bool> is_known_;  // by point
};

}  // namespace

MeshFile read_pvtu_mesh(const std::filesystem::path& path) {
  std::vector<Piece> pieces;
  for (const std::filesystem::path& file : pieces_of(path)) pieces.push_back({file, read_vtk_mesh(file)});
  const bool has_numbers = std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
    return !piece.mesh.global_points.empty() || piece.mesh.cell_values.contains("GlobalCellIds");
  });
  if (!has_numbers) {
    std::vector<MeshFile> meshes;
    for (Piece& piece : pieces) meshes.push_back(std::move(piece.mesh));
    return merged_by_place(std::move(meshes));
  }
  PieceMerger merger(path, pieces);
  for (Piece& piece : pieces) merger.add(std::move(piece.mesh), piece.file);
  return merger.merged();
}

}  // namespace geomesh::geomodel::checking

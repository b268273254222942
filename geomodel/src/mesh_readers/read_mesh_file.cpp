// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh file with the reader that belongs to its extension.
#include <algorithm>
#include <utility>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/raw_mesh.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Gives each tetrahedron as region the smallest set that contains it, because groups of regions are larger.
MeshFile take(RawMesh raw) {
  MeshFile mesh;
  mesh.format = raw.format;
  mesh.region_array = "group of elements";
  mesh.points = std::move(raw.points);
  mesh.single_precision = raw.single_precision;
  const RawCells& cells = raw.cells[3];
  for (std::size_t t = 0; t < cells.size(); ++t)
    mesh.tetrahedra.push_back(
        {cells.corners[4 * t], cells.corners[4 * t + 1], cells.corners[4 * t + 2], cells.corners[4 * t + 3]});
  if (raw.midpoints.size() == 6 * cells.size()) mesh.midpoints = std::move(raw.midpoints);
  mesh.cell = std::move(raw.numbers);
  mesh.n_other_solids = raw.n_other_solids;
  mesh.n_lower_cells = raw.cells[0].size() + raw.cells[1].size() + raw.cells[2].size();
  const std::vector<VertexIndex>& corners = raw.cells[2].corners;
  for (std::size_t f = 0; f < raw.cells[2].size(); ++f)
    mesh.triangles.push_back({corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]});
  mesh.region.assign(mesh.tetrahedra.size(), 0);
  std::vector<std::pair<std::int32_t, const RawSet*>> sets;  // with their ids
  std::int32_t next = 1;
  for (const RawSet& set : raw.sets) {
    if (set.dimension != 3) continue;
    const std::int32_t id = set.id != 0 ? set.id : next;
    next = std::max(next, id) + 1;
    sets.emplace_back(id, &set);
  }
  std::ranges::stable_sort(sets, {}, [](const auto& set) { return set.second->rows.size(); });
  for (const auto& [id, set] : sets) {
    bool used = false;
    for (const std::size_t t : set->rows)
      if (mesh.region[t] == 0) {
        mesh.region[t] = id;
        used = true;
      }
    if (used && !set->name.empty()) mesh.region_names[id] = set->name;
  }
  return mesh;
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".pvtu") return read_pvtu_mesh(path);
  if (extension == ".vtu" || extension == ".vtk") return read_vtk_mesh(path);
  if (const Format* const format = format_of_file(path); format && format->read) return take(format->read(path));
  throw Error(ErrorKind::usage, path.string() +
                                    ": no known mesh format; check reads .vtu, .pvtu, .vtk, .msh, .inp, .e, .mesh"
                                    " and, where built with libmedc, .med");
}

}  // namespace geomesh::geomodel::checking

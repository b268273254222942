// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/vtk/pvtu.hpp"

#include "formats/vtk/vtu_grid.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "partition/mesh_parts.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Value with which VTK marks points and cells that another part owns (DUPLICATEPOINT, DUPLICATECELL).
constexpr std::uint8_t owned_elsewhere = 1;

void add_part_arrays(const MeshParts& parts, const VtuLayout& layout, VtkDocument& document) {
  const MeshPart& part = *layout.part();
  VtkSection &points = document.sections[0], &cells = document.sections[1];
  points.attributes = "GlobalIds=\"GlobalPointIds\"";
  cells.attributes += " GlobalIds=\"GlobalCellIds\"";
  points.arrays.push_back(vtk_array<std::int64_t>("GlobalPointIds", part.nodes.size(), [&part, &parts](std::size_t i) {
    return parts.node_number(part.nodes[i]);
  }));
  points.arrays.push_back(vtk_array<std::uint8_t>("vtkGhostType", part.nodes.size(), [&part, &parts](std::size_t i) {
    return parts.owner_of_node(part.nodes[i]) == part.number ? 0 : owned_elsewhere;
  }));
  cells.arrays.push_back(vtk_array<std::int64_t>(
      "GlobalCellIds", part.cells.size(), [&part, &parts](std::size_t i) { return parts.cell_number(part.cells[i]); }));
  cells.arrays.push_back(vtk_array<std::uint8_t>(
      "vtkGhostType", part.cells.size(), [&part](std::size_t i) { return i < part.n_own ? 0 : owned_elsewhere; }));
  cells.arrays.push_back(vtk_array<std::int32_t>(
      "partition", part.cells.size(), [&part, &parts](std::size_t i) { return parts.part_of_cell(part.cells[i]); }));
}

std::string arrays_of(const VtkSection& section) {
  std::string text = "<P" + section.tag + (section.attributes.empty() ? "" : " ") + section.attributes + ">\n";
  for (const VtkArray& array : section.arrays)
    text += std::string("<PDataArray type=\"") + array.type + "\" Name=\"" + xml_text(array.name) +
            "\" NumberOfComponents=\"" + std::to_string(array.components) + "\"/>\n";
  return text + "</P" + section.tag + ">\n";
}

}  // namespace

std::vector<std::filesystem::path> write_pvtu(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  return write_pvtu(mesh, MeshParts(mesh, static_cast<std::int32_t>(options.partitions)), options, stem);
}

std::vector<std::filesystem::path> write_pvtu(const ModelMesh& mesh, const MeshParts& parts,
                                              const WriteOptions& options, const std::filesystem::path& stem) {
  const auto file_of_part = [&stem](std::int32_t p) {
    return std::filesystem::path(stem.string() + ".part" + std::to_string(p) + ".vtu");
  };
  WrittenFiles written;
  std::string arrays, pieces;
  bool has_first = false;
  for (const std::int32_t p : parts.parts_here()) {
    const MeshPart part = parts.part(p, Ghosts::one_layer);
    const VtuLayout layout(mesh, options, &part);
    VtkDocument document = vtu_document(mesh, options, layout);
    add_part_arrays(parts, layout, document);
    write_vtk_document(document, options.compression, file_of_part(p));
    written.add(file_of_part(p));
    if (p > 0) continue;
    has_first = true;
    for (std::size_t s = 0; s < 3; ++s) arrays += "" + arrays_of(document.sections[s]);
  }
  if (!has_first) return written.keep();
  for (std::int32_t p = 0; p < parts.n_parts(); ++p)
    pieces += "<Piece Source=\"" + xml_text(file_of_part(p).filename().string()) + "\"/>\n";
  const std::filesystem::path file = stem.string() + ".pvtu";
  write_text_file(file,
                  "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
                  "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"1\">\n" +
                      arrays + pieces + "</PUnstructuredGrid>\n</VTKFile>\n");
  written.add(file);
  return written.keep();
}

}  // namespace geomesh::geomodel

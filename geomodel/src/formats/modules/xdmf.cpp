// SPDX-License-Identifier: GPL-3.0-or-later
// Writes XDMF 3 with HDF5, for dolfinx, FEniCS, meshio and ParaView (built only if HDF5 is available): NAME.xdmf has
// the cells with their region, NAME.facets.xdmf and NAME.edges.xdmf the tagged faces and edges on the same points. The
// numbers of each .xdmf file are in an .h5 file of the same name. A file has one grid, because meshio reads only one.
#include <algorithm>
#include <array>

#include "formats/modules/format_module.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/hdf5_writer.hpp"
#include "writers/text_buffer.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t tags_at_once = 1 << 16;

struct TaggedCells {
  const char* topology;
  const char* name;  ///< name of the XDMF grid and of its attribute
  std::size_t width, n;
  std::vector<std::pair<const CellBlock*, std::int32_t>> blocks;  ///< with the number
};

/// Returns the cells of one dimension with their XDMF type. If only fractures are written, triangles are the cells of
/// highest dimension. Midpoints keep their order, because XDMF has the same order as VTK.
TaggedCells cells_of(const SolverMesh& mesh, int dimension) {
  const bool second = mesh.second_order();
  const std::array names{"region", "facet_tags", "edge_tags"};
  const int of_mesh = mesh.count(3) > 0 ? 3 : 2;
  TaggedCells cells{dimension == 3   ? second ? "Tetrahedron_10" : "Tetrahedron"
                    : dimension == 2 ? second ? "Triangle_6" : "Triangle"
                    : second         ? "Edge_3"
                                     : "PolyLine",
                    names[static_cast<std::size_t>(of_mesh - std::min(of_mesh, dimension))],
                    0,
                    0,
                    {}};
  const std::size_t widths[2][4] = {{1, 2, 3, 4}, {1, 3, 6, 10}};
  cells.width = widths[second ? 1 : 0][dimension];
  for (const CellGroup& label : mesh.labels) {
    if (label.dimension != dimension) continue;
    for (const std::size_t b : label.blocks) {
      cells.blocks.emplace_back(&mesh.blocks[b], label.id);
      cells.n += mesh.blocks[b].n_cells();
    }
  }
  return cells;
}

std::string data_item(const std::string& source, std::size_t n, std::size_t width, const char* type) {
  return "<DataItem Dimensions=\"" + std::to_string(n) + (width == 1 ? "" : " " + std::to_string(width)) +
         "\" NumberType=\"" + type + "\" Format=\"HDF\">" + source + "</DataItem>";
}

std::string grid_text(const std::string& h5, const TaggedCells& cells, std::size_t n_nodes) {
  const std::size_t n = cells.n;
  const std::string at = h5 + ":/" + cells.name;
  TextBuffer text;
  text << "<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
       << "<Grid Name=\"" << (cells.name == std::string_view("region") ? "mesh" : cells.name)
       << "\" GridType=\"Uniform\">\n<Topology TopologyType=\"" << cells.topology << "\" NumberOfElements=\"" << n
       << "\" NodesPerElement=\"" << cells.width << "\">" << data_item(at + "/topology", n, cells.width, "Int")
       << "</Topology>\n<Geometry GeometryType=\"XYZ\">"
       << "<DataItem Dimensions=\"" << n_nodes << " 3\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">" << h5
       << ":/geometry</DataItem></Geometry>\n<Attribute Name=\"" << cells.name
       << "\" AttributeType=\"Scalar\" Center=\"Cell\">" << data_item(at + "/values", n, 1, "Int")
       << "</Attribute>\n</Grid>\n</Domain>\n</Xdmf>\n";
  return text.text();
}

/// Each XDMF file has an HDF5 file with the same name that contains the points, because dolfinx opens that file,
/// whatever the XDMF says.
void write_h5(const SolverMesh& mesh, const TaggedCells& cells, const std::filesystem::path& file) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    Hdf5Writer h5(
        temporary, file,
        3 * mesh.n_nodes() * sizeof(double) + cells.n * (cells.width * sizeof(std::int64_t) + sizeof(std::int32_t)));
    std::vector<double> coordinates;
    coordinates.reserve(3 * mesh.n_nodes());
    for (std::size_t v = 0; v < mesh.n_nodes(); ++v)
      for (std::size_t k = 0; k < 3; ++k) coordinates.push_back(mesh.node(v)[k]);
    h5.put("geometry", H5T_NATIVE_DOUBLE, coordinates.data(), mesh.n_nodes(), 3);
    h5.group(cells.name);
    const std::string at = cells.name;
    h5.put_pieces((at + "/topology").c_str(), H5T_NATIVE_INT64, cells.n, cells.width, [&](const auto& write) {
      for (const auto& [block, tag] : cells.blocks)
        if (block->n_cells() > 0) write(H5T_NATIVE_UINT32, block->nodes.data(), block->n_cells());
    });
    h5.put_pieces((at + "/values").c_str(), H5T_NATIVE_INT32, cells.n, 1, [&](const auto& write) {
      for (const auto& [block, tag] : cells.blocks) {
        const std::vector<std::int32_t> tags(std::min(block->n_cells(), tags_at_once), tag);
        for (std::size_t c = 0; c < block->n_cells(); c += tags.size())
          write(H5T_NATIVE_INT32, tags.data(), std::min(tags.size(), block->n_cells() - c));
      }
    });
    h5.close();
  });
}

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  WriteOptions one_tag = options;
  if (one_tag.groups == GroupChoice::both) one_tag.groups = GroupChoice::whole;  // an XDMF cell has only one number
  const SolverMesh mesh = make_solver_mesh(model, one_tag);
  std::vector<TaggedCells> all;
  for (const int dimension : {3, 2, 1}) {
    all.push_back(cells_of(mesh, dimension));
    if (all.back().n == 0) all.pop_back();
  }
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& label : mesh.labels)
    if (label.dimension > 0)
      sidecar.push_back({"tag", label.dimension, label.id, label.full_name, label.full_name, label.members});
  WrittenFiles written;
  for (const TaggedCells& cells : all) {
    const std::string part = stem.string() + (cells.name == std::string_view("region")       ? ""
                                              : cells.name == std::string_view("facet_tags") ? ".facets"
                                                                                             : ".edges");
    const std::filesystem::path h5 = part + ".h5";
    write_h5(mesh, cells, h5);
    written.add(h5);
    write_text_file(part + ".xdmf", grid_text(h5.filename().string(), cells, mesh.n_nodes()));
    written.add(part + ".xdmf");
  }
  written.add(write_sidecar(model, sidecar, stem.string() + ".xdmf"));
  return written.keep();
}

}  // namespace

}  // namespace geomesh::geomodel

GEOMESH_FORMAT_MODULE(geomesh::geomodel::write, nullptr, nullptr)

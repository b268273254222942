// SPDX-License-Identifier: GPL-3.0-or-later
// XDMF 3 with HDF5, for dolfinx, FEniCS, meshio and ParaView (built only where HDF5 is there): NAME.xdmf has the cells
// with their region, NAME.facets.xdmf and NAME.edges.xdmf the tagged faces and edges on the same points. Numbers are in
// an .h5 of the same name. One grid a file, because meshio reads no more.
#include <hdf5.h>

#include <algorithm>

#include "formats/modules/format_module.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/room_on_disk.hpp"
#include "writers/text_buffer.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// An HDF5 file being written. Every failure of the library is a failure to write the file.
class Hdf5Writer {
 public:
  /// `payload`: bytes of all numbers.
  Hdf5Writer(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t payload)
      : file_(file) {
    constexpr std::size_t most_bytes_of_structure = 1 << 15;
    require_room(temporary, file, payload + most_bytes_of_structure);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    id_ = require(H5Fcreate(temporary.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  }
  ~Hdf5Writer() {
    if (id_ >= 0) H5Fclose(id_);
  }
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Rows of `width` numbers.
  void put(const char* name, hid_t type, const void* data, std::size_t n, std::size_t width) {
    put_pieces(name, type, n, width, [&](const auto& write) {
      if (n > 0) write(type, data, n);
    });
  }
  /// The same piece by piece: `give` calls what it is handed with the type in memory, a row and how many rows.
  template <class Give>
  void put_pieces(const char* name, hid_t type, std::size_t n, std::size_t width, const Give& give) {
    const std::array<hsize_t, 2> sizes{n, width};
    const int rank = width == 1 ? 1 : 2;
    const hid_t space = require(H5Screate_simple(rank, sizes.data(), nullptr));
    const hid_t no_times = require(H5Pcreate(H5P_DATASET_CREATE));  // the same bytes whenever it is written
    require(H5Pset_obj_track_times(no_times, false));
    const hid_t set = require(H5Dcreate2(id_, name, type, space, H5P_DEFAULT, no_times, H5P_DEFAULT));
    require(H5Pclose(no_times));
    hsize_t first = 0;
    give([&](hid_t in_memory, const void* data, std::size_t n_rows) {
      const std::array<hsize_t, 2> start{first, 0}, count{n_rows, width};
      require(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
      const hid_t piece = require(H5Screate_simple(rank, count.data(), nullptr));
      require(H5Dwrite(set, in_memory, piece, space, H5P_DEFAULT, data));
      require(H5Sclose(piece));
      first += n_rows;
    });
    require(H5Dclose(set));
    require(H5Sclose(space));
  }
  void group(const char* name) {
    require(H5Gclose(require(H5Gcreate2(id_, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT))));
  }
  void close() {
    const herr_t status = H5Fclose(id_);
    id_ = -1;
    require(status);
  }

 private:
  template <class T>
  T require(T status) const {
    if (status < 0) refuse_to_write(file_);
    return status;
  }
  const std::filesystem::path& file_;
  hid_t id_ = -1;
};

constexpr std::size_t tags_at_once = 1 << 16;

/// Cells of one dimension with the number of their label.
struct TaggedCells {
  const char* topology;
  const char* name;  ///< of the grid and of the attribute
  std::size_t width, n;
  std::vector<std::pair<const CellBlock*, std::int32_t>> blocks;  ///< with the number
};

/// XDMF orders the midpoints of a tetrahedron as VTK does.
TaggedCells cells_of(const SolverMesh& mesh, int dimension) {
  const bool second = mesh.second_order();
  TaggedCells cells = dimension == 3   ? TaggedCells{second ? "Tetrahedron_10" : "Tetrahedron", "region", 0, 0, {}}
                      : dimension == 2 ? TaggedCells{second ? "Triangle_6" : "Triangle", "facet_tags", 0, 0, {}}
                                       : TaggedCells{second ? "Edge_3" : "PolyLine", "edge_tags", 0, 0, {}};
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

/// Each XDMF file has an HDF5 file of its own name, with the points: dolfinx opens that one, whatever the XDMF says.
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
  if (one_tag.groups == GroupChoice::both) one_tag.groups = GroupChoice::whole;  // a cell has one number
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

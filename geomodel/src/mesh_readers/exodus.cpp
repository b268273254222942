// SPDX-License-Identifier: GPL-3.0-or-later
// Exodus II by the library of Sandia (VTK::exodusII): blocks of tetrahedra, side sets, node sets.
#include <vtk_exodusII.h>

#include <cctype>
#include <fstream>
#include <limits>

#include "geomesh/core/error.hpp"
#include "mesh_readers/exodus_parts.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {
namespace {

/// Corners of the sides 1 to 4 of a tetrahedron.
constexpr std::size_t corners_of_side[4][3] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}};

class ExodusReader {
 public:
  explicit ExodusReader(const std::filesystem::path& path) : path_(path) {
    if (!std::ifstream(path)) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
    ex_opts(0);
    int word = 8, stored = 0;
    float version = 0;
    id_ = ex_open(path.c_str(), EX_READ, &word, &stored, &version);
    if (id_ < 0) refuse("it is no Exodus file, or damaged");
    ex_set_int64_status(id_, 0);
    ex_set_max_name_length(id_, 256);
    mesh_.single_precision = stored == 4;
  }
  ~ExodusReader() { ex_close(id_); }
  ExodusReader(const ExodusReader&) = delete;
  ExodusReader& operator=(const ExodusReader&) = delete;

  ExodusPartMesh read_part() {
    ExodusPartMesh part{read(), {}, {}};
    part.nodes.resize(part.mesh.points.size());
    std::vector<int> elements(row_of_element_.size());
    if (!part.nodes.empty()) require(ex_get_id_map(id_, EX_NODE_MAP, part.nodes.data()));
    if (!elements.empty()) require(ex_get_id_map(id_, EX_ELEM_MAP, elements.data()));
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (row_of_element_[e] != SIZE_MAX) part.tetrahedra.push_back(elements[e]);
    return part;
  }
  RawMesh read() {
    mesh_.format = "Exodus II";
    ex_init_params sizes{};
    require(ex_get_init_ext(id_, &sizes));
    if (sizes.num_dim != 3) refuse("it has " + std::to_string(sizes.num_dim) + " dimensions; 3 are read");
    read_points(possible(sizes.num_nodes));
    read_blocks(possible(sizes.num_elem_blk), possible(sizes.num_elem));
    read_sets(EX_SIDE_SET, possible(sizes.num_side_sets));
    read_sets(EX_NODE_SET, possible(sizes.num_node_sets));
    if (ex_inquire_int(id_, EX_INQ_TIME) > 0) {
      read_cell_arrays();
      read_point_arrays();
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::invalid_input, path_.string() + ": " + why);
  }
  /// Refuses more numbers than the file can hold, compressed as they may be (deflate: 1032 to 1).
  std::size_t possible(std::int64_t n) const {
    if (n < 0 || static_cast<std::uintmax_t>(n) / 1032 > std::filesystem::file_size(path_))
      refuse("sizes in it are not those of what follows: it is damaged");
    return static_cast<std::size_t>(n);
  }
  void require(int status) const {
    if (status < 0) refuse("the Exodus library cannot read it: it is damaged");
  }
  void read_points(std::size_t n) {
    std::vector<double> x(n), y(n), z(n);
    require(ex_get_coord(id_, x.data(), y.data(), z.data()));
    for (std::size_t i = 0; i < n; ++i) mesh_.points.push_back({x[i], y[i], z[i]});
  }
  std::vector<int> ids_of(ex_entity_type kind, std::size_t n) const {
    std::vector<int> ids(n);
    if (n > 0) require(ex_get_ids(id_, kind, ids.data()));
    return ids;
  }
  std::string name_of(ex_entity_type kind, int id) const {
    std::string name(257, '\0');
    if (ex_get_name(id_, kind, id, name.data()) < 0) return "";
    return name.c_str();
  }
  std::vector<std::string> variables(ex_entity_type kind) const {
    int n = 0;
    require(ex_get_variable_param(id_, kind, &n));
    std::vector<std::string> names;
    for (int i = 1; i <= n; ++i) {
      std::string name(257, '\0');
      require(ex_get_variable_name(id_, kind, i, name.data()));
      names.emplace_back(name.c_str());
    }
    return names;
  }
  /// Of the first time. NaN where a block has no such variable.
  void read_cell_arrays() {
    const std::vector<std::string> names = variables(EX_ELEM_BLOCK);
    for (std::size_t i = 0; i < names.size(); ++i) {
      CellArray array{names[i], std::vector<double>(mesh_.cells[3].size(), std::numeric_limits<double>::quiet_NaN())};
      for (const auto& [id, rows] : rows_of_block_) {
        std::vector<double> values(rows.size());
        if (values.empty() || ex_get_var(id_, 1, EX_ELEM_BLOCK, static_cast<int>(i + 1), id,
                                         static_cast<int64_t>(values.size()), values.data()) < 0)
          continue;
        for (std::size_t e = 0; e < rows.size(); ++e) array.values[rows[e]] = values[e];
      }
      mesh_.cell_arrays.push_back(std::move(array));
    }
  }
  void read_point_arrays() {
    const std::vector<std::string> names = variables(EX_NODAL);
    for (std::size_t i = 0; i < names.size(); ++i) {
      PointArray array{names[i], std::vector<double>(mesh_.points.size())};
      require(ex_get_var(id_, 1, EX_NODAL, static_cast<int>(i + 1), 1, static_cast<int64_t>(array.values.size()),
                         array.values.data()));
      mesh_.point_arrays.push_back(std::move(array));
    }
  }
  VertexIndex node(int number) const {
    if (number < 1 || static_cast<std::size_t>(number) > mesh_.points.size())
      refuse("node " + std::to_string(number) + " is not there");
    return static_cast<VertexIndex>(number - 1);
  }
  void read_blocks(std::size_t n, std::size_t n_elements) {
    row_of_element_.assign(n_elements, SIZE_MAX);
    std::size_t element = 0;
    for (const int id : ids_of(EX_ELEM_BLOCK, n)) {
      ex_block block{};
      block.id = id;
      block.type = EX_ELEM_BLOCK;
      require(ex_get_block_param(id_, &block));
      std::string topology = block.topology;
      for (char& c : topology) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      const auto entries = possible(block.num_entry), width = static_cast<std::size_t>(block.num_nodes_per_entry);
      if (!topology.starts_with("TET") || (width != 4 && width != 10)) {
        mesh_.n_other_solids += entries;
        element += entries;
        continue;
      }
      mesh_.second_order |= width == 10;
      std::vector<int> nodes(entries * width);
      if (entries > 0) require(ex_get_conn(id_, EX_ELEM_BLOCK, id, nodes.data(), nullptr, nullptr));
      RawSet set{name_of(EX_ELEM_BLOCK, id), id, 3, {}};
      for (std::size_t e = 0; e < entries; ++e, ++element) {
        for (std::size_t i = 0; i < 4; ++i) mesh_.cells[3].corners.push_back(node(nodes[e * width + i]));
        for (std::size_t i = 4; i < width; ++i) mesh_.midpoints.push_back(node(nodes[e * width + i]));
        if (element >= n_elements) refuse("its blocks hold more elements than it says");
        row_of_element_[element] = mesh_.cells[3].size() - 1;
        set.rows.push_back(mesh_.cells[3].size() - 1);
        mesh_.numbers.push_back(element);
      }
      rows_of_block_.emplace_back(id, set.rows);
      mesh_.sets.push_back(std::move(set));
    }
  }
  void read_sets(ex_entity_type kind, std::size_t n) {
    for (const int id : ids_of(kind, n)) {
      int n_entries = 0, n_factors = 0;
      require(ex_get_set_param(id_, kind, id, &n_entries, &n_factors));
      std::vector<int> entries(possible(n_entries)), sides(entries.size());
      if (n_entries > 0)
        require(ex_get_set(id_, kind, id, entries.data(), kind == EX_SIDE_SET ? sides.data() : nullptr));
      RawSet set{name_of(kind, id), id, kind == EX_SIDE_SET ? 2 : -1, {}};
      for (std::size_t i = 0; i < entries.size(); ++i) {
        if (kind == EX_NODE_SET) {
          set.rows.push_back(node(entries[i]));
        } else if (const std::size_t row = tetrahedron(entries[i]); row != SIZE_MAX) {
          add_side(row, sides[i], set);
        }
      }
      mesh_.sets.push_back(std::move(set));
    }
  }
  std::size_t tetrahedron(int element) const {
    if (element < 1 || static_cast<std::size_t>(element) > row_of_element_.size())
      refuse("element " + std::to_string(element) + " of a side set is not there");
    return row_of_element_[static_cast<std::size_t>(element - 1)];
  }
  void add_side(std::size_t row, int side, RawSet& set) {
    if (side < 1 || side > 4) refuse("a tetrahedron has no side " + std::to_string(side));
    for (const std::size_t i : corners_of_side[side - 1])
      mesh_.cells[2].corners.push_back(mesh_.cells[3].corners[4 * row + i]);
    set.rows.push_back(mesh_.cells[2].size() - 1);
  }

  std::filesystem::path path_;
  RawMesh mesh_;
  int id_ = -1;
  std::vector<std::size_t> row_of_element_;
  std::vector<std::pair<int, std::vector<std::size_t>>> rows_of_block_;  // of tetrahedra
};

}  // namespace

RawMesh read_exodus_mesh(const std::filesystem::path& file) {
  const auto files = exodus_part_files(file);
  if (!files) return ExodusReader(file).read();
  std::vector<ExodusPartMesh> parts;
  for (const std::filesystem::path& part : files->parts) parts.push_back(ExodusReader(part).read_part());
  return merge_exodus_parts(std::move(parts), files->whole);
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Exodus II, which is a layout of netCDF: blocks of tetrahedra, side sets, node sets, fields of the first time.
// Source: Schoof and Yarberry, "EXODUS II: a finite element data model" (SAND92-2137).
#include <cctype>
#include <limits>
#include <numeric>

#include "mesh_readers/exodus_parts.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "mesh_readers/netcdf/netcdf_reader.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t corners_of_side[4][3] = {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}};

class ExodusReader {
 public:
  explicit ExodusReader(const std::filesystem::path& path) : file_(path) {}

  ExodusPartMesh read_part() {
    ExodusPartMesh part{read(), {}, {}};
    part.nodes = numbers_in_whole("node_num_map", part.mesh.points.size());
    const std::vector<int> elements = numbers_in_whole("elem_num_map", row_of_element_.size());
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (row_of_element_[e] != SIZE_MAX) part.tetrahedra.push_back(elements[e]);
    return part;
  }
  RawMesh read() {
    mesh_.format = "Exodus II";
    if (const std::size_t n = file_.dimension("num_dim"); n != 3)
      file_.refuse("it has " + std::to_string(n) + " dimensions; 3 are read");
    read_points();
    read_blocks();
    read_sets("ss", file_.dimension("num_side_sets"));
    read_sets("ns", file_.dimension("num_node_sets"));
    if (file_.dimension("time_step") > 0) {
      read_cell_arrays();
      read_point_arrays();
    }
    return std::move(mesh_);
  }

 private:
  /// Returns the numbers of the Exodus file's nodes or elements in the whole mesh; numbers from 1 on if it has none.
  std::vector<int> numbers_in_whole(const char* variable, std::size_t n) const {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 1);
    if (!file_.has(variable)) return numbers;
    const std::vector<std::int64_t> given = file_.integers(variable, n);
    for (std::size_t i = 0; i < n; ++i) numbers[i] = number(given[i]);
    return numbers;
  }
  int number(std::int64_t value) const {
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
      file_.refuse("it holds the number " + std::to_string(value) + ", which is more than 32 bits can count");
    return static_cast<int>(value);
  }

  /// Reads the points of an Exodus file from one variable for each axis, or from a single one in files before 1996.
  void read_points() {
    const std::size_t n = file_.dimension("num_nodes");
    if (n >= no_vertex) file_.refuse("it holds more nodes than 32 bits can count");
    if (n == 0) return;
    if (file_.has("coord")) {
      const std::vector<double> all = file_.doubles("coord", 3 * n);
      for (std::size_t i = 0; i < n; ++i) mesh_.points.push_back({all[i], all[n + i], all[2 * n + i]});
      mesh_.single_precision = file_.is_single_precision("coord");
      return;
    }
    const std::vector<double> x = file_.doubles("coordx", n), y = file_.doubles("coordy", n),
                              z = file_.doubles("coordz", n);
    for (std::size_t i = 0; i < n; ++i) mesh_.points.push_back({x[i], y[i], z[i]});
    mesh_.single_precision = file_.is_single_precision("coordx");
  }
  VertexIndex node(std::int64_t number) const {
    if (number < 1 || static_cast<std::size_t>(number) > mesh_.points.size())
      file_.refuse("node " + std::to_string(number) + " is not there");
    return static_cast<VertexIndex>(number - 1);
  }
  /// Returns the ids of an Exodus file's element blocks, side sets or node sets; numbers from 1 on if it has none.
  std::vector<int> ids_of(const std::string& kind, std::size_t n) const {
    return numbers_in_whole((kind + "_prop1").c_str(), n);
  }

  void read_blocks() {
    const std::size_t n_elements = file_.dimension("num_elem"), n = file_.dimension("num_el_blk");
    row_of_element_.assign(n_elements, SIZE_MAX);
    const std::vector<int> ids = ids_of("eb", n);
    const std::vector<std::string> names = file_.texts("eb_names", n);
    std::size_t element = 0;
    for (std::size_t b = 0; b < n; ++b) {
      const std::string own = std::to_string(b + 1);
      const std::size_t entries = file_.dimension("num_el_in_blk" + own),
                        width = file_.dimension("num_nod_per_el" + own);
      if (entries > n_elements - element) file_.refuse("its blocks hold more elements than it says");
      std::string topology = file_.attribute("connect" + own, "elem_type");
      for (char& c : topology) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      if (entries > 0 && (!topology.starts_with("TET") || (width != 4 && width != 10))) {
        mesh_.n_other_solids += entries;
        element += entries;
        rows_of_block_.emplace_back();
        continue;
      }
      read_block({names[b], ids[b], 3, {}}, own, element, entries * width);
      element += entries;
    }
  }
  void read_block(RawSet set, const std::string& own, std::size_t element, std::size_t n_nodes) {
    const std::size_t entries = file_.dimension("num_el_in_blk" + own);
    const std::size_t width = entries == 0 ? 4 : n_nodes / entries;
    mesh_.second_order |= width == 10;
    const std::vector<std::int64_t> nodes = file_.integers("connect" + own, n_nodes);
    for (std::size_t e = 0; e < entries; ++e, ++element) {
      for (std::size_t i = 0; i < 4; ++i) mesh_.cells[3].corners.push_back(node(nodes[e * width + i]));
      for (std::size_t i = 4; i < width; ++i) mesh_.midpoints.push_back(node(nodes[e * width + i]));
      row_of_element_[element] = mesh_.cells[3].size() - 1;
      set.rows.push_back(mesh_.cells[3].size() - 1);
      mesh_.numbers.push_back(element);
    }
    rows_of_block_.push_back(set.rows);
    mesh_.sets.push_back(std::move(set));
  }

  void read_sets(const std::string& kind, std::size_t n) {
    const bool of_sides = kind == "ss";
    const std::vector<int> ids = ids_of(kind, n);
    const std::vector<std::string> names = file_.texts(kind + "_names", n);
    for (std::size_t s = 0; s < n; ++s) {
      const std::string own = std::to_string(s + 1);
      const std::size_t entries = file_.dimension((of_sides ? "num_side_ss" : "num_nod_ns") + own);
      RawSet set{names[s], ids[s], of_sides ? 2 : -1, {}};
      if (of_sides) {
        const auto elements = file_.integers("elem_ss" + own, entries),
                   sides = file_.integers("side_ss" + own, entries);
        for (std::size_t i = 0; i < entries; ++i)
          if (const std::size_t row = tetrahedron(elements[i]); row != SIZE_MAX) add_side(row, sides[i], set);
      } else {
        for (const std::int64_t v : file_.integers("node_ns" + own, entries)) set.rows.push_back(node(v));
      }
      mesh_.sets.push_back(std::move(set));
    }
  }
  std::size_t tetrahedron(std::int64_t element) const {
    if (element < 1 || static_cast<std::size_t>(element) > row_of_element_.size())
      file_.refuse("element " + std::to_string(element) + " of a side set is not there");
    return row_of_element_[static_cast<std::size_t>(element - 1)];
  }
  void add_side(std::size_t row, std::int64_t side, RawSet& set) {
    if (side < 1 || side > 4) file_.refuse("a tetrahedron has no side " + std::to_string(side));
    for (const std::size_t i : corners_of_side[side - 1])
      mesh_.cells[2].corners.push_back(mesh_.cells[3].corners[4 * row + i]);
    set.rows.push_back(mesh_.cells[2].size() - 1);
  }

  /// Reads the cell arrays of an Exodus file's first time step. Cells of a block without a variable get NaN for it.
  void read_cell_arrays() {
    const std::size_t n = file_.dimension("num_elem_var");
    const std::vector<std::string> names = file_.texts("name_elem_var", n);
    for (std::size_t i = 0; i < n; ++i) {
      CellArray array{names[i], std::vector<double>(mesh_.cells[3].size(), std::numeric_limits<double>::quiet_NaN())};
      for (std::size_t b = 0; b < rows_of_block_.size(); ++b) {
        const std::vector<std::size_t>& rows = rows_of_block_[b];
        const std::string variable = "vals_elem_var" + std::to_string(i + 1) + "eb" + std::to_string(b + 1);
        if (rows.empty() || !file_.has(variable)) continue;
        const std::vector<double> values = file_.doubles(variable, rows.size());
        for (std::size_t e = 0; e < rows.size(); ++e) array.values[rows[e]] = values[e];
      }
      mesh_.cell_arrays.push_back(std::move(array));
    }
  }
  /// Reads the point arrays of an Exodus file: each from its own variable, or all from one in files before 1996.
  void read_point_arrays() {
    const std::size_t n = file_.dimension("num_nod_var"), n_points = mesh_.points.size();
    const std::vector<std::string> names = file_.texts("name_nod_var", n);
    std::vector<double> all;
    if (file_.has("vals_nod_var")) all = file_.doubles("vals_nod_var", n * n_points);
    for (std::size_t i = 0; i < n; ++i) {
      if (all.empty()) {
        mesh_.point_arrays.push_back({names[i], file_.doubles("vals_nod_var" + std::to_string(i + 1), n_points)});
      } else {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i * n_points);
        mesh_.point_arrays.push_back({names[i], {begin, begin + static_cast<std::ptrdiff_t>(n_points)}});
      }
    }
  }

  NetcdfReader file_;
  RawMesh mesh_;
  std::vector<std::size_t> row_of_element_;
  // Rows of the tetrahedra in each block of elements; empty for blocks of other elements.
  std::vector<std::vector<std::size_t>> rows_of_block_;
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Gmsh .msh, versions 2.2 and 4.1, text and binary: nodes, simplices of first and second order, physical groups.
#include <cstdlib>
#include <limits>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "mesh_readers/file_cursor.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

struct ElementType {
  int dimension;
  std::size_t n_nodes;
  bool simplex;
};
std::optional<ElementType> element_type(int type) {
  switch (type) {
    case 15:
      return ElementType{0, 1, true};
    case 1:
      return ElementType{1, 2, true};
    case 8:
      return ElementType{1, 3, true};
    case 2:
      return ElementType{2, 3, true};
    case 9:
      return ElementType{2, 6, true};
    case 4:
      return ElementType{3, 4, true};
    case 11:
      return ElementType{3, 10, true};
    case 3:
      return ElementType{2, 4, false};
    case 5:
      return ElementType{3, 8, false};
    case 6:
      return ElementType{3, 6, false};
    case 7:
      return ElementType{3, 5, false};
    case 10:
      return ElementType{2, 9, false};
    case 12:
      return ElementType{3, 27, false};
    case 13:
      return ElementType{3, 18, false};
    case 14:
      return ElementType{3, 14, false};
    case 16:
      return ElementType{2, 8, false};
    case 17:
      return ElementType{3, 20, false};
    case 18:
      return ElementType{3, 15, false};
    case 19:
      return ElementType{3, 13, false};
    default:
      return std::nullopt;
  }
}

/// Returns a tag without its sign, by which Gmsh marks reversed elements and ghosts. The least number has no positive
/// counterpart and is returned unchanged.
std::int32_t without_sign(std::int32_t tag) {
  return tag < 0 && tag != std::numeric_limits<std::int32_t>::min() ? -tag : tag;
}

class GmshReader {
 public:
  explicit GmshReader(const std::filesystem::path& path) : in_(path), budget_(in_.size()) {}

  RawMesh read() {
    const std::filesystem::path file = in_.path();
    mesh_.format = "Gmsh";
    read_sections();
    read_other_parts(file);
    // Arrays are filled up with NaN, because a Gmsh file may have data before the elements and nodes to which they
    // belong, or in only some parts of the mesh.
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (CellArray& array : mesh_.cell_arrays) array.values.resize(mesh_.cells[3].size(), none);
    for (PointArray& array : mesh_.point_arrays) array.values.resize(mesh_.points.size(), none);
    for (auto& [key, set] : sets_)
      if (!set.rows.empty()) mesh_.sets.push_back(std::move(set));
    return std::move(mesh_);
  }

 private:
  void read_sections() {
    version_ = 0;
    while (!in_.at_end()) {
      const std::string_view section = in_.line();
      if (section == "$MeshFormat") {
        read_format();
      } else if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$PartitionedEntities") {
        read_partitioned_entities();
      } else if (section == "$Nodes") {
        require_format();
        version_ < 4 ? read_nodes_2() : read_nodes_4();
      } else if (section == "$Elements") {
        require_format();
        version_ < 4 ? read_elements_2() : read_elements_4();
      } else if (section == "$ElementData" || section == "$NodeData") {
        require_format();
        read_data(section == "$NodeData");
      }
    }
    require_format();
  }
  /// Reads NAME_1.msh, NAME_2.msh ... as one mesh if one of these files declares that it is a part. Items that occur in
  /// several parts are recognised by their number.
  void read_other_parts(const std::filesystem::path& file) {
    const std::string name = file.stem().string();
    const std::string number(digits_at_end(name));
    constexpr std::size_t most_digits = 6;
    if (n_parts_ < 2 || file.extension() != ".msh" || number.empty() || number.size() > most_digits) return;
    if (name.size() < number.size() + 2 || name[name.size() - number.size() - 1] != '_') return;
    const std::filesystem::path stem = file.parent_path() / name.substr(0, name.size() - number.size() - 1);
    mesh_.whole = stem.string() + ".msh";
    mesh_.format = "Gmsh in parts";
    known_elements_.insert(element_numbers_.begin(), element_numbers_.end());
    is_later_part_ = true;
    for (std::int32_t k = 1; k <= n_parts_; ++k) {
      if (k == std::stoi(number)) continue;
      in_ = FileCursor(stem.string() + "_" + std::to_string(k) + ".msh");
      budget_.grow(in_.size());
      read_sections();
    }
  }
  void require_format() const {
    if (version_ == 0) in_.refuse("no $MeshFormat: not a Gmsh file");
  }
  std::int32_t integer() { return binary_ ? in_.raw<std::int32_t>() : in_.number<std::int32_t>(); }
  std::size_t size() { return binary_ ? in_.raw<std::uint64_t>() : in_.number<std::uint64_t>(); }
  double real() { return binary_ ? in_.raw<double>() : in_.number<double>(); }

  void read_format() {
    version_ = in_.number<double>();
    binary_ = in_.number<int>() != 0;
    const auto bytes = in_.number<int>();
    in_.line();
    if (version_ != 2.2 && version_ != 2.1 && version_ != 2 && version_ != 4.1)
      in_.refuse("Gmsh files of this version are not read; save as version 4.1 or 2.2");
    if (!binary_) return;
    if (bytes != 8) in_.refuse("numbers are not of 8 bytes");
    if (in_.raw<std::int32_t>() != 1)
      in_.refuse("binary numbers of another machine's byte order are not read; save as ASCII");
  }
  void read_names() {
    const auto n = in_.number<std::size_t>();
    in_.line();
    for (std::size_t i = 0; i < n; ++i) {
      const int dimension = in_.number<int>();
      const auto id = in_.number<std::int32_t>();
      const std::string_view rest = in_.line();
      const auto first = rest.find('"'), last = rest.rfind('"');
      if (first != std::string_view::npos && last > first)
        set_of(dimension, id).name = rest.substr(first + 1, last - first - 1);
    }
  }
  RawSet& set_of(int dimension, std::int32_t id) {
    RawSet& set = sets_[{dimension, id}];
    set.id = id;
    set.dimension = dimension;
    return set;
  }
  void read_entities() {
    std::array<std::size_t, 4> n{};
    for (auto& count : n) count = size();
    for (int d = 0; d < 4; ++d)
      for (std::size_t i = 0; i < n[static_cast<std::size_t>(d)]; ++i) {
        const std::int32_t tag = integer();
        for (int k = 0; k < (d == 0 ? 3 : 6); ++k) real();
        std::vector<std::int32_t>& groups = groups_of_[{d, tag}];
        for (std::size_t k = size(); k > 0; --k) groups.push_back(integer());
        if (d > 0)
          for (std::size_t k = size(); k > 0; --k) integer();
      }
  }
  /// Reads the Gmsh entities of one part with the groups of their parents, and those with copies of other parts'
  /// elements.
  void read_partitioned_entities() {
    n_parts_ = std::max(n_parts_, static_cast<std::int32_t>(std::min<std::size_t>(size(), most_parts)));
    for (std::size_t k = size(); k > 0; --k) {
      ghosts_.insert(integer());
      integer();
    }
    std::size_t n[4];
    for (std::size_t& count : n) count = size();
    for (int d = 0; d < 4; ++d)
      for (std::size_t i = 0; i < n[d]; ++i) {
        const std::int32_t tag = integer();
        integer();
        integer();
        for (std::size_t k = size(); k > 0; --k) integer();
        for (int k = 0; k < (d == 0 ? 3 : 6); ++k) real();
        std::vector<std::int32_t>& groups = groups_of_[{d, tag}];
        groups.clear();
        for (std::size_t k = size(); k > 0; --k) groups.push_back(integer());
        if (d > 0)
          for (std::size_t k = size(); k > 0; --k) integer();
      }
  }
  void add_point(std::size_t number, const Vec3& p) {
    if (is_later_part_ && nodes_.knows(number)) {
      if (!(mesh_.points[nodes_.row(number, in_)] == p))
        in_.refuse("node " + std::to_string(number) + " has another place in another part");
      return;
    }
    nodes_.add(number, in_);
    mesh_.points.push_back(p);
  }
  void read_nodes_2() {
    const auto n = in_.number<std::size_t>();
    in_.line();
    for (std::size_t i = 0; i < n; ++i) {
      const auto number = static_cast<std::size_t>(integer());
      const double x = real(), y = real(), z = real();
      add_point(number, {x, y, z});
    }
  }
  void read_nodes_4() {
    const std::size_t blocks = size();
    for (int k = 0; k < 3; ++k) size();
    for (std::size_t b = 0; b < blocks; ++b) {
      const int dimension = integer();
      integer();
      const bool parametric = integer() != 0;
      const std::size_t n = size();
      std::vector<std::size_t> numbers;
      for (std::size_t i = 0; i < n; ++i) numbers.push_back(size());
      for (const std::size_t number : numbers) {
        const double x = real(), y = real(), z = real();
        if (parametric)
          for (int k = 0; k < dimension; ++k) real();
        add_point(number, {x, y, z});
      }
    }
  }

  /// Reads one element of a Gmsh file, whose nodes `node()` returns in order, and adds it to its physical groups.
  template <class F>
  void add_element(std::size_t tag, int type, const std::vector<std::int32_t>& groups, F&& node) {
    const std::optional<ElementType> known = element_type(type);
    if (!known) in_.refuse("elements of Gmsh's type " + std::to_string(type) + " are not known here");
    if (is_later_part_ && !known_elements_.insert(tag).second) {
      for (std::size_t i = 0; i < known->n_nodes; ++i) node();
      return;
    }
    if (!is_later_part_) element_numbers_.push_back(tag);
    const std::size_t number = n_elements_++;
    RawCells& cells = mesh_.cells[static_cast<std::size_t>(known->dimension)];
    for (std::size_t i = 0; i < known->n_nodes; ++i) {
      const VertexIndex row = nodes_.row(node(), in_);
      if (known->simplex && i < cells.n_corners) cells.corners.push_back(row);
      if (type == 11 && i >= 4) mesh_.midpoints.push_back(row);
    }
    if (type == 11) std::swap(mesh_.midpoints.end()[-1], mesh_.midpoints.end()[-2]);
    if (!known->simplex) {
      mesh_.n_other_solids += known->dimension == 3;
      return;
    }
    if (known->dimension == 3) {
      mesh_.numbers.push_back(number);
      row_of_element_.emplace(tag, cells.size() - 1);
      mesh_.second_order |= type == 11;
    }
    if (!budget_.take(groups.size())) in_.refuse(SetBudget::message);
    for (const std::int32_t id : groups)
      if (id != 0) set_of(known->dimension, without_sign(id)).rows.push_back(cells.size() - 1);
  }
  void pass_over_elements(int type, std::size_t n) {
    const std::optional<ElementType> known = element_type(type);
    if (!known) in_.refuse("elements of Gmsh's type " + std::to_string(type) + " are not known here");
    for (std::size_t i = 0; i < n * (known->n_nodes + 1); ++i) size();
  }
  void read_elements_2() {
    const auto n = in_.number<std::size_t>();
    in_.line();
    for (std::size_t done = 0; done < n;) {
      std::int32_t type = 0, n_tags = 0, follow = 1, first = 0;
      if (binary_) {
        type = integer();
        follow = integer();
        n_tags = integer();
        if (follow <= 0) in_.refuse("a block of elements is empty");
      }
      for (std::int32_t i = 0; i < follow; ++i, ++done) {
        const auto number = static_cast<std::size_t>(integer());
        if (!binary_) {
          type = integer();
          n_tags = integer();
        }
        for (std::int32_t k = 0; k < n_tags; ++k) {
          const std::int32_t tag = integer();
          if (k == 0) first = tag;
          if (k >= 3) n_parts_ = std::max(n_parts_, std::min(without_sign(tag), std::int32_t{most_parts}));
        }
        add_element(number, type, {n_tags > 0 ? first : 0}, [&] { return static_cast<std::size_t>(integer()); });
      }
    }
  }
  void read_elements_4() {
    const std::size_t blocks = size();
    for (int k = 0; k < 3; ++k) size();
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int32_t dimension = integer(), entity = integer(), type = integer();
      const std::size_t n = size();
      const auto groups = groups_of_.find({dimension, entity});
      static const std::vector<std::int32_t> none;
      if (dimension == 3 && ghosts_.contains(entity)) {
        pass_over_elements(type, n);
        continue;
      }
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t number = size();
        add_element(number, type, groups == groups_of_.end() ? none : groups->second, [&] { return size(); });
      }
    }
  }

  /// Reads Gmsh data with one value for each node or element (NaN where there is none), and ignores other data.
  void read_data(bool of_nodes) {
    std::string name;
    const auto n_texts = in_.number<std::size_t>();
    in_.line();
    for (std::size_t i = 0; i < n_texts; ++i) {
      const std::string_view text = in_.line();
      const auto first = text.find('"'), last = text.rfind('"');
      if (i == 0 && first != std::string_view::npos && last > first) name = text.substr(first + 1, last - first - 1);
    }
    for (auto n = in_.number<std::size_t>(); n > 0; --n) in_.number<double>();
    std::vector<std::int64_t> tags(in_.number<std::size_t>() % 64);
    for (auto& tag : tags) tag = in_.number<std::int64_t>();
    in_.line();
    if (tags.size() < 3 || tags[1] != 1 || tags[2] < 0) return;
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values(of_nodes ? mesh_.points.size() : mesh_.cells[3].size(), none);
    for (std::int64_t i = 0; i < tags[2]; ++i) {
      const auto number = static_cast<std::size_t>(integer());
      const double value = real();
      if (of_nodes) {
        values[nodes_.row(number, in_)] = value;
      } else if (const auto row = row_of_element_.find(number); row != row_of_element_.end()) {
        values[row->second] = value;
      }
    }
    if (of_nodes)
      mesh_.point_arrays.push_back({name, std::move(values)});
    else
      mesh_.cell_arrays.push_back({name, std::move(values)});
  }

  static constexpr int most_parts = 100000;

  FileCursor in_;
  SetBudget budget_;
  RawMesh mesh_;
  std::int32_t n_parts_ = 1;
  bool is_later_part_ = false;
  std::vector<std::size_t> element_numbers_;  // numbers of the elements in the first of several Gmsh files of a mesh
  std::unordered_set<std::size_t> known_elements_;  // numbers of the elements in all Gmsh files of the mesh read so far
  std::set<std::int32_t> ghosts_;                   // entities
  NodeRows nodes_;
  double version_ = 0;
  bool binary_ = false;
  std::size_t n_elements_ = 0;
  std::unordered_map<std::size_t, std::size_t> row_of_element_;  // row of each tetrahedron, by element number
  std::map<std::pair<int, std::int32_t>, std::vector<std::int32_t>> groups_of_;
  std::map<std::pair<int, std::int32_t>, RawSet> sets_;  // sets of cells, by the dimension of their cells and by tag
};

}  // namespace

RawMesh read_gmsh_mesh(const std::filesystem::path& file) { return GmshReader(file).read(); }

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Abaqus / CalculiX .inp: nodes, C3D4 and C3D10, element sets, node sets, surfaces on element sides.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "mesh_readers/file_cursor.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {
namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Returns the fields between commas, without surrounding blanks; empty fields are omitted.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (!line.empty()) {
    const auto comma = std::min(line.find(','), line.size());
    if (const std::string_view field = trimmed(line.substr(0, comma)); !field.empty()) fields.push_back(field);
    line.remove_prefix(std::min(comma + 1, line.size()));
  }
  return fields;
}

constexpr std::size_t corners_of_side[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

class AbaqusReader {
 public:
  explicit AbaqusReader(const std::filesystem::path& path) : in_(path), budget_(in_.size()) {}

  RawMesh read() {
    mesh_.format = "Abaqus";
    while (!in_.at_end()) {
      const std::string_view line = in_.line();
      if (line.empty() || line.starts_with("**")) continue;
      if (line.front() == '*') {
        begin_block(line);
      } else {
        read_data(line);
      }
    }
    for (auto* sets : {&element_sets_, &surfaces_, &node_sets_})
      for (const std::string& name : sets->order)
        if (RawSet& set = sets->sets[name]; !set.rows.empty()) mesh_.sets.push_back(std::move(set));
    return std::move(mesh_);
  }

 private:
  enum class Block { other, nodes, tetrahedra, lower, solids, element_set, node_set, surface };
  struct NamedSets {
    int dimension;
    std::map<std::string, RawSet> sets;  ///< sets of nodes or elements, by name in capitals
    std::vector<std::string> order;
    RawSet& give(std::string_view name) {
      const std::string key = upper(name);
      const auto [entry, is_new] = sets.try_emplace(key);
      if (is_new) {
        order.push_back(key);
        entry->second.name = std::string(name);
        entry->second.dimension = dimension;
      }
      return entry->second;
    }
  };

  static std::string_view parameter(std::string_view line, const char* key) {
    for (const std::string_view field : fields_of(line)) {
      const auto equals = field.find('=');
      if (equals != std::string_view::npos && upper(trimmed(field.substr(0, equals))) == key)
        return trimmed(field.substr(equals + 1));
    }
    return "";
  }
  void begin_block(std::string_view line) {
    const std::string keyword = upper(fields_of(line).front()), type = upper(parameter(line, "TYPE"));
    block_ = Block::other;
    set_ = nullptr;
    if (keyword == "*NODE") block_ = Block::nodes;
    if (keyword == "*ELEMENT") {
      n_nodes_ = type == "C3D10" ? 10 : 4;
      block_ = type == "C3D4" || type == "C3D10"                      ? Block::tetrahedra
               : type.starts_with("C3D") || type.starts_with("COH3D") ? Block::solids
                                                                      : Block::lower;
      mesh_.second_order |= type == "C3D10";
      const std::string_view name = parameter(line, "ELSET");
      if (block_ == Block::tetrahedra && !name.empty()) set_ = &element_sets_.give(name);
    }
    if (keyword == "*ELSET") begin_set(Block::element_set, element_sets_, parameter(line, "ELSET"));
    if (keyword == "*NSET") begin_set(Block::node_set, node_sets_, parameter(line, "NSET"));
    if (keyword == "*SURFACE" && (type.empty() || type == "ELEMENT"))
      begin_set(Block::surface, surfaces_, parameter(line, "NAME"));
    generate_ = upper(line).find("GENERATE") != std::string::npos;
  }
  void begin_set(Block block, NamedSets& sets, std::string_view name) {
    block_ = block;
    set_ = &sets.give(name);
  }
  double number(std::string_view text) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      in_.refuse("a number was expected: \"" + std::string(text) + "\"");
    return value;
  }
  std::size_t count(std::string_view text) const {
    constexpr double largest = 9007199254740992;  // 2^53, the largest integer up to which all integers are doubles
    const double value = number(text);
    if (!(value >= 0 && value <= largest) || value != std::floor(value))
      in_.refuse("a node's number was expected: \"" + std::string(text) + "\"");
    return static_cast<std::size_t>(value);
  }
  void read_data(std::string_view line) {
    std::vector<std::string_view> fields = fields_of(line);
    switch (block_) {
      case Block::other:
        return;
      case Block::nodes:
        return read_node(fields);
      case Block::tetrahedra:
        return read_tetrahedron(std::move(fields));
      case Block::solids:
        ++mesh_.n_other_solids;
        ++n_elements_;
        return;
      case Block::lower:
        ++n_elements_;
        return;
      case Block::element_set:
      case Block::node_set:
        return read_set(fields);
      case Block::surface:
        return read_side(fields);
    }
  }
  void read_node(const std::vector<std::string_view>& fields) {
    if (fields.size() < 4) in_.refuse("a node needs a number and three coordinates");
    nodes_.add(count(fields[0]), in_);
    mesh_.points.push_back({number(fields[1]), number(fields[2]), number(fields[3])});
  }
  void read_tetrahedron(std::vector<std::string_view> fields) {
    // Fields on the continuation lines of an Abaqus element with ten nodes: a line may end after any node.
    std::vector<std::string> rest;
    while (fields.size() + rest.size() < n_nodes_ + 1 && n_nodes_ == 10 && !in_.at_end()) {
      const std::string_view more = in_.line();
      for (const std::string_view field : fields_of(more)) rest.emplace_back(field);
    }
    if (fields.size() + rest.size() != n_nodes_ + 1)
      in_.refuse("a " + std::string(n_nodes_ == 10 ? "C3D10" : "C3D4") + " element needs a number and " +
                 (n_nodes_ == 10 ? "ten" : "four") + " nodes");
    const auto field = [&](std::size_t at) {
      return at < fields.size() ? fields[at] : std::string_view(rest[at - fields.size()]);
    };
    RawCells& cells = mesh_.cells[3];
    for (std::size_t i = 1; i <= n_nodes_; ++i)
      (i <= 4 ? cells.corners : mesh_.midpoints).push_back(nodes_.row(count(field(i)), in_));
    if (set_) set_->rows.push_back(cells.size() - 1);
    row_of_element_[count(field(0))] = cells.size() - 1;
    mesh_.numbers.push_back(n_elements_++);
  }
  /// Reads one line of an Abaqus set: numbers of nodes or elements, or names of other sets.
  void read_set(const std::vector<std::string_view>& fields) {
    const bool nodes = block_ == Block::node_set;
    if (generate_ && fields.size() >= 2) {
      const std::size_t first = count(fields[0]), last = count(fields[1]),
                        step = fields.size() > 2 ? count(fields[2]) : 1;
      if (step == 0) in_.refuse("the step of a GENERATE line is 0");
      // A range in an Abaqus set may contain numbers that no element has. They are skipped, all at once if the range is
      // far longer than the list of elements.
      if (!nodes && first < last && (last - first) / step > 2 * row_of_element_.size())
        return add_between(first, last, step);
      for (std::size_t i = first; i <= last; i += step) add_to_set(i, nodes);
      return;
    }
    for (const std::string_view field : fields) {
      if (std::isdigit(static_cast<unsigned char>(field.front()))) {
        add_to_set(count(field), nodes);
      } else {
        const std::vector<std::size_t> rows = (nodes ? node_sets_ : element_sets_).give(field).rows;
        take(rows.size());
        set_->rows.insert(set_->rows.end(), rows.begin(), rows.end());
        drop_repeated(nodes ? mesh_.points.size() : mesh_.cells[3].size());
      }
    }
  }
  /// Adds to an Abaqus set those of the elements first, first + step ... last that exist.
  void add_between(std::size_t first, std::size_t last, std::size_t step) {
    std::vector<std::size_t> numbers;
    for (const auto& [number, row] : row_of_element_)
      if (number >= first && number <= last && (number - first) % step == 0) numbers.push_back(number);
    std::sort(numbers.begin(), numbers.end());
    for (const std::size_t number : numbers) add_to_set(number, false);
  }
  /// Keeps each member of an Abaqus set once: a short file could fill all memory with sets that contain each other.
  void drop_repeated(std::size_t n_items) {
    std::vector<std::size_t>& rows = set_->rows;
    if (rows.size() <= n_items) return;
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  void take(std::size_t n) {
    if (!budget_.take(n)) in_.refuse(SetBudget::message);
  }
  void add_to_set(std::size_t number, bool nodes) {
    take(1);
    if (nodes) {
      set_->rows.push_back(nodes_.row(number, in_));
    } else if (const auto row = row_of_element_.find(number); row != row_of_element_.end()) {
      set_->rows.push_back(row->second);
    }
  }
  void read_side(const std::vector<std::string_view>& fields) {
    if (fields.size() < 2) in_.refuse("a side needs an element and S1 to S4");
    const int side = fields[1].size() == 2 && upper(fields[1])[0] == 'S' ? fields[1][1] - '0' : 0;
    if (side < 1 || side > 4)
      in_.refuse("a side of a tetrahedron is S1 to S4, found \"" + std::string(fields[1]) + "\"");
    if (!std::isdigit(static_cast<unsigned char>(fields[0].front()))) {
      for (const std::size_t row : element_sets_.give(fields[0]).rows) add_side(row, side);
    } else if (const auto row = row_of_element_.find(count(fields[0])); row != row_of_element_.end()) {
      add_side(row->second, side);
    }
  }
  void add_side(std::size_t tetrahedron, int side) {
    take(1);
    RawCells& faces = mesh_.cells[2];
    for (const std::size_t i : corners_of_side[side - 1])
      faces.corners.push_back(mesh_.cells[3].corners[4 * tetrahedron + i]);
    set_->rows.push_back(faces.size() - 1);
  }

  FileCursor in_;
  SetBudget budget_;
  RawMesh mesh_;
  NodeRows nodes_;
  NamedSets element_sets_{3, {}, {}}, surfaces_{2, {}, {}}, node_sets_{-1, {}, {}};
  std::unordered_map<std::size_t, std::size_t> row_of_element_;
  Block block_ = Block::other;
  RawSet* set_ = nullptr;
  bool generate_ = false;
  std::size_t n_nodes_ = 4, n_elements_ = 0;
};

}  // namespace

RawMesh read_abaqus_mesh(const std::filesystem::path& file) { return AbaqusReader(file).read(); }

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh .msh (2.2 and 4.1 ASCII) and Abaqus/CalculiX .inp: nodes, linear tetrahedra, groups.
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <unordered_map>

#include "check/read/mesh_files.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Words and lines of a text file, with the line's number for messages.
class TextReader {
 public:
  explicit TextReader(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
  }
  bool next_line() {
    if (!std::getline(file_, text_)) return false;
    ++line_;
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    words_ = std::istringstream(text_);
    return true;
  }
  void require_line() {
    if (!next_line()) refuse("ends too early");
  }
  const std::string& text() const { return text_; }
  template <class T>
  T word() {
    T value{};
    if (!(words_ >> value)) refuse("a number was expected in \"" + text_ + "\"");
    return value;
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::invalid_input, path_.string() + ":" + std::to_string(line_) + ": " + why);
  }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::string text_;
  std::istringstream words_;
  std::size_t line_ = 0;
};

/// Node numbers of a file to rows.
class NodeRows {
 public:
  void add(std::size_t number, const TextReader& in) {
    if (!rows_.emplace(number, static_cast<VertexIndex>(rows_.size())).second)
      in.refuse("node " + std::to_string(number) + " is there twice");
  }
  VertexIndex row(std::size_t number, const TextReader& in) const {
    const auto it = rows_.find(number);
    if (it == rows_.end()) in.refuse("node " + std::to_string(number) + " is not there");
    return it->second;
  }

 private:
  std::unordered_map<std::size_t, VertexIndex> rows_;
};

constexpr int gmsh_tetrahedron = 4;
bool is_gmsh_lower(int type) { return type == 1 || type == 2 || type == 3 || type == 15; }

class GmshReader {
 public:
  explicit GmshReader(const std::filesystem::path& path) : in_(path) {}

  MeshFile read() {
    mesh_.format = "Gmsh";
    mesh_.region_array = "physical group";
    while (in_.next_line()) {
      const std::string section = in_.text();
      if (section == "$MeshFormat") {
        read_format();
      } else if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Entities") {
        read_entities();
      } else if (section == "$Nodes") {
        version_ < 4 ? read_nodes_2() : read_nodes_4();
      } else if (section == "$Elements") {
        version_ < 4 ? read_elements_2() : read_elements_4();
      }
    }
    if (version_ == 0) in_.refuse("no $MeshFormat: not a Gmsh file");
    return std::move(mesh_);
  }

 private:
  void read_format() {
    in_.require_line();
    version_ = in_.word<double>();
    if (in_.word<int>() != 0) in_.refuse("binary Gmsh files are not read here; save as ASCII");
  }
  void read_names() {
    in_.require_line();
    for (auto n = in_.word<std::size_t>(); n > 0; --n) {
      in_.require_line();
      const int dimension = in_.word<int>();
      const auto id = in_.word<std::int32_t>();
      const auto first = in_.text().find('"'), last = in_.text().rfind('"');
      if (dimension == 3 && first != std::string::npos && last > first)
        mesh_.region_names[id] = in_.text().substr(first + 1, last - first - 1);
    }
  }
  void read_entities() {
    in_.require_line();
    std::array<std::size_t, 4> n{};
    for (auto& count : n) count = in_.word<std::size_t>();
    for (std::size_t i = 0; i < n[0] + n[1] + n[2]; ++i) in_.require_line();
    for (std::size_t i = 0; i < n[3]; ++i) {
      in_.require_line();
      const int tag = in_.word<int>();
      for (int k = 0; k < 6; ++k) in_.word<double>();
      if (in_.word<std::size_t>() > 0) volume_group_[tag] = in_.word<std::int32_t>();
    }
  }
  void add_node(std::size_t number) {
    const auto x = in_.word<double>(), y = in_.word<double>(), z = in_.word<double>();
    nodes_.add(number, in_);
    mesh_.points.push_back({x, y, z});
  }
  void read_nodes_2() {
    in_.require_line();
    for (auto n = in_.word<std::size_t>(); n > 0; --n) {
      in_.require_line();
      const auto number = in_.word<std::size_t>();
      add_node(number);
    }
  }
  void read_nodes_4() {
    in_.require_line();
    for (auto blocks = in_.word<std::size_t>(); blocks > 0; --blocks) {
      in_.require_line();
      for (int k = 0; k < 3; ++k) in_.word<int>();
      std::vector<std::size_t> numbers;
      for (auto n = in_.word<std::size_t>(); numbers.size() < n;) {
        in_.require_line();
        numbers.push_back(in_.word<std::size_t>());
      }
      for (const std::size_t number : numbers) {
        in_.require_line();
        add_node(number);
      }
    }
  }
  void add_element(int type, std::int32_t group) {
    const std::size_t number = n_elements_++;
    if (type != gmsh_tetrahedron) {
      ++(is_gmsh_lower(type) ? mesh_.n_lower_cells : mesh_.n_other_solids);
      return;
    }
    Tetrahedron t{};
    for (auto& v : t) v = nodes_.row(in_.word<std::size_t>(), in_);
    mesh_.tetrahedra.push_back(t);
    mesh_.cell.push_back(number);
    mesh_.region.push_back(group);
  }
  void read_elements_2() {
    in_.require_line();
    for (auto n = in_.word<std::size_t>(); n > 0; --n) {
      in_.require_line();
      in_.word<std::size_t>();
      const int type = in_.word<int>();
      std::int32_t group = 0;
      for (int k = 0, tags = in_.word<int>(); k < tags; ++k) {
        const auto tag = in_.word<std::int32_t>();
        if (k == 0) group = tag;
      }
      add_element(type, group);
    }
  }
  void read_elements_4() {
    in_.require_line();
    for (auto blocks = in_.word<std::size_t>(); blocks > 0; --blocks) {
      in_.require_line();
      in_.word<int>();
      const int entity = in_.word<int>(), type = in_.word<int>();
      const auto group = volume_group_.find(entity);
      for (auto n = in_.word<std::size_t>(); n > 0; --n) {
        in_.require_line();
        in_.word<std::size_t>();
        add_element(type, group == volume_group_.end() ? 0 : group->second);
      }
    }
  }

  TextReader in_;
  MeshFile mesh_;
  NodeRows nodes_;
  std::map<int, std::int32_t> volume_group_;
  double version_ = 0;
  std::size_t n_elements_ = 0;
};

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// The numbers of a comma-separated data line.
std::vector<double> numbers_of(const TextReader& in) {
  std::vector<double> values;
  std::istringstream line(in.text());
  for (std::string field; std::getline(line, field, ',');) {
    const auto first = field.find_first_not_of(" \t");
    if (first == std::string::npos) continue;
    const auto last = field.find_last_not_of(" \t") + 1;
    double value = 0;
    const auto [end, error] = std::from_chars(field.data() + first, field.data() + last, value);
    if (error != std::errc() || end != field.data() + last) in.refuse("a number was expected: \"" + field + "\"");
    values.push_back(value);
  }
  return values;
}

/// A node's number; the numbers of a data line are all read as doubles.
std::size_t node_number(double value, const TextReader& in) {
  constexpr double largest = 9007199254740992;  // the next one is not a double
  if (!(value >= 0 && value <= largest) || value != std::floor(value))
    in.refuse("a node's number was expected: \"" + in.text() + "\"");
  return static_cast<std::size_t>(value);
}

/// KEY=value of a keyword line, "" where it is not there.
std::string parameter(const std::string& line, const std::string& key) {
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');) {
    field.erase(0, field.find_first_not_of(" \t"));
    const auto equals = field.find('=');
    if (equals == std::string::npos) continue;
    std::string name = upper(field.substr(0, equals));
    name.erase(name.find_last_not_of(" \t") + 1);
    if (name != key) continue;
    std::string value = field.substr(equals + 1);
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t") + 1);
    return value;
  }
  return "";
}

}  // namespace

MeshFile read_gmsh(const std::filesystem::path& path) { return GmshReader(path).read(); }

MeshFile read_abaqus(const std::filesystem::path& path) {
  TextReader in(path);
  MeshFile mesh;
  mesh.format = "Abaqus";
  mesh.region_array = "element set";
  NodeRows nodes;
  std::map<std::string, std::int32_t> set_id;
  enum class Block { other, nodes, tetrahedra, lower, solids } block = Block::other;
  std::int32_t region = 0;
  std::size_t n_elements = 0;
  while (in.next_line()) {
    if (in.text().empty() || in.text().starts_with("**")) continue;
    if (in.text().front() == '*') {
      const std::string line = upper(in.text());
      const std::string type = upper(parameter(in.text(), "TYPE")), set = parameter(in.text(), "ELSET");
      block = Block::other;
      if (line.starts_with("*NODE") && (line.size() == 5 || line[5] == ',')) block = Block::nodes;
      if (line.starts_with("*ELEMENT") && (line.size() == 8 || line[8] == ',')) {
        block = type == "C3D4" ? Block::tetrahedra : type.starts_with("C3D") ? Block::solids : Block::lower;
        if (block == Block::tetrahedra && !set.empty()) {
          region = set_id.try_emplace(set, static_cast<std::int32_t>(set_id.size() + 1)).first->second;
          mesh.region_names[region] = set;
        }
      }
      continue;
    }
    if (block == Block::other) continue;
    const std::vector<double> v = numbers_of(in);
    if (block == Block::nodes) {
      if (v.size() < 4) in.refuse("a node needs a number and three coordinates");
      nodes.add(node_number(v[0], in), in);
      mesh.points.push_back({v[1], v[2], v[3]});
      continue;
    }
    const std::size_t number = n_elements++;
    if (block == Block::lower) ++mesh.n_lower_cells;
    if (block == Block::solids) ++mesh.n_other_solids;
    if (block != Block::tetrahedra) continue;
    if (v.size() != 5) in.refuse("a C3D4 element needs a number and four nodes");
    Tetrahedron t{};
    for (int i = 0; i < 4; ++i) t[i] = nodes.row(node_number(v[i + 1], in), in);
    mesh.tetrahedra.push_back(t);
    mesh.cell.push_back(number);
    mesh.region.push_back(region);
  }
  return mesh;
}

}  // namespace geomesh::geomodel::checking

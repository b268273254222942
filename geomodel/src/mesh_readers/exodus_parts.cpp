// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/exodus_parts.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "geomesh/core/error.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw Error(ErrorKind::invalid_input, file.string() + ": " + why);
}

/// Converts the global number of a node or element to its row. Global numbers count from 1 without gaps.
std::size_t row_of(int number, std::size_t n, const std::filesystem::path& whole) {
  if (number < 1 || static_cast<std::size_t>(number) > n)
    refuse(whole, "global numbers of its parts have gaps or are out of range (" + std::to_string(number) + ")");
  return static_cast<std::size_t>(number - 1);
}

/// Returns the largest global number of the nodes or elements in all parts of an Exodus mesh, which is their count if
/// no number is missing. Throws if the number is larger than the nodes or elements in the parts are many.
std::size_t count_numbers(const std::vector<ExodusPartMesh>& parts, std::vector<int> ExodusPartMesh::*numbers,
                          const std::filesystem::path& whole) {
  int largest = 0;
  std::size_t n = 0;
  for (const ExodusPartMesh& part : parts) {
    n += (part.*numbers).size();
    for (const int number : part.*numbers) largest = std::max(largest, number);
  }
  if (static_cast<std::size_t>(largest) > n) row_of(largest, n, whole);
  return static_cast<std::size_t>(largest);
}

/// Throws if a tetrahedron is in the files of two mesh parts. This is checked before gaps are, because a part that is
/// listed twice also leaves another one out.
void refuse_doubled_elements(const std::vector<ExodusPartMesh>& parts, const std::filesystem::path& whole) {
  std::vector<int> numbers;
  for (const ExodusPartMesh& part : parts)
    numbers.insert(numbers.end(), part.tetrahedra.begin(), part.tetrahedra.end());
  std::sort(numbers.begin(), numbers.end());
  const auto doubled = std::adjacent_find(numbers.begin(), numbers.end());
  if (doubled != numbers.end()) refuse(whole, "element " + std::to_string(*doubled) + " is in two parts");
}

class PartsMerger {
 public:
  PartsMerger(std::vector<ExodusPartMesh> parts, const std::filesystem::path& whole)
      : parts_(std::move(parts)), whole_(whole) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    refuse_doubled_elements(parts_, whole);
    mesh_.format = "Exodus II in parts";
    mesh_.whole = whole;
    mesh_.points.resize(count_numbers(parts_, &ExodusPartMesh::nodes, whole));
    has_point_.resize(mesh_.points.size(), false);
    mesh_.cells[3].corners.resize(4 * count_numbers(parts_, &ExodusPartMesh::tetrahedra, whole));
    has_cell_.resize(mesh_.cells[3].size(), false);
    for (const ExodusPartMesh& part : parts_) {
      mesh_.second_order |= part.mesh.second_order;
      for (const CellArray& array : part.mesh.cell_arrays) cell_values_.try_emplace(array.name, has_cell_.size(), none);
      for (const PointArray& array : part.mesh.point_arrays)
        point_values_.try_emplace(array.name, has_point_.size(), none);
    }
    if (mesh_.second_order) mesh_.midpoints.resize(6 * has_cell_.size());
  }

  RawMesh merge() {
    for (const ExodusPartMesh& part : parts_) add(part);
    if (std::find(has_point_.begin(), has_point_.end(), false) != has_point_.end() ||
        std::find(has_cell_.begin(), has_cell_.end(), false) != has_cell_.end())
      refuse(whole_, "global numbers of its parts have gaps: a part is missing");
    for (auto& [key, set] : sets_) {
      if (set.dimension == -1) {
        std::sort(set.rows.begin(), set.rows.end());
        set.rows.erase(std::unique(set.rows.begin(), set.rows.end()), set.rows.end());
      }
      mesh_.sets.push_back(std::move(set));
    }
    for (std::size_t t = 0; t < has_cell_.size(); ++t) mesh_.numbers.push_back(t);
    for (auto& [name, values] : cell_values_) mesh_.cell_arrays.push_back({name, std::move(values)});
    for (auto& [name, values] : point_values_) mesh_.point_arrays.push_back({name, std::move(values)});
    return std::move(mesh_);
  }

 private:
  void add(const ExodusPartMesh& part) {
    if (part.nodes.size() != part.mesh.points.size() || part.tetrahedra.size() != part.mesh.cells[3].size())
      refuse(whole_, "a part has no global numbers of its nodes and tetrahedra");
    std::vector<VertexIndex> node;
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      const std::size_t row = row_of(part.nodes[i], has_point_.size(), whole_);
      if (has_point_[row] && !(mesh_.points[row] == part.mesh.points[i]))
        refuse(whole_, "node " + std::to_string(row + 1) + " has different places in two parts");
      has_point_[row] = true;
      mesh_.points[row] = part.mesh.points[i];
      node.push_back(static_cast<VertexIndex>(row));
      for (const PointArray& array : part.mesh.point_arrays) point_values_[array.name][row] = array.values[i];
    }
    std::vector<std::size_t> cell;
    for (std::size_t t = 0; t < part.tetrahedra.size(); ++t) {
      const std::size_t row = row_of(part.tetrahedra[t], has_cell_.size(), whole_);
      has_cell_[row] = true;
      cell.push_back(row);
      for (std::size_t i = 0; i < 4; ++i)
        mesh_.cells[3].corners[4 * row + i] = node[part.mesh.cells[3].corners[4 * t + i]];
      if (part.mesh.midpoints.size() == 6 * part.tetrahedra.size())
        for (std::size_t i = 0; i < 6; ++i) mesh_.midpoints[6 * row + i] = node[part.mesh.midpoints[6 * t + i]];
      for (const CellArray& array : part.mesh.cell_arrays) cell_values_[array.name][row] = array.values[t];
    }
    const std::size_t first_face = mesh_.cells[2].size();
    for (const VertexIndex v : part.mesh.cells[2].corners) mesh_.cells[2].corners.push_back(node[v]);
    for (const RawSet& set : part.mesh.sets) {
      RawSet& all =
          sets_.try_emplace({set.dimension, set.id}, RawSet{set.name, set.id, set.dimension, {}}).first->second;
      for (const std::size_t row : set.rows)
        all.rows.push_back(set.dimension == 3   ? cell[row]
                           : set.dimension == 2 ? first_face + row
                                                : std::size_t{node[row]});
    }
    mesh_.n_other_solids += part.mesh.n_other_solids;
  }

  std::vector<ExodusPartMesh> parts_;
  const std::filesystem::path& whole_;
  RawMesh mesh_;
  std::vector<bool> has_point_, has_cell_;
  std::map<std::pair<int, std::int32_t>, RawSet> sets_;  // sets of cells, by the dimension of their cells and by id
  std::map<std::string, std::vector<double>> cell_values_, point_values_;
};

}  // namespace

std::optional<ExodusPartFiles> exodus_part_files(const std::filesystem::path& file) {
  // Files of the parts of an Exodus mesh are named NAME.e.COUNT.NUMBER; both numbers have as many digits.
  std::string name = file.filename().string();
  const auto take_number = [&name] {
    const std::string digits(digits_at_end(name));
    const std::size_t rest = name.size() - digits.size();
    const bool is_part = !digits.empty() && rest > 0 && name[rest - 1] == '.';
    name.resize(is_part ? rest - 1 : 0);
    return is_part ? digits : std::string();
  };
  const std::string part = take_number(), all = take_number();
  constexpr std::size_t most_digits = 6;
  if (all.empty() || part.size() != all.size() || all.size() > most_digits) return std::nullopt;
  const std::filesystem::path whole = name;
  const std::string ending = whole.extension().string();
  if (ending != ".e" && ending != ".exo" && ending != ".ex2" && ending != ".exii") return std::nullopt;
  ExodusPartFiles files{file.parent_path() / whole, {}};
  for (int k = 0; k < std::stoi(all); ++k) {
    const std::string own = std::to_string(k);
    files.parts.push_back(files.whole.string() + "." + all + "." + std::string(all.size() - own.size(), '0') + own);
  }
  if (files.parts.empty()) return std::nullopt;
  return files;
}

RawMesh merge_exodus_parts(std::vector<ExodusPartMesh> parts, const std::filesystem::path& whole) {
  return PartsMerger(std::move(parts), whole).merge();
}

}  // namespace geomesh::geomodel

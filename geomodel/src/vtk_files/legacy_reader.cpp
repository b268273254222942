// SPDX-License-Identifier: GPL-3.0-or-later
// Reads legacy VTK files, declared in vtk_files/vtk_data.hpp.
#include <cmath>
#include <map>
#include <utility>

#include "readers/text/text.hpp"
#include "vtk_files/cell_builder.hpp"
#include "vtk_files/legacy_words.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::string_view head = "# vtk DataFile Version ";

class LegacyAttributes {
 public:
  LegacyAttributes(LegacyWords& words, VtkData& data) : words_(words), data_(data), table_(&data.field_data) {}

  /// Reads VTK attributes after their keyword: POINT_DATA, CELL_DATA or a field. Returns false for any other keyword.
  bool take(const std::string& keyword) {
    if (keyword == "metadata") {
      skip_metadata();
    } else if (keyword == "field") {
      read_field(*table_, n_);
    } else if (keyword == "point_data" || keyword == "cell_data") {
      table_ = keyword == "point_data" ? &data_.point_data : &data_.cell_data;
      n_ = words_.count("values");
    } else if (table_ == &data_.field_data) {
      return false;
    } else if (keyword == "scalars") {
      read_scalars();
    } else if (keyword == "color_scalars") {
      read_colours();
    } else if (keyword == "lookup_table") {
      words_.name();
      words_.values("", words_.binary ? VtkType::uint8 : VtkType::float32, words_.count("colours"), 4);
    } else {
      return take_plain_attribute(keyword);
    }
    return true;
  }

  /// Reads the field data after the keyword FIELD: a name and a count, then as many arrays NAME COMPONENTS TUPLES TYPE.
  void read_field(VtkTable& table, std::size_t least) {
    words_.name();
    for (std::size_t n = words_.count("arrays"); n > 0; --n) {
      while (words_.next_keyword() == "metadata") {
        words_.keyword();
        skip_metadata();
      }
      std::string name = words_.name();
      if (name.empty()) words_.fail("it ends within a FIELD (truncated?)");
      if (to_lower(name) == "null_array") continue;
      const std::size_t n_components = words_.count("components"), n_tuples = words_.count("tuples");
      const VtkType type = words_.type();
      if (n_tuples < least) words_.fail("the array " + in_quotes(name) + " holds too few values (damaged)");
      table.put(words_.values(std::move(name), type, n_tuples, n_components));
    }
  }

 private:
  bool take_plain_attribute(const std::string& keyword) {
    static const std::map<std::string, std::size_t> widths{
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},    {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}, {"texture_coordinates", 0}};
    const auto width = widths.find(keyword);
    if (width == widths.end()) return false;
    std::string name = words_.name();
    const std::size_t n_components = width->second == 0 ? words_.count("texture coordinates") : width->second;
    const VtkType type = words_.type();
    table_->put(words_.values(std::move(name), type, n_, n_components));
    return true;
  }
  /// Reads an array after the keyword SCALARS: NAME TYPE [COMPONENTS], then LOOKUP_TABLE NAME, which some writers omit.
  void read_scalars() {
    std::string name = words_.name();
    const VtkType type = words_.type();
    const std::vector<std::string_view> rest = words_.words_of_line();
    const auto n_components = rest.empty() ? 1 : to_integer(rest.front());
    if (!n_components || *n_components < 1) words_.fail("SCALARS " + name + " has no number of components (damaged)");
    if (words_.next_keyword() == "lookup_table") {
      words_.keyword();
      words_.name();
    } else if (words_.binary) {
      words_.fail("LOOKUP_TABLE was expected behind SCALARS " + name);
    }
    table_->put(words_.values(std::move(name), type, n_, static_cast<std::size_t>(*n_components)));
  }
  /// Reads an array of colours: bytes in a binary file; in text numbers from 0 to 1, which VTK converts to bytes.
  void read_colours() {
    std::string name = words_.name();
    const std::size_t n_components = words_.count("components");
    VtkColumn given =
        words_.values(std::move(name), words_.binary ? VtkType::uint8 : VtkType::float32, n_, n_components);
    if (given.type == VtkType::float32) {
      const std::vector<double> parts = given.numbers();
      given.type = VtkType::uint8;
      given.bytes.clear();
      for (const double part : parts)
        given.bytes.push_back(static_cast<std::byte>(part > 0 ? std::min(255.0, 255 * part + 0.5) : 0.0));
    }
    table_->put(std::move(given));
  }
  /// Skips the metadata of a VTK array, which end with an empty line.
  void skip_metadata() {
    words_.line();
    while (!words_.line().empty()) {
    }
  }

  LegacyWords& words_;
  VtkData& data_;
  VtkTable* table_;    // table of point or cell arrays that receives the VTK attributes being read
  std::size_t n_ = 0;  // their tuples
};

class LegacyReader {
 public:
  explicit LegacyReader(const InputFile& file) : file_(file), words_(file) {}

  VtkData read() {
    read_head();
    for (std::string keyword = words_.keyword(); !keyword.empty(); keyword = words_.keyword())
      if (!take_cells(keyword) && !attributes_.take(keyword))
        words_.fail("a keyword of the format was expected, found " + in_quotes(keyword));
    add_cells();
    require_tuples(data_.point_data, data_.points.size(), "points");
    require_tuples(data_.cell_data, data_.cells.size(), "cells");
    return std::move(data_);
  }

 private:
  void read_head() {
    const std::string_view first = words_.line();
    const auto version = to_double(trim(first.substr(std::min(head.size(), first.size()))));
    constexpr double newest = 6;
    if (!first.starts_with(head) || !version || !(*version >= 1) || *version >= newest)
      words_.fail("it does not begin as a VTK file of a known version (# vtk DataFile Version 1.0 to 5.1)");
    is_version_5_ = *version >= 5;
    words_.line();  // skips the title of the VTK file, a line of free text
    const std::string coding = words_.keyword();
    if (coding != "ascii" && coding != "binary")
      words_.fail("its third line says " + in_quotes(coding) + "; ASCII or BINARY was expected");
    words_.binary = coding == "binary";
    words_.line();
    if (words_.next_keyword() == "field") {  // field data of a VTK file, before its keyword DATASET
      words_.keyword();
      attributes_.read_field(data_.field_data, 0);
    }
    const std::string keyword = words_.keyword(), type = words_.keyword();
    if (keyword != "dataset") words_.fail("DATASET was expected, found " + in_quotes(keyword));
    if (type != "unstructured_grid" && type != "polydata")
      file_.fail("it holds a DATASET " + in_quotes(type) + "; UNSTRUCTURED_GRID and POLYDATA are read");
    data_.kind = type == "polydata" ? VtkData::Kind::poly : VtkData::Kind::grid;
    words_.line();
  }

  /// Reads the points or cells of a legacy VTK file after their keyword. Returns false for any other keyword.
  bool take_cells(const std::string& keyword) {
    if (keyword == "points") {
      read_points();
    } else if (keyword == "cell_types" && data_.kind == VtkData::Kind::grid) {
      const std::size_t n = words_.count("cells");
      if (types_) words_.fail("it has CELL_TYPES twice (damaged)");
      types_ = words_.values("", VtkType::int32, n, 1).whole_numbers();
    } else if (keyword == (data_.kind == VtkData::Kind::grid ? "cells" : "vertices") || (is_poly(keyword))) {
      if (lists_.contains(keyword)) words_.fail("it has " + in_quotes(keyword) + " twice (damaged)");
      lists_[keyword] = read_lists();
    } else {
      return false;
    }
    return true;
  }
  bool is_poly(const std::string& keyword) const {
    return data_.kind == VtkData::Kind::poly &&
           (keyword == "lines" || keyword == "polygons" || keyword == "triangle_strips");
  }

  void read_points() {
    if (!data_.points.empty()) words_.fail("it has POINTS twice (damaged)");
    const std::size_t n = words_.count("points");
    if (n >= no_vertex) words_.fail("it holds more points than 32 bits can count");
    const VtkType type = words_.type();
    if (type == VtkType::text) words_.fail("its points are texts (damaged)");
    const std::vector<double> all = words_.values("", type, n, 3).numbers();
    data_.single_precision = type == VtkType::float32;
    for (std::size_t i = 0; i < n; ++i) data_.points.push_back({all[3 * i], all[3 * i + 1], all[3 * i + 2]});
  }

  CellLists read_lists() {
    const std::size_t n = words_.count("cells"), n_numbers = words_.count("numbers of cells");
    if (is_version_5_) {
      words_.line();
      if (words_.next_keyword() == "offsets") return read_offsets(n, n_numbers);
      words_.fail("OFFSETS was expected behind CELLS");
    }
    const std::vector<std::int64_t> block = words_.values("", VtkType::int32, n_numbers, 1).whole_numbers();
    CellLists lists;
    std::size_t at = 0;
    for (std::size_t cell = 0; cell < n; ++cell) {
      if (at >= block.size() || block[at] < 0 || static_cast<std::size_t>(block[at]) >= block.size() - at)
        words_.fail("its cells do not fill their block of numbers (damaged)");
      const auto n_corners = static_cast<std::size_t>(block[at++]);
      for (std::size_t i = 0; i < n_corners; ++i) lists.corners.push_back(block[at++]);
      lists.ends.push_back(static_cast<std::int64_t>(lists.corners.size()));
    }
    if (at != block.size()) words_.fail("its cells do not fill their block of numbers (damaged)");
    return lists;
  }
  /// Reads cells as in legacy VTK files of version 5 and later: `n` offsets from 0, then the corners.
  CellLists read_offsets(std::size_t n, std::size_t n_corners) {
    CellLists lists;
    words_.keyword();
    const VtkType type_of_offsets = words_.type();
    lists.ends = words_.values("OFFSETS", type_of_offsets, n, 1).whole_numbers();
    if (words_.keyword() != "connectivity") words_.fail("CONNECTIVITY was expected behind OFFSETS");
    const VtkType type = words_.type();
    lists.corners = words_.values("CONNECTIVITY", type, n_corners, 1).whole_numbers();
    if (lists.ends.empty()) return lists;
    if (lists.ends.front() != 0) words_.fail("the offsets of its cells do not begin at 0 (damaged)");
    lists.ends.erase(lists.ends.begin());
    return lists;
  }

  void add_cells() {
    for (const auto& [keyword, lists] : lists_) require_rising(file_, lists.ends);
    CellBuilder cells(file_, data_);
    if (data_.kind == VtkData::Kind::grid) {
      const std::size_t n_types = types_ ? types_->size() : 0;
      if (n_types != lists_["cells"].ends.size())
        words_.fail("it says another number of CELL_TYPES than of CELLS (damaged)");
      if (types_) cells.add_grid(lists_["cells"], *types_, 0);
      return;
    }
    using Shape = CellBuilder::Shape;
    cells.add_poly(Shape::verts, lists_["vertices"], 0);
    cells.add_poly(Shape::lines, lists_["lines"], 0);
    cells.add_poly(Shape::polys, lists_["polygons"], 0);
    cells.add_poly(Shape::strips, lists_["triangle_strips"], 0);
  }

  void require_tuples(const VtkTable& table, std::size_t n, const char* what) const {
    for (const VtkColumn& column : table.columns)
      if (column.n_tuples < n)
        words_.fail("the array " + in_quotes(column.name) + " holds " + std::to_string(column.n_tuples) +
                    " values for " + std::to_string(n) + " " + what + " (damaged)");
  }

  const InputFile& file_;
  LegacyWords words_;
  VtkData data_;
  LegacyAttributes attributes_{words_, data_};
  bool is_version_5_ = false;
  std::map<std::string, CellLists> lists_;  // by keyword
  std::optional<std::vector<std::int64_t>> types_;
};

}  // namespace

bool is_vtk_legacy(const InputFile& file) { return file.text().starts_with(head); }

VtkData read_vtk_legacy_data(const InputFile& file) { return LegacyReader(file).read(); }

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
// Reads VTK's XML files, declared in vtk_files/vtk_data.hpp. The text is parsed by pugixml up to the appended data,
// which are not XML.
#include <cmath>
#include <cstdint>

#include "readers/text/text.hpp"
#include "vtk_files/cell_builder.hpp"
#include "vtk_files/typed.hpp"
#include "vtk_files/xml_arrays.hpp"

namespace geomesh::geomodel {
namespace {

/// Largest compression ratio of zlib. It limits the number of items in a VTK file, because a point or a cell has at
/// least four bytes, and an empty text one.
constexpr std::size_t most_packed = 1100;

VtkEncoding encoding_of(const InputFile& file, const pugi::xml_node& root) {
  VtkEncoding encoding;
  if (root.attribute("byte_order").value() == std::string_view("BigEndian")) encoding.order = std::endian::big;
  const std::string_view header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    file.fail("its header_type is " + in_quotes(header) + "; UInt32 or UInt64 were expected");
  if (header == "UInt64") encoding.header_bytes = 8;
  using Compressor = VtkEncoding::Compressor;
  const std::string_view compressor = root.attribute("compressor").value();
  if (compressor == "vtkZLibDataCompressor")
    encoding.compressor = Compressor::zlib;
  else if (compressor == "vtkLZ4DataCompressor")
    encoding.compressor = Compressor::lz4;
  else if (compressor == "vtkLZMADataCompressor")
    encoding.compressor = Compressor::lzma;
  else if (!compressor.empty())
    file.fail("it is compressed by " + in_quotes(compressor) +
              "; zlib, LZ4 and LZMA are read: save it with one of these, or uncompressed");
  return encoding;
}

bool is_array(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name == "DataArray" || name == "Array";
}
template <std::size_t N>
std::array<double, N> numbers_attribute(const InputFile& file, const pugi::xml_node& node, const char* name,
                                        std::array<double, N> values) {
  if (!node.attribute(name)) return values;
  std::string_view text = node.attribute(name).value();
  for (double& value : values) {
    const auto number = to_double(next_word(text));
    if (!number || !std::isfinite(*number) || std::abs(*number) > 1e300)
      file.fail(std::string(node.name()) + ": " + name + " is no list of " + std::to_string(N) + " numbers");
    value = *number;
  }
  return values;
}

/// Appends the array of the same name and type in `table` to `column`, a VTK array; returns false if there is none.
bool append(const VtkTable& table, VtkColumn& column) {
  const VtkColumn* const more = column.is_text() ? table.texts(column.name) : table.numbers(column.name);
  if (!more || more->type != column.type || more->n_components != column.n_components) return false;
  column.bytes.insert(column.bytes.end(), more->bytes.begin(), more->bytes.end());
  column.texts.insert(column.texts.end(), more->texts.begin(), more->texts.end());
  column.n_tuples += more->n_tuples;
  return true;
}

class XmlReader {
 public:
  XmlReader(const InputFile& file, const pugi::xml_node& root, const XmlArrays::Appended& appended)
      : file_(file), arrays_(file, encoding_of(file, root), appended) {}

  VtkData read(const pugi::xml_node& root) {
    const std::string type = root.attribute("type").value();
    if (type != "UnstructuredGrid" && type != "PolyData" && type != "ImageData")
      file_.fail("it is a VTK file of type " + in_quotes(type) + "; UnstructuredGrid, PolyData and ImageData are read");
    data_.kind = type == "PolyData"    ? VtkData::Kind::poly
                 : type == "ImageData" ? VtkData::Kind::image
                                       : VtkData::Kind::grid;
    const pugi::xml_node body = root.child(type.c_str());
    if (!body) file_.fail("it has no element " + type);
    read_fields(body.child("FieldData"));
    bool first = true;
    for (const pugi::xml_node& piece : body.children("Piece")) {
      read_piece(body, piece, first);
      first = false;
    }
    return std::move(data_);
  }

 private:
  void read_fields(const pugi::xml_node& fields) {
    for (const pugi::xml_node& element : fields.children())
      if (is_array(element)) data_.field_data.put(arrays_.read(element, std::nullopt));
  }

  /// Returns n, a VTK file's number of points or cells; throws if so many cannot be in the file, even compressed.
  std::size_t possible(std::size_t n, const char* what) const {
    if (n / most_packed > file_.size())
      file_.fail("it says to hold " + std::to_string(n) + " " + what + ", which a file of " +
                 std::to_string(file_.size()) + " bytes cannot");
    return n;
  }
  std::size_t count(const pugi::xml_node& piece, const char* name, const char* what) const {
    return possible(count_attribute(file_, piece, name).value_or(0), what);
  }

  void read_piece(const pugi::xml_node& body, const pugi::xml_node& piece, bool first) {
    CellBuilder cells(file_, data_);
    const std::size_t points_before = data_.points.size(), cells_before = data_.cells.size();
    if (data_.kind == VtkData::Kind::image) {
      read_lattice(body, piece, cells);
    } else {
      const std::size_t n_points = count(piece, "NumberOfPoints", "points");
      read_points(piece, n_points);
      if (data_.kind == VtkData::Kind::poly)
        read_poly_cells(piece, cells, points_before);
      else
        read_grid_cells(piece, cells, points_before);
    }
    read_fields(piece.child("FieldData"));
    add_table(piece.child("PointData"), data_.points.size() - points_before, first, data_.point_data);
    add_table(piece.child("CellData"), data_.cells.size() - cells_before, first, data_.cell_data);
  }

  void read_points(const pugi::xml_node& piece, std::size_t n) {
    const pugi::xml_node element = piece.child("Points").child("DataArray");
    if (n == 0) return;
    if (!element) file_.fail("a piece of it has no element Points");
    const VtkColumn column = arrays_.read(element, n);
    if (column.is_text() || column.n_components != 3)
      file_.fail("its points have " + std::to_string(column.n_components) + " coordinates; 3 were expected");
    data_.single_precision |= column.type == VtkType::float32;
    const std::vector<double> all = column.numbers();
    for (std::size_t i = 0; i < n; ++i) data_.points.push_back({all[3 * i], all[3 * i + 1], all[3 * i + 2]});
    if (data_.points.size() >= no_vertex) file_.fail("it holds more points than 32 bits can count");
  }

  std::vector<std::int64_t> cell_array(const pugi::xml_node& group, const char* name, std::size_t n) const {
    const pugi::xml_node element = group.find_child_by_attribute("DataArray", "Name", name);
    if (!element) file_.fail(std::string("its ") + group.name() + " have no array \"" + name + "\"");
    const VtkColumn column = arrays_.read(element, n);
    if (column.is_text() || column.n_components != 1) file_.fail(std::string("its array \"") + name + "\" is damaged");
    return column.whole_numbers();
  }
  CellLists lists(const pugi::xml_node& piece, const char* group_name, std::size_t n) const {
    CellLists lists;
    if (n == 0) return lists;
    const pugi::xml_node group = piece.child(group_name);
    if (!group) file_.fail(std::string("a piece of it has no element ") + group_name);
    lists.ends = cell_array(group, "offsets", n);
    require_rising(file_, lists.ends);
    const auto n_corners = static_cast<std::size_t>(lists.ends.back());
    if (n_corners > 0) lists.corners = cell_array(group, "connectivity", possible(n_corners, "corners of cells"));
    return lists;
  }

  void read_grid_cells(const pugi::xml_node& piece, CellBuilder& cells, std::size_t first_point) {
    const std::size_t n = count(piece, "NumberOfCells", "cells");
    const CellLists given = lists(piece, "Cells", n);
    const std::vector<std::int64_t> types =
        n == 0 ? std::vector<std::int64_t>{} : cell_array(piece.child("Cells"), "types", n);
    cells.add_grid(given, types, first_point);
  }
  void read_poly_cells(const pugi::xml_node& piece, CellBuilder& cells, std::size_t first_point) {
    using Shape = CellBuilder::Shape;
    cells.add_poly(Shape::verts, lists(piece, "Verts", count(piece, "NumberOfVerts", "vertices")), first_point);
    cells.add_poly(Shape::lines, lists(piece, "Lines", count(piece, "NumberOfLines", "lines")), first_point);
    cells.add_poly(Shape::polys, lists(piece, "Polys", count(piece, "NumberOfPolys", "polygons")), first_point);
    cells.add_poly(Shape::strips, lists(piece, "Strips", count(piece, "NumberOfStrips", "strips")), first_point);
  }

  void read_lattice(const pugi::xml_node& body, const pugi::xml_node& piece, CellBuilder& cells) {
    ImageLattice lattice;
    lattice.origin = numbers_attribute<3>(file_, body, "Origin", {0, 0, 0});
    lattice.spacing = numbers_attribute<3>(file_, body, "Spacing", {1, 1, 1});
    lattice.direction = numbers_attribute<9>(file_, body, "Direction", {1, 0, 0, 0, 1, 0, 0, 0, 1});
    const auto whole = numbers_attribute<6>(file_, body, "WholeExtent", {0, -1, 0, -1, 0, -1});
    const auto extent = numbers_attribute<6>(file_, piece, "Extent", whole);
    std::size_t n = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = extent[2 * k], last = extent[2 * k + 1];
      constexpr double most = 1 << 30;
      if (std::floor(first) != first || std::floor(last) != last || last < first || std::abs(first) > most ||
          std::abs(last) > most)
        file_.fail("the extent of the image is damaged");
      lattice.first[k] = static_cast<std::int64_t>(first);
      lattice.n[k] = static_cast<std::size_t>(last - first) + 1;
      n = possible(product(n, lattice.n[k]), "points");
    }
    cells.add_image(lattice);
  }

  /// Adds the arrays of one piece of the VTK file to those of earlier pieces. Arrays that a piece lacks are dropped.
  void add_table(const pugi::xml_node& group, std::size_t n, bool first, VtkTable& table) {
    VtkTable own;
    for (const pugi::xml_node& element : group.children())
      if (is_array(element)) own.put(arrays_.read(element, n));
    if (first) {
      table = std::move(own);
      return;
    }
    std::erase_if(table.columns, [&](VtkColumn& column) { return !append(own, column); });
  }
  const InputFile& file_;
  XmlArrays arrays_;
  VtkData data_;
};

/// Returns the appended data of a VTK file, which follow an underscore; base64 text ends with the element.
XmlArrays::Appended appended_data(const InputFile& file, std::string_view element) {
  XmlArrays::Appended appended;
  if (element.empty()) return appended;
  const std::size_t end = element.find('>'), mark = element.find('_', end);
  if (end == std::string_view::npos || mark == std::string_view::npos)
    file.fail("its appended data do not begin with an underscore (damaged)");
  appended.base64 = element.substr(0, end).find("base64") != std::string_view::npos;
  appended.text = element.substr(mark + 1);
  if (appended.base64) appended.text = appended.text.substr(0, appended.text.find('<'));
  return appended;
}

}  // namespace

VtkData read_vtk_xml_data(const InputFile& file) {
  const std::string_view text = file.text(), last = "</VTKFile>";
  const std::size_t appended_at = std::min(text.find("<AppendedData"), text.size());
  if (text.substr(text.size() - std::min<std::size_t>(text.size(), 256)).find(last) == std::string_view::npos)
    file.fail("the VTK file has no </VTKFile> at its end (truncated)");
  std::string head(text.substr(0, appended_at));
  if (appended_at < text.size()) head += last;
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer_inplace(head.data(), head.size());
  if (!result) {
    const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(place, text.size())), '\n');
    file.fail(static_cast<std::size_t>(line) + 1, std::string("it is no complete XML: ") + result.description());
  }
  const pugi::xml_node root = document.child("VTKFile");
  if (!root) file.fail("it has no element VTKFile");
  return XmlReader(file, root, appended_data(file, text.substr(appended_at))).read(root);
}

}  // namespace geomesh::geomodel

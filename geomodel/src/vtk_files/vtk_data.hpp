// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a VTK file holds, whatever its encoding: points, cells of any type, and named arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Types of cells by VTK's numbers, as far as somebody asks for them by name.
namespace vtk_cell {
inline constexpr std::uint8_t empty = 0, vertex = 1, poly_vertex = 2, line = 3, poly_line = 4, triangle = 5,
                              triangle_strip = 6, polygon = 7, pixel = 8, quad = 9, tetrahedron = 10, voxel = 11,
                              hexahedron = 12, wedge = 13, pyramid = 14, quadratic_edge = 21, quadratic_triangle = 22,
                              quadratic_quad = 23, quadratic_tetrahedron = 24;
}  // namespace vtk_cell

enum class VtkType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  bit,  ///< one byte each in memory
  text
};

/// Bytes of one value in memory; 1 for texts.
std::size_t size_of(VtkType type);
/// As VTK calls the type in memory: "double", "unsigned char", "string".
std::string name_of(VtkType type);

/// A named array: tuples of numbers, or texts.
struct VtkColumn {
  std::string name;
  VtkType type = VtkType::float64;
  std::size_t n_components = 1, n_tuples = 0;
  std::vector<std::byte> bytes;    ///< of the numbers, in this machine's order
  std::vector<std::string> texts;  ///< of an array of texts

  bool is_text() const { return type == VtkType::text; }
  /// Precondition: numbers, i < n_tuples * n_components.
  double number(std::size_t i) const;
  double number(std::size_t tuple, std::size_t component) const { return number(tuple * n_components + component); }
  /// All values of all components. Numbers with a fraction and those that no 64-bit number holds become -1.
  std::vector<std::int64_t> whole_numbers() const;
  std::vector<double> numbers() const;
};

struct VtkTable {
  std::vector<VtkColumn> columns;

  /// The array of numbers of that name; null where there is none.
  const VtkColumn* numbers(std::string_view name) const;
  /// The array of texts of that name; null where there is none.
  const VtkColumn* texts(std::string_view name) const;
  /// Takes the place of one of the same name.
  void put(VtkColumn column);
};

/// Cells of all types in one list. Their corners are rows of points that are there.
struct VtkCells {
  std::vector<std::size_t> first{0};  ///< by cell into `corners`, and the end
  std::vector<VertexIndex> corners;
  std::vector<std::uint8_t> types;

  std::size_t size() const { return types.size(); }
  std::span<const VertexIndex> of(std::size_t cell) const {
    return {corners.data() + first[cell], first[cell + 1] - first[cell]};
  }
};

struct VtkData {
  enum class Kind { grid, poly, image } kind = Kind::grid;
  std::vector<Vec3> points;
  bool single_precision = false;  ///< the file holds 32-bit coordinates
  /// Those of PolyData stand in VTK's order: vertices, lines, polygons, strips; the type follows from the corners.
  VtkCells cells;
  VtkTable point_data, cell_data, field_data;
};

/// A VTK XML file of type UnstructuredGrid, PolyData or ImageData: ascii, inline or appended, raw or base64,
/// uncompressed or by zlib, LZ4 or LZMA, of either byte order and header type, in one or several pieces (put one after
/// the other). Followed: "VTK XML File Formats" (docs.vtk.org). Throws Error{invalid_input} where the file is damaged,
/// or of another type. Memory is bounded by what the file's bytes can hold. O(bytes).
VtkData read_vtk_xml_data(const InputFile& file);

/// A legacy VTK file of versions 1.0 to 5.1, ASCII or BINARY, of type UNSTRUCTURED_GRID or POLYDATA, with all kinds of
/// attributes. Followed: "VTK File Formats for VTK Version 4.2" and "VTK Legacy File Format 5.1" (docs.vtk.org). Throws
/// as above.
VtkData read_vtk_legacy_data(const InputFile& file);

/// Whether the file begins as a legacy VTK file.
bool is_vtk_legacy(const InputFile& file);

}  // namespace geomesh::geomodel

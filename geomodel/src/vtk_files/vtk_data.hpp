// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The contents of a VTK file, whatever its encoding: points, cells of any type, and named arrays.
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

/// VTK's numbers of the cell types that the program uses by name.
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
  bit,  ///< bits, each stored as one byte in memory
  text
};

/// Returns the number of bytes that one value of a VTK type takes in memory; 1 for texts.
std::size_t size_of(VtkType type);
/// Returns the name of a VTK type as it is in memory: "double", "unsigned char", "string".
std::string name_of(VtkType type);

/// A named array: tuples of numbers, or texts.
struct VtkColumn {
  std::string name;
  VtkType type = VtkType::float64;
  std::size_t n_components = 1, n_tuples = 0;
  std::vector<std::byte> bytes;    ///< bytes of the numbers of a VTK array, in the byte order of this machine
  std::vector<std::string> texts;  ///< the texts, if the array is one of texts

  bool is_text() const { return type == VtkType::text; }
  /// Returns number i of a VTK array of numbers, of all components. Precondition: i < n_tuples * n_components.
  double number(std::size_t i) const;
  double number(std::size_t tuple, std::size_t component) const { return number(tuple * n_components + component); }
  /// Returns the numbers of all tuples and components of a VTK array as integers. Numbers with a fraction and those
  /// that do not fit in 64 bits become -1.
  std::vector<std::int64_t> whole_numbers() const;
  std::vector<double> numbers() const;
};

struct VtkTable {
  std::vector<VtkColumn> columns;

  /// Returns the VTK array of numbers with this name; null if there is none.
  const VtkColumn* numbers(std::string_view name) const;
  /// Returns the VTK array of texts with this name; null if there is none.
  const VtkColumn* texts(std::string_view name) const;
  void put(VtkColumn column);
};

/// Cells of all types in one list. Their corners are rows of existing points.
struct VtkCells {
  std::vector<std::size_t> first{0};  ///< for each cell, then past the last one: where its corners begin in `corners`
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
  bool single_precision = false;  ///< whether the file has coordinates in single precision
  /// All cells of the VTK file. Those of PolyData are ordered as vertices, lines, polygons, strips, and get their type
  /// from the number of corners.
  VtkCells cells;
  VtkTable point_data, cell_data, field_data;
};

/// Reads a VTK XML file of type UnstructuredGrid, PolyData or ImageData: ascii, inline or appended, raw or base64,
/// uncompressed or by zlib, LZ4 or LZMA, of either byte order and header type, in one or several pieces (which are
/// concatenated). Source: "VTK XML File Formats" (docs.vtk.org). Throws Error{invalid_input} if the file is damaged, or
/// of another type. Memory is bounded by what the file's bytes can hold. O(bytes).
VtkData read_vtk_xml_data(const InputFile& file);

/// Reads a legacy VTK file of versions 1.0 to 5.1, ASCII or BINARY, of type UNSTRUCTURED_GRID or POLYDATA, with all
/// kinds of attributes. Source: "VTK File Formats for VTK Version 4.2" and "VTK Legacy File Format 5.1" (docs.vtk.org).
/// Throws Error{invalid_input} if the file is damaged, or of another type.
VtkData read_vtk_legacy_data(const InputFile& file);

bool is_vtk_legacy(const InputFile& file);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// VTK XML files (VTU, VTP, PVTU) written without VTK: appended raw data, 64-bit headers, zlib in blocks that are
/// compressed in parallel. No array of strings is written, because a widely used Python reader refuses files that have
/// one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

/// One array of a file. Its values are requested in blocks, so that no second copy of the mesh is made.
struct VtkArray {
  std::string name;
  const char* type;        ///< type as in the file: "Int32", "Float64", "UInt8", "UInt64"
  std::size_t value_size;  ///< bytes
  int components;
  std::size_t n_values;  ///< tuples times components
  std::function<void(std::size_t first, std::size_t last, std::byte* out)> fill;
};

namespace vtk_type {
template <class T>
constexpr const char* name() {
  if constexpr (std::is_same_v<T, double>)
    return "Float64";
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return "UInt8";
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return "UInt64";
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return "Int64";
  else
    return "Int32";
}
}  // namespace vtk_type

/// `value(i)` returns the value for i from 0 to n_values - 1, as T. Its references must be valid until the file is
/// written.
template <class T, class F>
VtkArray vtk_array(std::string name, std::size_t n_values, F value, int components = 1) {
  static_assert(std::is_same_v<T, double> || std::is_same_v<T, std::uint8_t> || std::is_same_v<T, std::uint64_t> ||
                std::is_same_v<T, std::int64_t> || std::is_same_v<T, std::int32_t>);
  return {std::move(name),
          vtk_type::name<T>(),
          sizeof(T),
          components,
          n_values,
          [value](std::size_t first, std::size_t last, std::byte* out) {
            for (std::size_t i = first; i < last; ++i, out += sizeof(T)) {
              const T v = static_cast<T>(value(i));
              std::memcpy(out, &v, sizeof v);
            }
          }};
}

/// A few numbers about the whole file, written as text. Values of arrays with the same name are concatenated.
struct VtkField {
  std::string name;
  std::vector<std::int32_t> values;
};

/// Part of a piece: "Points", "Cells", "PointData" ... with its arrays.
struct VtkSection {
  std::string tag;
  std::string attributes;  ///< attributes of the tag, such as `Scalars="region"`; may be empty, without a leading blank
  std::vector<VtkArray> arrays;
};

struct VtkDocument {
  std::string type;              ///< "UnstructuredGrid" or "PolyData"
  std::string piece_attributes;  ///< `NumberOfPoints="8" NumberOfCells="5"`
  std::vector<VtkField> fields;
  std::vector<double> origin;  ///< field data `origin`, empty or three numbers
  std::vector<VtkSection> sections;
};

/// Writes the file, complete or absent. Throws Error{usage} if it cannot be written.
void write_vtk_document(const VtkDocument& document, Compression compression, const std::filesystem::path& file);

/// Returns the text with the characters that XML reserves replaced.
std::string xml_text(const std::string& text);

}  // namespace geomesh::geomodel

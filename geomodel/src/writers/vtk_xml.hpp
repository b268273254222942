// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes VTK XML files (VTU, VTP, PVTU) without VTK: appended raw data, 64-bit headers, zlib in blocks that are
/// compressed in parallel. No array of strings is written, because a widely used Python reader refuses them.
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

/// One array of a VTK file. Its values are requested in blocks, so that no second copy of the mesh is made.
struct VtkArray {
  std::string name;
  const char* type;        ///< type of the values as in the file: "Int32", "Float64", "UInt8", "UInt64"
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

/// Makes a VTK array whose value i, from 0 to n_values - 1, is `value(i)` converted to T. Objects to which `value`
/// refers must exist until the file is written.
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

/// A field array: a few numbers about the whole file, written as text. Those with the same name are concatenated.
struct VtkField {
  std::string name;
  std::vector<std::int32_t> values;
};

/// A section of a VTK piece ("Points", "Cells", "PointData" ...) with its arrays.
struct VtkSection {
  std::string tag;
  /// XML attributes of the section, such as `Scalars="region"`, without a leading blank; may be empty
  std::string attributes;
  std::vector<VtkArray> arrays;
};

struct VtkDocument {
  std::string type;              ///< "UnstructuredGrid" or "PolyData"
  std::string piece_attributes;  ///< `NumberOfPoints="8" NumberOfCells="5"`
  std::vector<VtkField> fields;
  std::vector<double> origin;  ///< origin for the field data `origin`: empty or three numbers
  std::vector<VtkSection> sections;
};

/// Writes a VTK file, which is either complete or absent. Throws Error{usage} if it cannot be written.
void write_vtk_document(const VtkDocument& document, Compression compression, const std::filesystem::path& file);

/// Returns a text in which the characters that XML reserves are replaced.
std::string xml_text(const std::string& text);

}  // namespace geomesh::geomodel

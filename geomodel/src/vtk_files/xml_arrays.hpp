// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the elements DataArray and Array of VTK's XML files.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

#include "vtk_files/encoded.hpp"
#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {

/// Returns an XML attribute as an integer that is not negative; nothing if the attribute is absent. Throws
/// Error{invalid_input} for any other value.
std::optional<std::size_t> count_attribute(const InputFile& file, const pugi::xml_node& element, const char* name);

/// Reads the arrays of one VTK XML file, whose parsed text and appended bytes must outlive this object.
class XmlArrays {
 public:
  struct Appended {
    std::string_view text;  ///< behind the underscore
    bool base64 = false;
  };
  XmlArrays(const InputFile& file, const VtkEncoding& encoding, const Appended& appended)
      : file_(file), encoding_(encoding), appended_(appended) {}

  /// Reads an array of `n_tuples` tuples. Without `n_tuples`, the XML element gives the number; if not, all are read.
  VtkColumn read(const pugi::xml_node& element, std::optional<std::size_t> n_tuples) const;

 private:
  [[noreturn]] void fail(const VtkColumn& column, const std::string& why) const;
  void read_ascii(const pugi::xml_node& element, VtkColumn& column, std::size_t n_values) const;
  void read_bytes(ByteSource source, VtkColumn& column, std::size_t n_values) const;
  void take_texts(std::string_view bytes, VtkColumn& column) const;

  const InputFile& file_;
  VtkEncoding encoding_;
  Appended appended_;
};

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The interface between the table of formats and a module that writes and reads one format with the library of that
/// format (geomodel/plugins/). C++ types are passed through it, so both sides must come from the same build.
#pragma once

#include "geomesh/geomodel/formats.hpp"
#include "mesh_readers/raw_mesh.hpp"
#include "modules/module.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

struct FormatModule {
  const char* version;  ///< GEOMESH_MODULE_VERSION
  decltype(Format::write) write;
  decltype(Format::read) read;  ///< null: not read
  /// Writes the files of those parts that this process has, if no process has the whole mesh; null if the format does
  /// not support this.
  std::vector<std::filesystem::path> (*write_part)(const ModelMesh& mesh, const MeshParts& parts,
                                                   const WriteOptions& options, const std::filesystem::path& stem);
};
/// Name of the function that each module of a format exports: const FormatModule* geomesh_format_module().
constexpr const char* format_module_function = "geomesh_format_module";

}  // namespace geomesh::geomodel

/// Defines the function geomesh_format_module() of a module. Its build defines `GEOMESH_MODULE_VERSION`.
#define GEOMESH_FORMAT_MODULE(write, read, write_part)                                                               \
  extern "C" __attribute__((visibility("default"))) const geomesh::geomodel::FormatModule* geomesh_format_module() { \
    static constexpr geomesh::geomodel::FormatModule module{GEOMESH_MODULE_VERSION, write, read, write_part};        \
    return &module;                                                                                                  \
  }

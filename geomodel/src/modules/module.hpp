// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Loads modules: shared libraries beside the program that are loaded only when they are needed. Some file formats need
/// a library that depends on dozens of others, and would otherwise cost start-up time in every run.
#pragma once

#include <cstring>

namespace geomesh::geomodel {

struct ModuleName {
  const char* file;      ///< "geomesh-exodus.so"
  const char* function;  ///< name of the function in the module that returns its table and has no arguments
  const char* purpose;   ///< beginning of messages: "Exodus files are written and read by"
  const char* package;   ///< name of the package that contains the module: "geomesh-exodus"
  const char* headers;   ///< Debian package that is needed to build the module: "libnetcdf-dev"
};

/// Returns the version of program and compiler. A module whose table contains C++ types must come from the same build.
const char* module_version();

/// Returns the table of a module, which is loaded at the first call. `fits` returns whether this program can use the
/// table. Throws Error{usage} that says where the module was searched and which package contains it. The search covers
/// the folders of GEOMESH_PLUGINS (separated by colons), the folder of the program or the Python module, the library
/// folder of the same prefix, and the configured installation folder.
const void* module_table(const ModuleName& module, bool (*fits)(const void* table));

/// Loads a module whose table begins with `const char* version`, which must be that of this program; returns the table.
template <class Table>
const Table& module_table_of(const ModuleName& module) {
  return *static_cast<const Table*>(module_table(
      module, [](const void* t) { return std::strcmp(static_cast<const Table*>(t)->version, module_version()) == 0; }));
}

}  // namespace geomesh::geomodel

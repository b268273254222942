// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Modules: shared libraries beside the program that are loaded when something is met that only they can do. A library
/// that few files need, and that brings dozens of others, costs nobody else a start.
#pragma once

#include <cstring>

namespace geomesh::geomodel {

/// What messages say of a module that is not there.
struct ModuleName {
  const char* file;      ///< "geomesh-exodus.so"
  const char* function;  ///< in it, without arguments: gives the module's table
  const char* purpose;   ///< begins the message: "Exodus files are written and read by"
  const char* package;   ///< that holds the module: "geomesh-exodus"
  const char* headers;   ///< Debian's package that a build needs to make the module: "libnetcdf-dev"
};

/// Of the program and its compiler. A module whose table holds C++ types must be of the same build.
const char* module_version();

/// Loads the module at the first call; nothing else is loaded twice by the system. `fits`: whether the table is one
/// that this program can use. Throws Error{usage} that says where it was looked for and which package brings it.
/// Looked for in the folders of GEOMESH_PLUGINS (parted by colons), and beside the program or the Python module. Then
/// come the libraries' folder of the same prefix, and where it was to be installed.
const void* module_table(const ModuleName& module, bool (*fits)(const void* table));

/// As above, of a table that begins with `const char* version`.
template <class Table>
const Table& module_table_of(const ModuleName& module) {
  return *static_cast<const Table*>(module_table(
      module, [](const void* t) { return std::strcmp(static_cast<const Table*>(t)->version, module_version()) == 0; }));
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The table of mesh formats: their names, extensions, writers and readers, and what each format can hold.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel {

struct RawMesh;

/// The parts of a mesh that a format can hold in addition to tetrahedra and named regions.
struct FormatHolds {
  bool second_order = false;
  bool prisms = false;       ///< cohesive layers
  bool curves = false;       ///< whether the format holds the edges or the nodes of curves under their names
  bool overlapping = false;  ///< whether a face of the mesh can belong to several groups
  bool names = true;  ///< whether the mesh file itself has names, so that they are not only in the JSON file beside it
  bool partitions = false;       ///< whether the format can hold a mesh divided into parts, with one file each
  bool triangles_alone = false;  ///< whether a mesh of triangles without tetrahedra can be written
};

struct Format {
  std::string name;  ///< in `output.formats`
  /// File extensions of the format, with the dot; files are written with the first one.
  std::vector<std::string> extensions;
  std::string what;  ///< description of the format in a few words
  FormatHolds holds;
  /// Writes a mesh to the file STEM + extension and to the files that belong to it. Returns the paths of all of them.
  std::vector<std::filesystem::path> (*write)(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem);
  RawMesh (*read)(const std::filesystem::path& file);  ///< null: not read
  /// Function that writes a starter input file of the format's solver beside existing mesh files, whose path without
  /// extension is `stem`. Null if the format has no starter input.
  std::filesystem::path (*starter)(const ModelMesh& mesh, const std::filesystem::path& stem) = nullptr;
  /// Rounds a coordinate as writing it to a file of this format does; null if files hold the same double.
  double (*rounded)(double coordinate) = nullptr;
};

/// Returns all mesh formats that this program was built with, in the order of the documents.
const std::vector<Format>& formats();
/// Returns the format with this name, or null if there is none.
const Format* format_of_name(const std::string& name);
/// Returns the first format with this extension (which includes the dot), or null if there is none.
const Format* format_of_extension(const std::string& extension);

/// Returns the format of an existing file by its extension, including parts of an Exodus mesh (NAME.e.N.K), or null if
/// there is none.
const Format* format_of_file(const std::filesystem::path& file);

/// Returns the name of the format, by its extension, of an output file given after `-o`; "html" for the report as a web
/// page. Throws Error{usage} if no format has this extension.
std::string format_name_of(const std::filesystem::path& output);

/// Returns the names of all mesh formats.
std::vector<std::string> mesh_formats();
/// Names accepted in `output.formats`: all mesh formats, and html for the report as a web page.
std::vector<std::string> known_formats();
/// File name extensions accepted after the option `-o`, with the dot.
std::vector<std::string> known_extensions();

/// Writes all files of one mesh format and returns their paths. `stem` is their path without extension. Faults are
/// split and midpoints are added before if the options request it. Throws Error{usage} if the format cannot hold what
/// the options request. If one of the files cannot be written, none of them is left behind.
std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& format,
                                                const std::filesystem::path& stem, const WriteOptions& options = {});

/// Reads the mesh file of any tool. The format is chosen by extension; sets become regions, surfaces, curves and named
/// nodes. Nodes that are not half-way between the ends of their edge become ModelMesh::curved_edges. `order` is set to
/// the order of the file's elements. Throws Error{usage} if the format cannot be read, and Error{invalid_input} if the
/// file cannot be understood.
ModelMesh read_model_mesh(const std::filesystem::path& file, ElementOrder* order = nullptr);

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The table of mesh formats: names, extensions, writers, readers, and what each can hold.
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
  bool prisms = false;           ///< cohesive layers
  bool curves = false;           ///< whether it holds edges on curves, or their nodes, under their names
  bool overlapping = false;      ///< whether one face can belong to several groups
  bool names = true;             ///< whether names are in the file itself, and not only in the JSON file beside it
  bool partitions = false;       ///< whether a mesh can be divided into parts with one file each
  bool triangles_alone = false;  ///< whether a mesh of triangles without tetrahedra can be written
};

struct Format {
  std::string name;                     ///< in `output.formats`
  std::vector<std::string> extensions;  ///< accepted file extensions with the dot; files are written with the first one
  std::string what;                     ///< description of the format in a few words
  FormatHolds holds;
  /// Writes the file STEM + extension and the files that belong to it; returns the paths of all of them.
  std::vector<std::filesystem::path> (*write)(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem);
  RawMesh (*read)(const std::filesystem::path& file);  ///< null: not read
  /// Writes a starter input of the solver beside the mesh files with this stem, which exist already. Null if the format
  /// has none.
  std::filesystem::path (*starter)(const ModelMesh& mesh, const std::filesystem::path& stem) = nullptr;
  double (*rounded)(double coordinate) = nullptr;  ///< a coordinate as the file holds it; null: the same double
};

/// All formats that this program was built with, in the order of the documents.
const std::vector<Format>& formats();
/// Returns the format with this name, or null if there is none.
const Format* format_of_name(const std::string& name);
/// Returns the first format with this extension (which includes the dot), or null if there is none.
const Format* format_of_extension(const std::string& extension);

/// Returns the format of an existing file by its extension, including parts of an Exodus mesh (NAME.e.N.K), or null if
/// there is none.
const Format* format_of_file(const std::filesystem::path& file);

/// Returns the name of the format for a file given after `-o`, by its extension; "html" for the report as a web page.
/// Throws Error{usage} if there is none.
std::string format_name_of(const std::filesystem::path& output);

/// Names of all formats.
std::vector<std::string> mesh_formats();
/// Names accepted in `output.formats`: all mesh formats, and html for the report as a web page.
std::vector<std::string> known_formats();
/// Extensions accepted after `-o`, with the dot.
std::vector<std::string> known_extensions();

/// Splits faults and adds midpoints if requested, then writes all files of one format with `stem` (a path without
/// extension); returns what was written. Throws Error{usage} if the format cannot hold what the options request. If one
/// of the files cannot be written, none of them is left behind.
std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& format,
                                                const std::filesystem::path& stem, const WriteOptions& options = {});

/// Reads the mesh file of any tool, chosen by extension; sets become regions, surfaces, curves and named nodes. Throws
/// Error{usage} where the format is not read, Error{invalid_input} where the file cannot be understood. Nodes in the
/// middle of edges that are not half-way become ModelMesh::curved_edges. `order` is set to the order of the file's
/// elements.
ModelMesh read_model_mesh(const std::filesystem::path& file, ElementOrder* order = nullptr);

}  // namespace geomesh::geomodel

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

/// What a format can hold beside tetrahedra and named regions.
struct FormatHolds {
  bool second_order = false;
  bool prisms = false;           ///< cohesive layers
  bool curves = false;           ///< edges on curves, or their nodes, under names
  bool overlapping = false;      ///< one face in several groups
  bool names = true;             ///< in the file itself; else only in the JSON beside it
  bool partitions = false;       ///< a file for each part
  bool triangles_alone = false;  ///< a mesh of triangles without tetrahedra
};

struct Format {
  std::string name;                     ///< in `output.formats`
  std::vector<std::string> extensions;  ///< with the dot; the first is written
  std::string what;                     ///< for people, in a few words
  FormatHolds holds;
  /// Files STEM + extension and what belongs to it; returns all that was written.
  std::vector<std::filesystem::path> (*write)(const ModelMesh& mesh, const WriteOptions& options,
                                              const std::filesystem::path& stem);
  RawMesh (*read)(const std::filesystem::path& file);  ///< null: not read
  /// A starter input beside the files STEM + extension, which are there; null: none.
  std::filesystem::path (*starter)(const ModelMesh& mesh, const std::filesystem::path& stem) = nullptr;
};

/// In the order of the documents. What was left out when the program was built is not in it.
const std::vector<Format>& formats();
/// Null where there is none.
const Format* format_of_name(const std::string& name);
/// The first with this extension (with the dot). Null where there is none.
const Format* format_of_extension(const std::string& extension);

/// By the extension of a file that is there; parts of an Exodus mesh (NAME.e.N.K) too. Null where there is none.
const Format* format_of_file(const std::filesystem::path& file);

/// The name of the format of a file after `-o`, by its extension; "html" for the report as a page. Throws Error{usage}
/// where there is none.
std::string format_name_of(const std::filesystem::path& output);

/// Names of all formats.
std::vector<std::string> mesh_formats();
/// Names accepted in `output.formats`: those of meshes, and html, the report as a page.
std::vector<std::string> known_formats();
/// Extensions accepted after `-o`, with the dot.
std::vector<std::string> known_extensions();

/// Splits faults and adds midpoints as asked, then writes all files of one format with `stem` (a path without
/// extension); returns what was written. Throws Error{usage} where the format cannot hold what the options ask for.
/// Leaves no file of the set behind where one of them cannot be written.
std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& format,
                                                const std::filesystem::path& stem, const WriteOptions& options = {});

/// A mesh file of any tool, by extension; sets become regions, surfaces, curves and named nodes. Throws Error{usage}
/// where the format is not read, Error{invalid_input} where the file cannot be understood. Nodes in the middle of edges
/// that are not half-way become ModelMesh::curved_edges. `order`: becomes that of the file's elements.
ModelMesh read_model_mesh(const std::filesystem::path& file, ElementOrder* order = nullptr);

}  // namespace geomesh::geomodel

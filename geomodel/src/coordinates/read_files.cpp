// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/read_files.hpp"

#include <map>

#include "geomesh/geomodel/readers.hpp"
#include "level_sets/level_surfaces.hpp"
#include "readers/objects_of_file.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

WellReading reading_of(const WellSpec& spec, const Project& project) {
  WellReading reading;
  reading.options = spec.source.reading;
  reading.head = spec.head;
  reading.head_is_depth = spec.source.depth.value_or(project.crs.depth);
  const std::string& unit = spec.source.unit.empty() ? project.crs.unit : spec.source.unit;
  reading.metres = length_unit_in_metres(unit).value_or(1);
  return reading;
}

/// Reads files. A file that several surfaces or wells name is read once; each of them gets its own object from it.
class SharedFiles {
 public:
  explicit SharedFiles(const Project& project) {
    for (const SurfaceSpec& spec : project.surfaces)
      if (!spec.given && spec.level_sets.empty()) ++n_users_[key(spec)];
  }

  FileContents contents_of(const SurfaceSpec& spec) {
    const std::string file = key(spec);
    if (n_users_[file] < 2) return read_surface_file(spec.file, spec.source.reading);
    const auto [known, is_first] = read_.try_emplace(file);
    if (is_first) known->second = read_surface_file(spec.file, spec.source.reading);
    const FileContents& all = known->second;
    FileContents part = object_named(all, spec.source.object.empty() ? spec.name : spec.source.object);
    // If no object in the file has the requested name, all its objects are returned: the only object of a file needs no
    // name, and a wrong name is rejected later.
    if (part.surfaces.empty() && part.point_sets.empty()) part = all;
    if (is_first) part.warnings = all.warnings, part.notes = all.notes;
    if (!is_first) part.warnings.clear();
    return part;
  }

 private:
  static std::string key(const SurfaceSpec& spec) {
    const ReadOptions& reading = spec.source.reading;
    std::string text = spec.file.string() + "\n";
    for (const ReadOptions::Column& c : reading.columns) text += c.meaning + "=" + c.column + "\n";
    return text + (reading.no_data ? std::to_string(*reading.no_data) : reading.keep_all_heights ? "none" : "");
  }
  std::map<std::string, std::size_t> n_users_;
  std::map<std::string, FileContents> read_;
};

FileContents contents_of(const SurfaceSpec& spec, SharedFiles& files) {
  if (spec.given) return *spec.given;
  if (spec.below_by) return {};  // a horizon at a constant thickness below another one has no file
  return spec.extrude.axis < 0 ? files.contents_of(spec) : read_section(spec.file, spec.extrude);
}

/// Returns the settings with which coordinates in a surface's file are interpreted. Thicknesses count up from zero.
const SourceSpec* source_of(const SurfaceSpec& spec, ReadFiles& files) {
  if (spec.below.empty()) return &spec.source;
  files.of_thicknesses.push_back(spec.source);
  files.of_thicknesses.back().depth = false;
  files.of_thicknesses.back().z_datum = 0;
  return &files.of_thicknesses.back();
}

}  // namespace

ReadFiles read_files(const Project& project, const RunContext& context) {
  ReadFiles files;
  // Reserves memory for all files' contents first, because reallocation would invalidate pointers in `sources`.
  files.contents.reserve(project.surfaces.size() + project.wells.size());
  SharedFiles shared(project);
  LevelSurfaces level_sets = make_level_surfaces(project);
  files.notes = std::move(level_sets.notes);
  files.field_parts = std::move(level_sets.parts);
  files.warnings = std::move(level_sets.warnings);
  const auto add = [&](const std::string& name, FileContents contents) {
    files.contents.push_back(std::move(contents));
    for (const std::string& text : files.contents.back().warnings) files.warnings.push_back(name + ": " + text);
    context.report(files.contents.size(), files.contents.capacity());
    context.check_cancelled();
  };
  for (const SurfaceSpec& spec : project.surfaces) {
    const auto level_set = level_sets.contents.find(files.contents.size());
    add(spec.name, level_set != level_sets.contents.end() ? std::move(level_set->second) : contents_of(spec, shared));
    if (!spec.below_by) files.sources.push_back({spec.name, source_of(spec, files), &files.contents.back()});
  }
  for (const WellSpec& spec : project.wells) {
    add(spec.name, spec.given ? *spec.given : read_well_file(spec.file, reading_of(spec, project)));
    files.sources.push_back({spec.name, &spec.source, &files.contents.back()});
  }
  return files;
}

}  // namespace geomesh::geomodel

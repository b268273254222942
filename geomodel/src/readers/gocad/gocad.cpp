// SPDX-License-Identifier: GPL-3.0-or-later
// Reads GOCAD ASCII: TSurf, PLine, VSet, Well and Model3d, several objects per file.
#include <algorithm>
#include <map>

#include "readers/formats.hpp"
#include "readers/gocad/gocad_model3d.hpp"
#include "readers/gocad/gocad_objects.hpp"

namespace geomesh::geomodel {
namespace {

std::string object_name(const GocadObject& object, const InputFile& file) {
  return object.name.empty() ? file.path.stem().string() : object.name;
}

void add_surface(const GocadObject& object, const InputFile& file, FileContents& contents) {
  if (object.triangles.empty()) {
    contents.warnings.push_back("surface '" + object_name(object, file) + "' (line " + std::to_string(object.line) +
                                ") has no triangles and is left out");
    return;
  }
  TriangulatedSurface surface;
  surface.name = object_name(object, file);
  surface.file = file.shown();
  surface.points = object.points;
  surface.triangles = object.triangles;
  contents.surfaces.push_back(std::move(surface));
}

void add_polylines(const GocadObject& object, const InputFile& file, FileContents& contents) {
  const std::string name = object_name(object, file);
  if (object.lines.empty()) {
    contents.warnings.push_back("polyline '" + name + "' (line " + std::to_string(object.line) +
                                ") has no segments and is left out");
  }
  for (std::size_t i = 0; i < object.lines.size(); ++i) {
    Polyline line{object.lines.size() == 1 ? name : name + "__" + std::to_string(i + 1), file.shown(), {}};
    for (const VertexIndex v : object.lines[i]) line.points.push_back(object.points[v]);
    contents.polylines.push_back(std::move(line));
  }
}

void add_well(const GocadObject& object, const InputFile& file, FileContents& contents) {
  const std::string name = object_name(object, file);
  if (object.path.size() < 2) {
    contents.warnings.push_back("well '" + name + "' has no path and is left out");
    return;
  }
  contents.polylines.push_back({name, file.shown(), object.path});
}

/// Describes the coordinate frame of the first object as that of the GOCAD file. Differences among the objects are
/// reported; each object was converted by its own frame.
void describe_frame(const std::vector<GocadObject>& objects, FileContents& contents) {
  const auto first = std::find_if(objects.begin(), objects.end(), [](const GocadObject& o) { return o.frame.given; });
  if (first == objects.end()) {
    contents.notes.push_back(
        "no coordinate system block: the unit and direction of z are not named (elevation in metres, or as the project "
        "says)");
    return;
  }
  const GocadFrame& f = first->frame;
  contents.frame.unit = f.unit[0];
  if (f.unit[2] != f.unit[0]) contents.frame.z_unit = f.unit[2];
  contents.frame.depth = f.depth;
  contents.frame.z_named = true;
  for (const std::string& part : {f.name, f.projection, f.datum}) {
    if (part.empty() || equals_ignoring_case(part, "Unknown") || equals_ignoring_case(part, "Default")) continue;
    contents.frame.crs += (contents.frame.crs.empty() ? "" : ", ") + part;
  }
  if (f.depth) contents.notes.push_back("ZPOSITIVE Depth: z negated, winding of the triangles swapped");
  for (std::size_t i = 0; i < 3; ++i) {
    if (f.scale[i] != 1) contents.notes.push_back(std::string(1, "xyz"[i]) + " converted from " + f.unit[i] + " to m");
  }
  for (const GocadObject& o : objects) {
    if (!o.frame.given || (o.frame.depth == f.depth && std::equal(o.frame.unit, o.frame.unit + 3, f.unit))) continue;
    contents.warnings.push_back("object '" + o.name + "' has another unit or z direction than '" + first->name +
                                "'; each was converted by its own");
    return;
  }
}

/// Warns if a file declares z as depth but has negative z, because such values are usually elevations.
void warn_of_negative_depths(const std::vector<GocadObject>& objects, FileContents& contents) {
  std::size_t n_points = 0, n_negative = 0;
  for (const GocadObject& o : objects) {
    if (!o.frame.depth) continue;
    n_points += o.points.size();
    n_negative += static_cast<std::size_t>(
        std::count_if(o.points.begin(), o.points.end(), [](const Vec3& p) { return p.z > 0; }));
  }
  if (2 * n_negative <= n_points) return;
  contents.warnings.push_back(
      "the file says ZPOSITIVE Depth, yet " + std::to_string(n_negative) + " of its " + std::to_string(n_points) +
      " z are negative: they come to lie above zero; if they are elevations, it should say ZPOSITIVE Elevation");
}

void refuse_where_nothing_was_read(const std::vector<GocadObject>& objects, const InputFile& file,
                                   const FileContents& contents) {
  if (!contents.surfaces.empty() || !contents.polylines.empty() || !contents.point_sets.empty()) return;
  std::string kinds;
  for (const GocadObject& o : objects) kinds += (kinds.empty() ? "" : ", ") + o.kind + " '" + o.name + "'";
  file.fail("nothing to read: it holds " + kinds + "; a TSurf, PLine, VSet, Well or Model3d with content was expected");
}

}  // namespace

bool is_gocad(const InputFile& file) {
  LineReader lines(file);
  while (lines.next()) {
    Tokens tokens(lines.line());
    const std::string_view word = tokens.next();
    if (word.empty() || word.front() == '#') continue;
    return word == "GOCAD";
  }
  return false;
}

FileContents read_gocad(const InputFile& file) {
  const std::vector<GocadObject> objects = parse_gocad_objects(file);
  FileContents contents;
  std::map<std::string, int> skipped;
  for (const GocadObject& object : objects) {
    if (object.kind == "TSurf") {
      add_surface(object, file, contents);
    } else if (object.kind == "PLine") {
      add_polylines(object, file, contents);
    } else if (object.kind == "VSet") {
      contents.point_sets.push_back({object_name(object, file), file.shown(), object.points});
    } else if (object.kind == "Well") {
      add_well(object, file, contents);
    } else if (object.kind != "Model3d") {
      ++skipped[object.kind];
    }
  }
  for (const GocadObject& object : objects)
    for (const std::string& name : object.properties)
      if (std::find(contents.arrays.begin(), contents.arrays.end(), name) == contents.arrays.end())
        contents.arrays.push_back(name);
  for (const auto& [kind, n] : skipped) {
    contents.notes.push_back(std::to_string(n) + " object(s) of kind " + kind + " passed over");
  }
  refuse_where_nothing_was_read(objects, file, contents);
  contents.format = "GOCAD " + objects.front().kind;
  describe_frame(objects, contents);
  warn_of_negative_depths(objects, contents);
  for (const GocadObject& object : objects) {
    if (object.kind == "Model3d") add_model3d_regions(object, objects, contents);
  }
  return contents;
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/project_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>

#include "coordinates/read_files.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/fault_polygons.hpp"
#include "geomesh/geomodel/gridding.hpp"
#include "geomesh/geomodel/section.hpp"
#include "geomesh/geomodel/sticks.hpp"
#include "geomesh/geomodel/words.hpp"
#include "level_sets/level_surfaces.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the object of a file that a surface uses: the one with the requested name, the one named like the surface,
/// or the only one; else nullptr.
template <class Object>
Object* object_of(std::vector<Object>& objects, const SurfaceSpec& spec, bool only_one) {
  const std::string& wanted = spec.source.object.empty() ? spec.name : spec.source.object;
  for (Object& object : objects)
    if (object.name == wanted) return &object;
  return only_one && objects.size() == 1 && spec.source.object.empty() ? &objects.front() : nullptr;
}

[[noreturn]] void refuse_choice(const FileContents& contents, const SurfaceSpec& spec) {
  std::string names;
  for (const TriangulatedSurface& s : contents.surfaces) names += (names.empty() ? "" : ", ") + s.name;
  for (const PointSet& s : contents.point_sets) names += (names.empty() ? "" : ", ") + s.name;
  std::string last;
  for (const Polyline& line : contents.polylines)
    if (const std::string name = name_without_part(line.name); name != last)
      names += (names.empty() ? "" : ", ") + name, last = name;
  const std::string what = "surface " + spec.name + ": " + spec.file_as_written + " (" + contents.format + ")";
  if (names.empty()) throw Error(ErrorKind::invalid_input, what + " holds no surface, no points and no lines");
  throw Error(ErrorKind::invalid_input, what + " holds " + names + ", and none is called " +
                                            (spec.source.object.empty() ? spec.name : spec.source.object) +
                                            ": name the one you mean with 'object' in the entry");
}

std::string length_text(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

std::string gridding_note(const SurfaceSpec& spec, const GriddedSurface& g) {
  std::string text = spec.name + ": surface made from " + std::to_string(g.n_points) + " points, ";
  if (spec.gridding.method == GriddingSpec::Method::triangulate) {
    text += "triangulated as they are";
  } else {
    text += "thin plate with smoothing length " + length_text(g.smoothing) + " on a grid of spacing " +
            length_text(g.spacing) + " (" + std::to_string(g.n_nodes) + " nodes)";
  }
  return text + "; residual at the points: rms " + length_text(g.rms_residual) + ", largest " +
         length_text(g.largest_residual);
}

/// Records how far a surface is from the data from which it was made. This uses up nothing of the tolerance, which
/// counts from the resulting surface.
void book(ProjectInputs& inputs, const SurfaceSpec& spec, const char* stage, double moved,
          std::optional<Vec3> place = std::nullopt) {
  ToleranceUse use{stage};
  use.moved = std::abs(moved);
  use.surface = spec.name;
  if (moved != 0) use.place = place;
  inputs.uses.push_back(std::move(use));
}

TriangulatedSurface surface_of_points(const PointSet& set, const SurfaceSpec& spec, const std::optional<Box3>& box,
                                      ProjectInputs& inputs) {
  if (spec.gridding.to_box && !box)
    throw Error(ErrorKind::usage,
                "surface " + spec.name +
                    ": gridding.extent is box, which is known beforehand for a box with min and max alone");
  const GraphOver over = spec.kind == SurfaceKind::horizon ? GraphOver::map : GraphOver::mean_plane;
  if (spec.kind == SurfaceKind::body) {
    throw Error(ErrorKind::invalid_input, "surface " + spec.name + ": " + spec.file_as_written +
                                              " holds points; a body needs a closed triangulated surface");
  }
  GriddedSurface made = grid_points(set.points, spec.gridding, over, box ? &*box : nullptr);
  inputs.notes.push_back(gridding_note(spec, made));
  book(inputs, spec, "gridding", made.largest_residual, made.largest_place);
  if (spec.kind == SurfaceKind::horizon && spec.gridding.method == GriddingSpec::Method::thin_plate)
    inputs.gridded[static_cast<Index>(inputs.surfaces.size() - 1)] = {set.points, spec.gridding, made.spacing};
  if (made.n_outside > 0) {
    inputs.warnings.push_back(spec.name + ": " + std::to_string(made.n_outside) +
                              " of its points are not over the surface made from them");
  }
  return std::move(made.surface);
}

void remake(TriangulatedSurface& surface, const SurfaceSpec& spec, ProjectInputs& inputs) {
  const GraphOver over = spec.kind == SurfaceKind::horizon ? GraphOver::map : GraphOver::mean_plane;
  if (spec.smooth > 0) {
    const SurfaceChange change = smooth_surface(surface, spec.smooth, over);
    inputs.notes.push_back(spec.name + ": smoothed in " + std::to_string(spec.smooth) +
                           " passes; vertices moved by rms " + length_text(change.rms_move) + ", at most " +
                           length_text(change.largest_move));
    book(inputs, spec, "smoothing", change.largest_move);
  }
  if (spec.resample > 0) {
    const SurfaceChange change = resample_surface(surface, spec.resample, over);
    inputs.notes.push_back(spec.name + ": remade with edges of about " + length_text(spec.resample) + " (" +
                           std::to_string(change.n_triangles) + " triangles); former vertices are off it by rms " +
                           length_text(change.rms_move) + ", at most " + length_text(change.largest_move));
    book(inputs, spec, "resampling", change.largest_move);
  }
}

/// Returns the lines of a file that a surface uses: those of the requested object, those named like the surface, or all
/// if they belong to one object.
std::vector<Polyline> lines_of(const FileContents& contents, const SurfaceSpec& spec, bool only_lines) {
  const std::string& wanted = spec.source.object.empty() ? spec.name : spec.source.object;
  std::vector<Polyline> lines;
  for (const Polyline& line : contents.polylines)
    if (line.name == wanted || name_without_part(line.name) == wanted) lines.push_back(line);
  if (!lines.empty() || !only_lines || contents.polylines.empty() || !spec.source.object.empty()) return lines;
  const std::string object = name_without_part(contents.polylines.front().name);
  const bool is_one_object = std::all_of(contents.polylines.begin(), contents.polylines.end(),
                                         [&](const Polyline& line) { return name_without_part(line.name) == object; });
  return is_one_object ? contents.polylines : lines;
}

/// Throws if lines are no fault sticks because each has a single height: traces on a map, or contours.
void refuse_one_height(const std::vector<Polyline>& lines, const SurfaceSpec& spec) {
  const double height = lines.front().points.front().z;
  for (const Polyline& line : lines)
    for (const Vec3& p : line.points)
      if (p.z != height) return;
  throw Error(
      ErrorKind::invalid_input,
      "surface " + spec.name + ": the lines of " + spec.file_as_written + " all lie at height " + length_text(height) +
          ", as traces on a map do; lines that go down the surface (sticks), or at several heights, were expected");
}

/// Makes a surface from lines. The sticks of a fault are joined unchanged, unless `gridding` requests a grid spacing or
/// a triangulation; the points of other lines, such as contours, are gridded.
TriangulatedSurface surface_of_lines(const std::vector<Polyline>& lines, const SurfaceSpec& spec,
                                     const std::optional<Box3>& box, ProjectInputs& inputs) {
  const GriddingSpec& gridding = spec.gridding;
  const bool as_points = spec.kind != SurfaceKind::fault || gridding.method == GriddingSpec::Method::triangulate ||
                         gridding.spacing > 0 || gridding.smoothing > 0;
  if (spec.kind == SurfaceKind::fault) refuse_one_height(lines, spec);
  if (as_points) {
    PointSet points{spec.name, spec.file_as_written, {}};
    for (const Polyline& line : lines)
      points.points.insert(points.points.end(), line.points.begin(), line.points.end());
    return surface_of_points(points, spec, box, inputs);
  }
  SurfaceOfSticks made;
  try {
    made = surface_of_sticks(lines, spec.gridding.max_distance);
  } catch (const Error& e) {
    throw Error(e.kind(), "surface " + spec.name + ": " + spec.file_as_written + ": " + e.what());
  }
  inputs.notes.push_back(spec.name + ": surface made between " + std::to_string(made.n_sticks) +
                         " lines, which it passes through");
  if (made.n_gaps > 0)
    inputs.warnings.push_back(spec.name + ": " + std::to_string(made.n_gaps) +
                              " gaps between its lines are wider than gridding.max_distance and stay open");
  if (made.n_folded > 0)
    inputs.warnings.push_back(spec.name + ": its lines cross or double back near (" + length_text(made.fold.x) + ", " +
                              length_text(made.fold.y) + ", " + length_text(made.fold.z) +
                              "), and the surface folds at " + std::to_string(made.n_folded) +
                              " triangles; gridding: {smoothing: L} makes a smooth surface near their points");
  return std::move(made.surface);
}

/// Returns the surface that an input contains, or makes a surface from its points or lines.
TriangulatedSurface raw_surface(FileContents& contents, const SurfaceSpec& spec, const std::optional<Box3>& box,
                                ProjectInputs& inputs) {
  const bool one_object = contents.surfaces.size() + contents.point_sets.size() == 1;
  TriangulatedSurface surface;
  if (TriangulatedSurface* s = object_of(contents.surfaces, spec, one_object || contents.surfaces.size() == 1)) {
    surface = std::move(*s);
  } else if (const PointSet* p = object_of(contents.point_sets, spec, one_object)) {
    surface = surface_of_points(*p, spec, box, inputs);
  } else if (const auto lines = lines_of(contents, spec, contents.surfaces.empty() && contents.point_sets.empty());
             !lines.empty()) {
    surface = surface_of_lines(lines, spec, box, inputs);
  } else {
    refuse_choice(contents, spec);
  }
  return surface;
}

TriangulatedSurface section_surface(const FileContents& contents, const SurfaceSpec& spec, const Vec3& origin) {
  std::vector<Polyline> lines;
  for (const Polyline& line : contents.polylines)
    if (spec.source.object.empty() || line.name == spec.source.object) lines.push_back(line);
  if (lines.empty()) refuse_choice(contents, spec);
  ExtrudeSpec extrude = spec.extrude;
  const double shift = origin[extrude.axis == 1 ? 1 : 0];
  extrude.from -= shift;
  extrude.to -= shift;
  return extrude_lines(lines, extrude, spec.kind == SurfaceKind::body, spec.name);
}

void finish_surface(TriangulatedSurface& surface, const SurfaceSpec& spec, const Project& project,
                    ProjectInputs& inputs) {
  remake(surface, spec, inputs);
  surface.name = spec.name;
  surface.kind = spec.kind;
  surface.cuts_all = spec.cuts_all;
  surface.file = spec.file_as_written;
  surface.ends_model = spec.name == project.rules.topography || spec.name == project.rules.floor;
}

/// Makes the horizons that are defined by their thickness below another horizon, each after the one above it.
void make_below(const Project& project, std::vector<FileContents>& contents, const std::optional<Box3>& box,
                ProjectInputs& inputs) {
  std::vector<std::size_t> waiting;
  for (std::size_t s = 0; s < project.surfaces.size(); ++s)
    if (!project.surfaces[s].below.empty()) waiting.push_back(s);
  while (!waiting.empty()) {  // the loop ends: chains of horizons made from thicknesses were checked for cycles
    const auto ready = std::find_if(waiting.begin(), waiting.end(), [&](std::size_t s) {
      return std::none_of(waiting.begin(), waiting.end(),
                          [&](std::size_t other) { return project.surfaces[other].name == project.surfaces[s].below; });
    });
    const std::size_t s = *ready;
    waiting.erase(ready);
    const SurfaceSpec& spec = project.surfaces[s];
    const auto above = std::find_if(inputs.surfaces.begin(), inputs.surfaces.end(),
                                    [&](const TriangulatedSurface& a) { return a.name == spec.below; });
    BelowSurface below;
    if (spec.below_by) {
      below = surface_below(*above, *spec.below_by);
    } else {
      TriangulatedSurface thickness = raw_surface(contents[s], spec, box, inputs);
      // A thickness is not a position, so the subtraction of the origin is undone.
      for (Vec3& p : thickness.points) p.z += project.output.origin.z;
      below = surface_below(*above, thickness);
    }
    if (below.surface.triangles.empty())
      throw Error(ErrorKind::invalid_input, "horizon " + spec.name + ": its thickness (" + spec.file_as_written +
                                                ") lies nowhere over " + spec.below +
                                                ": are both in the same coordinates (crs, unit)?");
    inputs.notes.push_back("horizon " + spec.name + ": " + length_text(below.least) + " to " + length_text(below.most) +
                           " below " + spec.below);
    if (below.n_without > 0)
      inputs.warnings.push_back("horizon " + spec.name + ": " + std::to_string(below.n_without) + " vertices of " +
                                spec.below + " have no thickness over them; it has a hole or an end there");
    if (below.n_negative > 0)
      inputs.warnings.push_back("horizon " + spec.name + ": the thickness is below zero at " +
                                std::to_string(below.n_negative) + " vertices of " + spec.below +
                                ": taken as zero (is the file a thickness?)");
    inputs.surfaces[s] = std::move(below.surface);
    finish_surface(inputs.surfaces[s], spec, project, inputs);
  }
}

/// Adds the paths of a well: the lines of the requested object, else those named like the well, else all lines.
void take_wells(FileContents& contents, const WellSpec& spec, std::vector<Polyline>& wells) {
  const bool all = spec.source.object == "*";
  std::string wanted = all ? "" : spec.source.object;
  const auto is_there = [&](const std::string& name) {
    return std::any_of(contents.polylines.begin(), contents.polylines.end(),
                       [&](const Polyline& line) { return line.name == name; });
  };
  if (wanted.empty() && !all && is_there(spec.name)) wanted = spec.name;
  if (contents.polylines.empty() || (!wanted.empty() && !is_there(wanted))) {
    std::string names;
    for (const Polyline& line : contents.polylines) names += (names.empty() ? "" : ", ") + line.name;
    throw Error(ErrorKind::invalid_input,
                "well " + spec.name + ": " + spec.file_as_written + " (" + contents.format +
                    ") holds no path of a well" +
                    (wanted.empty() ? "; a table with x, y, z or a deviation survey, GOCAD PLine or Well, DXF or VTP "
                                      "lines were expected"
                                    : " called " + wanted + (names.empty() ? "" : "; it holds " + names)));
  }
  for (Polyline& line : contents.polylines) {
    if (!wanted.empty() && line.name != wanted) continue;
    line.name = contents.polylines.size() == 1 || !wanted.empty() ? spec.name : spec.name + "_" + line.name;
    wells.push_back(std::move(line));
  }
}

/// Returns the well tops of the table, in its order, that are on a well and belong to a horizon of the project.
std::vector<FittedTop> place_tops(const Project& project, ProjectInputs& inputs) {
  std::vector<FittedTop> tops;
  std::map<std::string, std::size_t> unknown;
  for (const WellTop& top : read_tops(project.tops.file)) {
    const auto well = std::find_if(inputs.wells.begin(), inputs.wells.end(),
                                   [&](const Polyline& line) { return line.name == top.well; });
    const bool is_horizon = std::any_of(project.surfaces.begin(), project.surfaces.end(), [&](const SurfaceSpec& spec) {
      return spec.kind == SurfaceKind::horizon && spec.name == top.horizon;
    });
    if (well == inputs.wells.end()) ++unknown["no well is called " + top.well];
    if (!is_horizon) ++unknown["no horizon is called " + top.horizon];
    if (well == inputs.wells.end() || !is_horizon) continue;
    const bool is_height = project.tops.depth == TopsSpec::Depth::z;
    const double depth = is_height ? inputs.frame.point({0, 0, top.depth}).z : top.depth;
    if (const auto place = place_on_path(well->points, depth, is_height)) {
      tops.push_back({top.well, top.horizon, *place});
    } else {
      inputs.warnings.push_back("top of " + top.horizon + " in " + top.well + ": the well does not reach " +
                                length_text(top.depth) + " (" + project.tops.file_as_written + ":" +
                                std::to_string(top.line) + ")");
    }
  }
  for (const auto& [what, n] : unknown)
    inputs.warnings.push_back(project.tops.file_as_written + ": " + what + "; " + std::to_string(n) +
                              " tops are passed over");
  return tops;
}

/// Moves horizons to their well tops and reports how far: if `of_below` is set, the horizons made from a thickness
/// below another horizon, else all other horizons.
void fit_tops(const Project& project, const std::vector<FittedTop>& placed, bool of_below, ProjectInputs& inputs) {
  for (std::size_t s = 0; s < inputs.surfaces.size(); ++s) {
    if (project.surfaces[s].below.empty() == of_below) continue;
    TriangulatedSurface& surface = inputs.surfaces[s];
    std::vector<FittedTop> tops;
    std::copy_if(placed.begin(), placed.end(), std::back_inserter(tops),
                 [&](const FittedTop& top) { return top.horizon == surface.name; });
    if (tops.empty()) continue;
    fit_to_tops(surface, tops, project.tops.reach);
    double squares = 0, largest = 0;
    std::size_t n = 0;
    for (const FittedTop& top : tops) {
      if (std::isnan(top.misfit_given)) {
        inputs.warnings.push_back("top of " + top.horizon + " in " + top.well +
                                  ": the horizon is neither over nor under it; it moves nothing");
        continue;
      }
      squares += top.misfit_given * top.misfit_given;
      largest = std::max(largest, std::abs(top.misfit_given));
      ++n;
    }
    if (n > 0)
      inputs.notes.push_back(surface.name + ": moved along the vertical to " + std::to_string(n) +
                             " tops of wells, which were off it by rms " +
                             length_text(std::sqrt(squares / static_cast<double>(n))) + ", at most " +
                             length_text(largest));
    inputs.tops.insert(inputs.tops.end(), tops.begin(), tops.end());
  }
}

/// Removes from each horizon the parts inside its fault polygons. `read` reads and converts the polygons.
template <class Read>
void cut_polygons(const Project& project, Read&& read, ProjectInputs& inputs) {
  inputs.faults_of_polygons.resize(project.surfaces.size());
  for (std::size_t i = 0; i < project.surfaces.size(); ++i) {
    const SurfaceSpec& spec = project.surfaces[i];
    if (spec.fault_polygons.file.empty()) continue;
    const FileContents contents = read(spec.name, spec.fault_polygons);
    std::vector<Polyline> polygons;
    for (const Polyline& line : contents.polylines)
      if (spec.fault_polygons.source.object.empty() || line.name == spec.fault_polygons.source.object)
        polygons.push_back(line);
    PolygonCut cut = cut_at_polygons(inputs.surfaces[i], polygons, inputs.surfaces);
    for (const std::string& fault : cut.faults) {
      const std::vector<std::string>& listed = spec.rules.throw_at;
      if (!listed.empty() && std::find(listed.begin(), listed.end(), fault) == listed.end())
        cut.warnings.push_back("horizon " + spec.name + ": a fault polygon is passed by " + fault +
                               ", which its throw_at does not name");
    }
    std::move(cut.notes.begin(), cut.notes.end(), std::back_inserter(inputs.notes));
    std::move(cut.warnings.begin(), cut.warnings.end(), std::back_inserter(inputs.warnings));
    inputs.faults_of_polygons[i] = std::move(cut.faults);
  }
}

/// Keeps in `gridded` (horizons interpolated from points) only those that are used exactly as interpolated.
void keep_unchanged(const Project& project, ProjectInputs& inputs) {
  const auto is_changed = [&](const SurfaceSpec& spec) {
    return spec.smooth > 0 || spec.resample > 0 || !spec.below.empty() || !spec.fault_polygons.file.empty() ||
           std::ranges::any_of(inputs.tops, [&](const FittedTop& top) { return top.horizon == spec.name; }) ||
           std::ranges::any_of(project.surfaces, [&](const SurfaceSpec& s) { return s.below == spec.name; });
  };
  std::erase_if(inputs.gridded, [&](const auto& entry) {
    return inputs.surfaces[entry.first].ends_model || is_changed(project.surfaces[entry.first]);
  });
}

}  // namespace

void ProjectInputs::add_throws(ModelRules& rules) const {
  for (std::size_t s = 0; s < rules.surfaces.size() && s < faults_of_polygons.size(); ++s)
    if (rules.surfaces[s].throw_at.empty()) rules.surfaces[s].throw_at = faults_of_polygons[s];
}

void ProjectInputs::complete_field_parts(ModelRules& rules) const {
  for (const auto& [row, parts] : field_parts)
    for (std::size_t k = 0; k < parts.size(); ++k) {
      FieldPart& part = rules.surfaces[row].field_parts[k];
      part.end = parts[k].end;
      part.field = parts[k].field;
      part.doubts = parts[k].doubts;
      if (part.block) part.block = frame.point(*part.block);
      for (FieldPart::Doubt& doubt : part.doubts)
        for (Vec3& place : doubt.places) place = frame.point(place);
    }
}

ProjectInputs read_project_inputs(const Project& project, const RunContext& context) {
  ReadFiles files = read_files(project, context);
  ProjectInputs inputs{ModelFrame(project, files.sources)};
  inputs.warnings = std::move(files.warnings);
  inputs.notes = std::move(files.notes);
  inputs.field_parts = std::move(files.field_parts);
  for (const SourceInput& source : files.sources) inputs.frame.place(source, inputs.notes, inputs.warnings);
  std::optional<Box3> box;
  if (project.box) {
    std::string box_note;
    inputs.volume = inputs.frame.volume(*project.box, box_note);
    if (inputs.volume->shape == VolumeSpec::Shape::box) box = inputs.volume->box;
    if (!box_note.empty()) inputs.notes.push_back(box_note);
  }
  for (std::size_t i = 0; i < project.surfaces.size(); ++i) {
    const SurfaceSpec& spec = project.surfaces[i];
    inputs.surfaces.emplace_back();
    if (!spec.below.empty()) continue;
    inputs.surfaces.back() = spec.extrude.axis >= 0 ? section_surface(files.contents[i], spec, project.output.origin)
                                                    : raw_surface(files.contents[i], spec, box, inputs);
    finish_surface(inputs.surfaces.back(), spec, project, inputs);
    context.check_cancelled();
  }
  for (std::size_t i = 0; i < project.wells.size(); ++i)
    take_wells(files.contents[project.surfaces.size() + i], project.wells[i], inputs.wells);
  const std::vector<FittedTop> tops =
      project.tops.file.empty() ? std::vector<FittedTop>{} : place_tops(project, inputs);
  fit_tops(project, tops, false, inputs);
  make_below(project, files.contents, box, inputs);
  fit_tops(project, tops, true, inputs);
  cut_polygons(
      project,
      [&](const std::string& name, const FaultPolygonsSpec& spec) {
        FileContents polygons = read_fault_polygons(spec.file);
        inputs.frame.place({name, &spec.source, &polygons}, inputs.notes, inputs.warnings);
        return polygons;
      },
      inputs);
  keep_unchanged(project, inputs);
  for (const NamedPoint& point : project.points) inputs.points.push_back({point.name, inputs.frame.point(point.point)});
  std::size_t n_triangles = 0;
  for (const TriangulatedSurface& surface : inputs.surfaces) n_triangles += surface.triangles.size();
  context.note(LogLevel::info,
               std::to_string(inputs.surfaces.size()) + " surfaces, " + std::to_string(n_triangles) + " triangles");
  return inputs;
}

}  // namespace geomesh::geomodel

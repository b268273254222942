// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text/frame.hpp"

#include <algorithm>

#include "readers/text/text.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

double metres(const InputFile& file, const std::string& unit) {
  if (const auto m = length_unit_in_metres(unit)) return *m;
  if (is_time_unit(unit)) {
    file.fail("the unit is " + in_quotes(unit) +
              ": a surface in time cannot be meshed with others in length; convert it to depth first");
  }
  file.fail("the unit " + in_quotes(unit) + " is not known; m, km, cm, mm, ft, ftUS, in or yd were expected");
}

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

void scale_contents(FileContents& contents, const AxisScale& scale) {
  if (scale.xy == 1 && scale.z == 1) return;
  const auto scaled = [&](Vec3& p) { p = {scale.xy * p.x, scale.xy * p.y, scale.z * p.z}; };
  for (TriangulatedSurface& s : contents.surfaces) {
    std::for_each(s.points.begin(), s.points.end(), scaled);
    const bool from_grid = std::any_of(contents.grids.begin(), contents.grids.end(),
                                       [&](const GridSummary& g) { return g.surface == s.name; });
    if (scale.z < 0 && !from_grid)
      for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  }
  for (Polyline& l : contents.polylines) std::for_each(l.points.begin(), l.points.end(), scaled);
  for (PointSet& s : contents.point_sets) std::for_each(s.points.begin(), s.points.end(), scaled);
  for (NamedPoint& p : contents.points) scaled(p.point);
  for (GridSummary& g : contents.grids) {
    g.origin = {scale.xy * g.origin.x, scale.xy * g.origin.y};
    g.spacing = {scale.xy * g.spacing.x, scale.xy * g.spacing.y};
  }
}

void convert_by_frame(const InputFile& file, FileContents& contents) {
  const SourceFrame& frame = contents.frame;
  const std::string& z_unit = frame.z_unit.empty() ? frame.unit : frame.z_unit;
  AxisScale scale{metres(file, frame.unit), metres(file, z_unit)};
  if (scale.xy != 1 && !frame.geographic) contents.notes.push_back("x and y converted from " + frame.unit + " to m");
  if (frame.geographic) scale.xy = 1;
  if (scale.z != 1) contents.notes.push_back("z converted from " + z_unit + " to m");
  if (frame.depth) {
    scale.z = -scale.z;
    contents.notes.push_back("z is depth in the file: negated");
  }
  scale_contents(contents, scale);
}

HeightColumn height_column(std::string_view name) {
  const std::string n = to_lower(name);
  if (one_of(n, {"z", "elevation", "elev", "height", "altitude", "alt", "z_coord", "zcoord", "coord_z", "zz", "msl",
                 "elevation_msl", "z-coordinate", "h\u00f6he", "hoehe", "altitud"}))
    return {true, false, false};
  if (one_of(n, {"depth", "tvd", "tvdss", "tvd_ss", "tvdmsl", "z_depth", "depth_ss", "depthss", "depth_msl", "tiefe",
                 "teufe", "profondeur", "profundidad"}))
    return {true, true, false};
  if (one_of(n, {"twt", "time", "t0", "two-way-time", "two_way_time", "owt"})) return {true, false, true};
  return {};
}

}  // namespace geomesh::geomodel

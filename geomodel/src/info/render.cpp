// SPDX-License-Identifier: GPL-3.0-or-later
// Formats the description of a file as text and as JSON, declared in geomesh/geomodel/info.hpp.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/info.hpp"

namespace geomesh::geomodel {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string bounds_text(const Box3& b) {
  if (b.empty()) return "no extent";
  char text[256];
  std::snprintf(text, sizeof text, "x %.8g to %.8g, y %.8g to %.8g, z %.8g to %.8g", b.min.x, b.max.x, b.min.y, b.max.y,
                b.min.z, b.max.z);
  return text;
}

nlohmann::ordered_json bounds_json(const Box3& b) {
  if (b.empty()) return nullptr;
  return {{"min", {b.min.x, b.min.y, b.min.z}}, {"max", {b.max.x, b.max.y, b.max.z}}};
}

std::string surface_text(const SurfaceInfo& s) {
  std::string text = "surface " + s.name + ": " + count(s.n_triangles, "triangle", "triangles") + ", " +
                     count(s.n_distinct_points, "point", "points") + ", " + count(s.n_components, "piece", "pieces") +
                     "\n";
  if (s.n_distinct_points != s.n_points)
    text += "  " + std::to_string(s.n_points - s.n_distinct_points) +
            " points repeat the coordinates of another (one vertex when meshed)\n";
  text += "  " + bounds_text(s.bounds) + "\n  area " + number(s.area);
  if (s.closed) {
    text += s.volume > 0 ? ", closed, encloses " + number(s.volume) : std::string(", closed");
  } else {
    text += ", open: " + count(s.n_borders, "border", "borders") + " of " + count(s.n_border_edges, "edge", "edges") +
            ", length " + number(s.border_length) + ", " +
            (s.n_holes == 0 ? "no hole" : count(s.n_holes, "hole", "holes"));
  }
  return text + "\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : ", ") + w;
  return text;
}

std::string mesh_text(const MeshInfo& m) {
  std::string text = "mesh: " + count(m.n_tetrahedra, "tetrahedron", "tetrahedra") + ", " +
                     count(m.n_points, "point", "points") + "\n  " + bounds_text(m.bounds) + "\n";
  if (!m.region_array.empty())
    text += "  " + count(m.regions.size(), "region", "regions") + " from array " + m.region_array + ":\n";
  for (const MeshInfo::Region& r : m.regions)
    text += "    " + std::to_string(r.id) + "  " + r.name + "  " + count(r.n_tetrahedra, "tetrahedron", "tetrahedra") +
            ", volume " + number(r.volume) + "\n";
  text += "  volume " + number(m.volume) + "\n";
  if (!m.arrays.empty()) text += "  arrays: " + joined(m.arrays) + "\n";
  return text;
}

/// Describes the coordinate frame of a file before conversion to metres with elevation up.
std::string frame_text(const SourceFrame& f) {
  std::string text = f.geographic ? "x longitude, y latitude (degrees)"
                                  : "unit " + (f.unit.empty() ? "not named (m, or the project's)" : f.unit);
  if (!f.z_unit.empty()) text += ", z in " + f.z_unit;
  text += std::string(", z ") + (f.depth     ? "depth"
                                 : f.z_named ? "elevation"
                                             : "not said to be depth or elevation (elevation, or the project's)");
  return "coordinates: " + text + ", system " + (f.crs.empty() ? "not named" : f.crs) + "\n";
}

std::string grid_text(const GridSummary& g) {
  std::string text =
      "grid " + g.surface + ": " + count(g.n_columns, "column", "columns") + ", " + count(g.n_rows, "row", "rows");
  if (g.spacing.x != 0) {
    char numbers[200];
    std::snprintf(numbers, sizeof numbers, ", spacing %.8g by %.8g from (%.10g, %.10g)", g.spacing.x, g.spacing.y,
                  g.origin.x, g.origin.y);
    text += numbers;
  }
  if (g.rotation != 0) text += ", turned by " + number(g.rotation) + " degrees";
  return text + (g.cell_centred ? ", values of cells" : ", values at nodes") + ", " + std::to_string(g.n_blank) +
         " without a value\n";
}

}  // namespace

std::string to_text(const FileInfo& info) {
  std::string text = info.file + ": " + info.format + "\n";
  if (info.meshes.empty() && info.n_facets == 0) text += frame_text(info.frame);
  for (const GridSummary& g : info.grids) text += grid_text(g);
  for (const SurfaceInfo& s : info.surfaces) text += surface_text(s);
  for (const FileInfo::Line& l : info.polylines)
    text += "polyline " + l.name + ": " + count(l.n_points, "point", "points") + ", length " + number(l.length) +
            "\n  " + bounds_text(l.bounds) + "\n";
  for (const FileInfo::Points& p : info.point_sets)
    text += "points " + p.name + ": " + std::to_string(p.n_points) + "\n  " + bounds_text(p.bounds) + "\n";
  if (info.n_named_points > 0) text += count(info.n_named_points, "point", "points") + "\n";
  if (info.n_facets > 0) text += count(info.n_facets, "facet", "facets") + "\n";
  for (const MeshInfo& m : info.meshes) text += mesh_text(m);
  if (!info.arrays.empty()) text += "properties passed over: " + joined(info.arrays) + "\n";
  if (!info.regions.empty()) {
    text += "regions:";
    for (const std::string& name : info.regions) text += " " + name;
    text += "\n";
  }
  for (const std::string& note : info.notes) text += "note: " + note + "\n";
  for (const std::string& warning : info.warnings) text += "warning: " + warning + "\n";
  return text;
}

std::string to_json(const FileInfo& info) {
  nlohmann::ordered_json json{{"command", "info"}, {"file", info.file}, {"format", info.format}};
  if (info.meshes.empty() && info.n_facets == 0)
    json["coordinates"] = {{"unit", info.frame.unit},
                           {"z_unit", info.frame.z_unit},
                           {"z", info.frame.depth     ? "depth"
                                 : info.frame.z_named ? "elevation"
                                                      : ""},
                           {"system", info.frame.crs},
                           {"geographic", info.frame.geographic}};
  for (const GridSummary& g : info.grids)
    json["grids"].push_back({{"surface", g.surface},
                             {"columns", g.n_columns},
                             {"rows", g.n_rows},
                             {"blank", g.n_blank},
                             {"origin", {g.origin.x, g.origin.y}},
                             {"spacing", {g.spacing.x, g.spacing.y}},
                             {"rotation", g.rotation},
                             {"cell_centred", g.cell_centred}});
  for (const SurfaceInfo& s : info.surfaces)
    json["surfaces"].push_back({{"name", s.name},
                                {"points", s.n_points},
                                {"distinct_points", s.n_distinct_points},
                                {"triangles", s.n_triangles},
                                {"components", s.n_components},
                                {"bounds", bounds_json(s.bounds)},
                                {"area", s.area},
                                {"border_edges", s.n_border_edges},
                                {"borders", s.n_borders},
                                {"border_length", s.border_length},
                                {"holes", s.n_holes},
                                {"non_manifold_edges", s.n_non_manifold_edges},
                                {"misoriented_edges", s.n_misoriented_edges},
                                {"degenerate", s.n_degenerate},
                                {"repeated", s.n_repeated},
                                {"closed", s.closed},
                                {"volume", s.volume}});
  for (const FileInfo::Line& l : info.polylines)
    json["polylines"].push_back(
        {{"name", l.name}, {"points", l.n_points}, {"length", l.length}, {"bounds", bounds_json(l.bounds)}});
  for (const FileInfo::Points& p : info.point_sets)
    json["point_sets"].push_back({{"name", p.name}, {"points", p.n_points}, {"bounds", bounds_json(p.bounds)}});
  for (const MeshInfo& m : info.meshes) {
    nlohmann::ordered_json mesh{{"points", m.n_points},
                                {"tetrahedra", m.n_tetrahedra},
                                {"other_solids", m.n_other_solids},
                                {"lower_cells", m.n_lower_cells},
                                {"bounds", bounds_json(m.bounds)},
                                {"region_array", m.region_array},
                                {"volume", m.volume},
                                {"inverted", m.n_inverted},
                                {"arrays", m.arrays}};
    for (const MeshInfo::Region& r : m.regions)
      mesh["regions"].push_back({{"id", r.id}, {"name", r.name}, {"tetrahedra", r.n_tetrahedra}, {"volume", r.volume}});
    json["meshes"].push_back(mesh);
  }
  if (info.n_named_points > 0) json["points"] = info.n_named_points;
  if (info.n_facets > 0) json["facets"] = info.n_facets;
  if (!info.arrays.empty()) json["arrays"] = info.arrays;
  json["regions"] = info.regions;
  json["notes"] = info.notes;
  json["warnings"] = info.warnings;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace geomesh::geomodel

// SPDX-License-Identifier: GPL-3.0-or-later
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

std::string count(std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

std::string bounds_text(const Box3& b) {
  if (b.empty()) return "no extent";
  char text[256];
  std::snprintf(text, sizeof text, "x %.8g to %.8g, y %.8g to %.8g, z %.8g to %.8g", b.min.x, b.max.x, b.min.y, b.max.y, b.min.z,
                b.max.z);
  return text;
}

nlohmann::ordered_json bounds_json(const Box3& b) {
  if (b.empty()) return nullptr;
  return {{"min", {b.min.x, b.min.y, b.min.z}}, {"max", {b.max.x, b.max.y, b.max.z}}};
}

std::string surface_text(const SurfaceInfo& s) {
  std::string text = "surface " + s.name + ": " + count(s.n_triangles, "triangle", "triangles") + ", " +
                     count(s.n_distinct_points, "point", "points") + ", " + count(s.n_components, "piece", "pieces") + "\n";
  if (s.n_distinct_points != s.n_points)
    text += "  " + std::to_string(s.n_points - s.n_distinct_points) + " points repeat the coordinates of another (one vertex when meshed)\n";
  text += "  " + bounds_text(s.bounds) + "\n  area " + number(s.area);
  if (s.closed) {
    text += s.volume > 0 ? ", closed, encloses " + number(s.volume) : std::string(", closed");
  } else {
    text += ", open: " + count(s.n_borders, "border", "borders") + " of " + count(s.n_border_edges, "edge", "edges") + ", length " +
            number(s.border_length);
  }
  return text + "\n";
}

std::string mesh_text(const MeshInfo& m) {
  std::string text = "mesh: " + count(m.n_tetrahedra, "tetrahedron", "tetrahedra") + ", " + count(m.n_points, "point", "points") + "\n  " +
                     bounds_text(m.bounds) + "\n";
  if (!m.region_array.empty()) text += "  " + count(m.regions.size(), "region", "regions") + " from array " + m.region_array + ":\n";
  for (const MeshInfo::Region& r : m.regions)
    text += "    " + std::to_string(r.id) + "  " + r.name + "  " + count(r.n_tetrahedra, "tetrahedron", "tetrahedra") + "\n";
  return text;
}

}  // namespace

std::string to_text(const FileInfo& info) {
  std::string text = info.file + ": " + info.format + "\n";
  for (const SurfaceInfo& s : info.surfaces) text += surface_text(s);
  for (const FileInfo::Line& l : info.polylines)
    text += "polyline " + l.name + ": " + count(l.n_points, "point", "points") + ", length " + number(l.length) + "\n";
  for (const FileInfo::Points& p : info.point_sets)
    text += "points " + p.name + ": " + std::to_string(p.n_points) + "\n  " + bounds_text(p.bounds) + "\n";
  if (info.n_named_points > 0) text += count(info.n_named_points, "point", "points") + "\n";
  if (info.n_facets > 0) text += count(info.n_facets, "facet", "facets") + "\n";
  for (const MeshInfo& m : info.meshes) text += mesh_text(m);
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
                                {"non_manifold_edges", s.n_non_manifold_edges},
                                {"misoriented_edges", s.n_misoriented_edges},
                                {"degenerate", s.n_degenerate},
                                {"repeated", s.n_repeated},
                                {"closed", s.closed},
                                {"volume", s.volume}});
  for (const FileInfo::Line& l : info.polylines)
    json["polylines"].push_back({{"name", l.name}, {"points", l.n_points}, {"length", l.length}});
  for (const FileInfo::Points& p : info.point_sets)
    json["point_sets"].push_back({{"name", p.name}, {"points", p.n_points}, {"bounds", bounds_json(p.bounds)}});
  for (const MeshInfo& m : info.meshes) {
    nlohmann::ordered_json mesh{{"points", m.n_points},
                                {"tetrahedra", m.n_tetrahedra},
                                {"other_solids", m.n_other_solids},
                                {"lower_cells", m.n_lower_cells},
                                {"bounds", bounds_json(m.bounds)},
                                {"region_array", m.region_array}};
    for (const MeshInfo::Region& r : m.regions)
      mesh["regions"].push_back({{"id", r.id}, {"name", r.name}, {"tetrahedra", r.n_tetrahedra}});
    json["meshes"].push_back(mesh);
  }
  if (info.n_named_points > 0) json["points"] = info.n_named_points;
  if (info.n_facets > 0) json["facets"] = info.n_facets;
  json["regions"] = info.regions;
  json["notes"] = info.notes;
  json["warnings"] = info.warnings;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace geomesh::geomodel

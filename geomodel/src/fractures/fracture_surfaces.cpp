// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/fracture_surfaces.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "common/edge_uses.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "level_sets/sheet_topology.hpp"

namespace geomesh::geomodel {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& object, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": fracture " + object + ": " + why);
}

/// Returns a surface in which points with equal coordinates are one vertex, and triangles with fewer than three
/// distinct vertices are removed.
TriangulatedSurface with_shared_vertices(const TriangulatedSurface& surface) {
  TriangulatedSurface merged;
  std::map<std::array<double, 3>, VertexIndex> row;
  for (const Triangle& t : surface.triangles) {
    Triangle corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = surface.points[t[i]];
      const auto [at, is_new] = row.emplace(std::array{p.x, p.y, p.z}, static_cast<VertexIndex>(row.size()));
      if (is_new) merged.points.push_back(p);
      corners[i] = at->second;
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      merged.triangles.push_back(corners);
  }
  return merged;
}

/// Returns the closed border lines of a surface, whose triangles need not be consistently oriented.
std::vector<std::vector<Vec3>> borders_of(const std::filesystem::path& path, const TriangulatedSurface& given) {
  const TriangulatedSurface surface = with_shared_vertices(given);
  std::map<VertexIndex, std::vector<VertexIndex>> next;
  for_each_edge(sorted_edge_uses(std::span<const Triangle>(surface.triangles)), [&](std::span<const EdgeUse> uses) {
    if (uses.size() > 1) return;
    next[uses.front().a].push_back(uses.front().b);
    next[uses.front().b].push_back(uses.front().a);
  });
  std::vector<std::vector<Vec3>> loops;
  while (!next.empty()) {
    std::vector<Vec3>& loop = loops.emplace_back();
    VertexIndex at = next.begin()->first;
    while (next.contains(at)) {
      const std::vector<VertexIndex> ends = next.at(at);
      if (ends.size() != 2) refuse(path, given.name, "its border passes a corner twice; give its parts one by one");
      loop.push_back(surface.points[at]);
      next.erase(at);
      at = next.contains(ends[0]) ? ends[0] : ends[1];
    }
  }
  if (loops.size() != topology_of(surface).n_parts)
    refuse(path, given.name, loops.empty() ? "its surface is closed" : "its surface has holes");
  return loops;
}

class FractureCollector {
 public:
  FractureCollector(const std::filesystem::path& path, const std::string& name) : path_(path), name_(name) {}

  void add(const std::string& object, const std::vector<std::vector<Vec3>>& polygons) {
    for (const std::vector<Vec3>& polygon : polygons) {
      const std::string own = object.empty() ? name_ : object;
      if (const std::string fault = plane_fault(polygon); !fault.empty()) refuse(path_, own, fault);
      const bool needs_number = object.empty() || polygons.size() > 1 || n_named_.contains(own);
      const std::size_t number = ++n_named_[own];
      fractures_.push_back({needs_number ? own + "_" + std::to_string(number) : own, polygon, 0});
    }
  }

  std::vector<Fracture> take() { return std::move(fractures_); }

 private:
  const std::filesystem::path& path_;
  const std::string& name_;
  std::map<std::string, std::size_t> n_named_;
  std::vector<Fracture> fractures_;
};

}  // namespace

bool is_file_of_surfaces(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto known = {".ts",  ".gocad", ".pl",  ".dxf", ".obj",  ".off",     ".stl", ".ply",
                      ".vtk", ".vtp",   ".omf", ".shp", ".gpkg", ".geojson", ".json"};
  return std::find(known.begin(), known.end(), ending) != known.end();
}

std::vector<Fracture> fractures_of_surfaces(const std::filesystem::path& path, const std::string& name) {
  const FileContents contents = read_surface_file(path);
  FractureCollector found(path, name);
  for (const TriangulatedSurface& surface : contents.surfaces) found.add(surface.name, borders_of(path, surface));
  for (const Polyline& line : contents.polylines) {
    std::vector<Vec3> corners = line.points;
    if (corners.size() < 4 || corners.front() != corners.back())
      refuse(path, line.name,
             "its line is not closed; a polygon was expected, whose last corner is the first one again");
    corners.pop_back();
    found.add(line.name, {corners});
  }
  std::vector<Fracture> fractures = found.take();
  if (fractures.empty())
    throw Error(ErrorKind::invalid_input,
                path.string() + ": holds no fracture; plane surfaces or closed lines were expected");
  return fractures;
}

}  // namespace geomesh::geomodel

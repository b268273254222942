// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the contents of a file, declared in geomesh/geomodel/info.hpp.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <new>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "naming/sums.hpp"
#include "plausibility/spikes.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns whether the file is a legacy VTK file with cells of any kind, according to its fourth line.
bool is_legacy_grid(const std::filesystem::path& path) {
  if (path.extension() != ".vtk") return false;
  std::ifstream in(path);
  std::string line;
  for (int i = 0; i < 4; ++i) std::getline(in, line);
  return starts_with_ignoring_case(trim(line), "DATASET UNSTRUCTURED_GRID");
}

bool may_be_mesh(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".vtu" || extension == ".msh" || extension == ".inp" || is_legacy_grid(path);
}

void measure_regions(const checking::MeshFile& file, MeshInfo& mesh) {
  struct Sum {
    std::size_t n = 0;
    CompensatedSum volume;
  };
  std::map<std::int32_t, Sum> sums;
  CompensatedSum whole;
  for (std::size_t t = 0; t < file.tetrahedra.size(); ++t) {
    const Tetrahedron& v = file.tetrahedra[t];
    const Vec3 &a = file.points[v[0]], &b = file.points[v[1]], &c = file.points[v[2]], &d = file.points[v[3]];
    const double volume = signed_volume(a, b, c, d);
    whole.add(volume);
    mesh.n_inverted += orient3d(a, b, c, d) != Sign::positive;
    if (file.region.empty()) continue;
    Sum& sum = sums[file.region[t]];
    ++sum.n;
    sum.volume.add(volume);
  }
  mesh.volume = whole.value();
  for (const auto& [id, sum] : sums) {
    const auto name = file.region_names.find(id);
    mesh.regions.push_back({id, name == file.region_names.end() ? "" : name->second, sum.n, sum.volume.value()});
  }
}

/// Describes a file with a tetrahedral mesh; returns false if the file has no tetrahedra.
bool describe_mesh(const std::filesystem::path& path, FileInfo& info) {
  checking::MeshFile file;
  try {
    file = checking::read_mesh_file(path);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::invalid_input,
                path.string() + ": reading it needs more memory than there is; its counts may be wrong");
  }
  if (file.tetrahedra.empty()) return false;
  info.format = file.format;
  MeshInfo mesh;
  mesh.n_points = file.points.size();
  mesh.n_tetrahedra = file.tetrahedra.size();
  mesh.n_other_solids = file.n_other_solids;
  mesh.n_lower_cells = file.n_lower_cells;
  mesh.region_array = file.region_array;
  for (const Vec3& p : file.points) mesh.bounds.add(p);
  mesh.arrays = file.arrays;
  measure_regions(file, mesh);
  if (mesh.n_inverted > 0)
    info.warnings.push_back(std::to_string(mesh.n_inverted) +
                            " tetrahedra have no positive volume (decided exactly): `geomesh check` names them");
  if (file.region.empty()) info.warnings.push_back("no region array: the solver will see one material");
  if (file.n_other_solids > 0)
    info.warnings.push_back(std::to_string(file.n_other_solids) + " cells are solids other than tetrahedra");
  if (file.single_precision)
    info.warnings.push_back("coordinates are stored in single precision: at UTM northings that is half a metre");
  info.meshes.push_back(std::move(mesh));
  return true;
}

void describe_plc(const std::filesystem::path& path, FileInfo& info) {
  const PlcFile file = read_plc_file(path);
  info.format = "TetGen PLC";
  info.n_facets = file.plc.n_facets();
  info.regions = file.region_names;
  info.warnings = file.warnings;
  info.notes.push_back(std::to_string(file.plc.points.size()) + " points, " +
                       std::to_string(file.plc.hole_seeds.size()) + " holes");
}

std::string place(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.8g, %.8g, %.8g)", p.x, p.y, p.z);
  return text;
}

void warn_of_surface(const SurfaceInfo& s, std::vector<std::string>& warnings) {
  if (s.n_triangles == 0) warnings.push_back(s.name + " has no triangle");
  if (s.n_degenerate > 0)
    warnings.push_back(s.name + " has " + std::to_string(s.n_degenerate) + " triangles of zero area");
  if (s.n_repeated > 0) warnings.push_back(s.name + " has " + std::to_string(s.n_repeated) + " repeated triangles");
  if (s.n_non_manifold_edges > 0)
    warnings.push_back(s.name + " has " + std::to_string(s.n_non_manifold_edges) +
                       " edges with more than two triangles, one near " + place(s.non_manifold_place));
  if (s.n_misoriented_edges > 0)
    warnings.push_back(s.name + " has " + std::to_string(s.n_misoriented_edges) +
                       " edges whose triangles are oriented differently");
}

void describe_surfaces(const std::filesystem::path& path, FileInfo& info) {
  FileContents contents = read_surface_file(path);
  info.format = contents.format;
  info.notes = std::move(contents.notes);
  info.warnings = std::move(contents.warnings);
  info.frame = contents.frame;
  info.grids = std::move(contents.grids);
  info.arrays = std::move(contents.arrays);
  for (TriangulatedSurface& surface : contents.surfaces) {
    if (surface.name.empty()) surface.name = path.stem().string();
    info.surfaces.push_back(measure_surface(surface));
    warn_of_surface(info.surfaces.back(), info.warnings);
    const bool is_grid = std::any_of(info.grids.begin(), info.grids.end(),
                                     [&](const GridSummary& grid) { return grid.surface == surface.name; });
    if (const Spikes spikes = is_grid ? find_spikes(surface) : Spikes{}; spikes.n > 0)
      info.warnings.push_back(surface.name + ": " + spikes_words(spikes, {}) + "; " + spikes_remedy);
  }
  for (const Polyline& line : contents.polylines) {
    CompensatedSum length;
    Box3 bounds;
    for (const Vec3& p : line.points) bounds.add(p);
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const Vec3 step = line.points[i] - line.points[i - 1];
      length.add(std::sqrt(dot(step, step)));
    }
    info.polylines.push_back({line.name, line.points.size(), length.value(), bounds});
  }
  info.n_named_points = contents.points.size();
  for (const PointSet& set : contents.point_sets) {
    Box3 bounds;
    for (const Vec3& p : set.points) bounds.add(p);
    info.point_sets.push_back({set.name, set.points.size(), bounds});
  }
  for (const RegionHint& region : contents.regions) info.regions.push_back(region.name);
}

}  // namespace

FileInfo describe_file(const std::filesystem::path& path) {
  if (path.extension() == ".yaml" || path.extension() == ".yml") return describe_project(path);
  FileInfo info;
  info.file = path.filename().string();
  if (may_be_mesh(path) && describe_mesh(path, info)) return info;
  if (is_plc_file(path)) {
    describe_plc(path, info);
  } else {
    describe_surfaces(path, info);
  }
  return info;
}

}  // namespace geomesh::geomodel

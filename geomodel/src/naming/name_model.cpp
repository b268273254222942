// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the mesh with named regions, surfaces and curves, declared in geomesh/geomodel/build_model.hpp.
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "common/chunks.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "naming/name_regions.hpp"
#include "naming/patches/surface_curves.hpp"
#include "naming/source_triangles.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

std::uint8_t kind_of(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, VertexIndex v) {
  if (mesh.input_vertex[v] == no_vertex) return static_cast<std::uint8_t>(mesh.origin[v]);
  return soup.kind[mesh.input_vertex[v]] == SoupVertexKind::input ? 0 : 1;
}

/// Corrects the kind of points at which surfaces no longer meet, because surfaces were merged or thin voids closed. A
/// point on no curve whose faces belong to one surface becomes a point on a facet.
void name_what_meets_nothing(const MeshedModel& meshed, std::vector<std::uint8_t>& kinds) {
  constexpr std::uint8_t intersection = 1;
  constexpr auto on_facet = static_cast<std::uint8_t>(VertexOrigin::on_facet);
  const auto& [mesh, soup, plc, surfaces, moved] = meshed;
  std::map<VertexIndex, std::set<Index>> surfaces_at;
  for (const auto& face : mesh.faces)
    for (const VertexIndex v : face.vertices)
      if (kinds[v] == intersection)
        for (const PolygonSoup::Origin& origin : origins_of(soup, plc, face.facet))
          surfaces_at[v].insert(origin.surface);
  for (const auto& edge : mesh.edges)
    if (!plc.segment_curves[edge.segment].empty()) surfaces_at.erase(edge.a), surfaces_at.erase(edge.b);
  for (const auto& [v, at] : surfaces_at)
    if (at.size() == 1) kinds[v] = on_facet;
}

/// Orders mesh points with input points first, else as in the core's mesh. Returns the new index of each core point.
std::vector<VertexIndex> fill_points(const MeshedModel& meshed, unsigned threads, ModelMesh& model) {
  const ConstrainedTetrahedralization& mesh = meshed.mesh;
  const PolygonSoup& soup = meshed.soup;
  const std::size_t n = mesh.points.size();
  std::vector<std::uint8_t> kinds(n);
  const Chunks chunks(n);
  chunks.for_each(threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) kinds[v] = kind_of(mesh, soup, static_cast<VertexIndex>(v));
  });
  name_what_meets_nothing(meshed, kinds);
  std::vector<VertexIndex> row(n);
  auto next = static_cast<VertexIndex>(std::count(kinds.begin(), kinds.end(), 0));
  for (std::size_t v = 0, next_input = 0; v < n; ++v)
    row[v] = kinds[v] == 0 ? static_cast<VertexIndex>(next_input++) : next++;
  model.points.resize(n);
  model.point_kind.resize(n);
  model.input_vertex.resize(n);
  chunks.for_each(threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      model.points[row[v]] = mesh.points[v];
      model.point_kind[row[v]] = kinds[v];
      const VertexIndex p = mesh.input_vertex[v];
      const bool is_input = p != no_vertex && soup.input_point[p] != no_index;
      model.input_vertex[row[v]] = is_input ? static_cast<std::int32_t>(soup.input_point[p]) : -1;
    }
  });
  return row;
}

void fill_tetrahedra(const ConstrainedTetrahedralization& mesh, const std::vector<VertexIndex>& row,
                     const std::vector<std::int32_t>& id_of_component, unsigned threads, ModelMesh& model) {
  model.tetrahedra.resize(mesh.tetrahedra.size());
  model.tet_region.resize(mesh.tetrahedra.size());
  Chunks(mesh.tetrahedra.size()).for_each(threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Tetrahedron& v = mesh.tetrahedra[t];
      model.tetrahedra[t] = {row[v[0]], row[v[1]], row[v[2]], row[v[3]]};
      model.tet_region[t] = id_of_component[mesh.component[t]];
    }
  });
}

Vec3 middle_of(const std::vector<Vec3>& points, const Triangle& t) {
  return (1.0 / 3) * (points[t[0]] + points[t[1]] + points[t[2]]);
}

void fill_faces(const MeshedModel& meshed, const std::vector<std::int32_t>& surface_id,
                const std::vector<VertexIndex>& row, ModelMesh& model) {
  const auto& [mesh, soup, plc, surfaces, moved] = meshed;
  SourceTriangles sources(meshed);
  std::map<std::vector<std::int32_t>, std::int32_t> set_rows;
  std::vector<std::int32_t> set;
  for (const auto& face : mesh.faces) {
    ModelMesh::Face out;
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    out.region_minus = face.tetrahedron_below == no_index ? 0 : model.tet_region[face.tetrahedron_below];
    out.region_plus = face.tetrahedron_above == no_index ? 0 : model.tet_region[face.tetrahedron_above];
    out.vertices = {row[face.vertices[0]], row[face.vertices[1]], row[face.vertices[2]]};
    const bool flip = below == no_index || (above != no_index && out.region_plus < out.region_minus);
    if (flip) {
      std::swap(out.vertices[1], out.vertices[2]);
      std::swap(out.region_minus, out.region_plus);
    }
    const std::span<const PolygonSoup::Origin> origins = origins_of(soup, plc, face.facet);
    out.surface = surface_id[origins.front().surface];
    out.source_triangle = static_cast<std::int32_t>(sources.of(face.facet, middle_of(mesh.points, face.vertices)));
    set.clear();
    for (const PolygonSoup::Origin& origin : origins)
      if (const std::int32_t id = surface_id[origin.surface]; set.empty() || set.back() != id) set.push_back(id);
    const auto [at, is_new] = set_rows.emplace(set, static_cast<std::int32_t>(model.surface_sets.size()));
    if (is_new) model.surface_sets.push_back(set);
    out.surface_set = at->second;
    model.faces.push_back(out);
  }
}

void sum_areas(ModelMesh& model) {
  std::map<std::int32_t, CompensatedSum> areas;
  for (const ModelMesh::Face& face : model.faces)
    for (std::int32_t id : model.surface_sets[static_cast<std::size_t>(face.surface_set)])
      areas[id].add(triangle_area(model.points[face.vertices[0]], model.points[face.vertices[1]],
                                  model.points[face.vertices[2]]));
  for (NamedSurface& surface : model.surfaces) surface.area = areas[surface.id].value();
}

/// Adds wells to the curves of the mesh, after the curves at which surfaces end or meet.
void add_wells(const ConstrainedTetrahedralization& mesh, const ModelPlc& plc, const std::vector<VertexIndex>& row,
               MeshCurves& curves) {
  std::map<Index, Index> well;  // for each well of `plc.curves`, its index in `curves`
  for (Index c = 0; c < plc.curves.size(); ++c)
    if (plc.curves[c].kind == "well") {
      well[c] = static_cast<Index>(curves.curves.size());
      curves.curves.push_back(plc.curves[c]);
    }
  for (const auto& edge : mesh.edges)
    for (const Index curve : plc.segment_curves[edge.segment])
      if (const auto at = well.find(curve); at != well.end())
        curves.edges.push_back({row[edge.a], row[edge.b], at->second});
}

/// Adds to the model's list the curves of `given` that have edges in the mesh, in the same order, with ids from next_id
/// on. Returns the first id that is unused then.
std::int32_t fill_curves(const MeshCurves& given, std::int32_t next_id, ModelMesh& model) {
  std::vector<CompensatedSum> lengths(given.curves.size());
  std::vector<std::size_t> n_edges(given.curves.size(), 0);
  for (const auto& [a, b, curve] : given.edges) {
    lengths[curve].add(norm(model.points[b] - model.points[a]));
    ++n_edges[curve];
  }
  std::vector<std::int32_t> id(given.curves.size(), 0);
  for (std::size_t c = 0; c < given.curves.size(); ++c) {
    if (n_edges[c] == 0) continue;
    id[c] = next_id++;
    model.curves.push_back({id[c], given.curves[c].name, given.curves[c].kind, lengths[c].value()});
  }
  for (const auto& [a, b, curve] : given.edges) model.curve_edges.push_back({a, b, id[curve]});
  return next_id;
}

void fill_marked_points(const MeshedModel& meshed, const std::vector<NamedPoint>& points,
                        const std::vector<VertexIndex>& row, std::int32_t next_id, ModelMesh& model) {
  const auto& [mesh, soup, plc, surfaces, moved] = meshed;
  std::map<VertexIndex, VertexIndex> mesh_point;
  for (const PolygonSoup::IsolatedPoint& p : soup.isolated_points) mesh_point[p.v] = no_vertex;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (const auto at = mesh_point.find(mesh.input_vertex[v]); at != mesh_point.end()) at->second = v;
  for (const PolygonSoup::IsolatedPoint& p : soup.isolated_points)
    if (mesh_point[p.v] != no_vertex)
      model.marked_points.push_back({row[mesh_point[p.v]], next_id++, points[p.point].name});
}

/// Assigns groups and attributes to regions by the name of the region or of its unit. If both names have the attribute,
/// the region's value counts.
void add_groups_and_attributes(const NamingRules& rules, ModelMesh& model, std::vector<std::string>& warnings) {
  std::set<std::string> known;
  for (const Region& r : model.regions) known.insert({r.name, r.unit});
  for (const auto& [group, members] : rules.groups) {
    RegionGroup out{group, {}};
    for (const Region& r : model.regions)
      if (std::any_of(members.begin(), members.end(), [&](const std::string& m) { return m == r.name || m == r.unit; }))
        out.regions.push_back(r.id);
    for (const std::string& m : members)
      if (!known.contains(m))
        warnings.push_back("group " + group + " names " + m + ", which is no unit or region of the mesh");
    model.groups.push_back(std::move(out));
  }
  std::map<std::string, std::vector<double>> values;
  for (const auto& [unit, list] : rules.attributes) {
    if (!known.contains(unit))
      warnings.push_back("attributes are given for " + unit + ", which is no unit or region of the mesh");
    if (list.contains("region"))
      throw Error(ErrorKind::usage, "attribute 'region' of " + unit + ": this name is taken by the region ids");
    for (const auto& [name, value] : list)
      values[name].assign(model.regions.size(), std::numeric_limits<double>::quiet_NaN());
  }
  for (auto& [name, by_region] : values) {
    for (std::size_t r = 0; r < model.regions.size(); ++r)
      for (const std::string& key : {model.regions[r].unit, model.regions[r].name})
        if (const auto unit = rules.attributes.find(key); unit != rules.attributes.end())
          if (const auto value = unit->second.find(name); value != unit->second.end()) by_region[r] = value->second;
    model.attributes.push_back({name, by_region});
  }
}

ModelMesh name_components(const MeshedModel& meshed, const std::vector<NamedPoint>& points, const NamingRules& rules,
                          std::vector<std::string>& warnings, unsigned threads) {
  const ConstrainedTetrahedralization& mesh = meshed.mesh;
  const Column column = make_column(rules.column, meshed.surfaces, warnings);
  NamedRegions named = name_regions(meshed, rules, column, warnings);
  ModelMesh model;
  model.open_borders = find_gaps(meshed, column, named, warnings);
  model.regions = std::move(named.regions);
  const std::vector<VertexIndex> row = fill_points(meshed, threads, model);
  fill_tetrahedra(mesh, row, named.id_of_component, threads, model);
  std::int32_t next_id = static_cast<std::int32_t>(model.regions.size()) + 1;
  std::vector<std::int32_t> surface_id;
  for (const TriangulatedSurface& surface : meshed.surfaces) {
    surface_id.push_back(next_id);
    model.surfaces.push_back({next_id++, surface.name, surface.kind, 0});
  }
  fill_faces(meshed, surface_id, row, model);
  sum_areas(model);
  MeshCurves curves = tell_curves_and_patches(meshed.surfaces, model);
  add_wells(mesh, meshed.plc, row, curves);
  next_id = fill_curves(curves, next_id, model);
  fill_marked_points(meshed, points, row, next_id, model);
  add_groups_and_attributes(rules, model, warnings);
  return model;
}

}  // namespace

ModelMesh name_model(const MeshedModel& model, const std::vector<NamedPoint>& points, const NamingRules& rules,
                     std::vector<std::string>& warnings, unsigned threads) {
  if (rules.topography.empty() && rules.floor.empty()) return name_components(model, points, rules, warnings, threads);
  const auto& [mesh, soup, plc, surfaces, moved] = model;
  const ConstrainedTetrahedralization kept = within_ends(mesh, soup, plc, surfaces, rules, warnings);
  return name_components({kept, soup, plc, surfaces, moved}, points, rules, warnings, threads);
}

}  // namespace geomesh::geomodel

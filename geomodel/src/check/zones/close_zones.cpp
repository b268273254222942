// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a mesh with its fault zones closed, declared in check/zones/check_zones.hpp.
#include <algorithm>
#include <set>
#include <tuple>

#include "check/mesh/faults.hpp"
#include "check/mesh/walls.hpp"
#include "check/zones/check_zones.hpp"
#include "check/zones/zone_names.hpp"

namespace geomesh::geomodel::checking {
namespace {

class ZoneCloser {
 public:
  ZoneCloser(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<FaultZone>& zones)
      : mesh_(mesh), faces_(faces), faults_(faults_of(zones)), zone_ids_(zone_ids(mesh.file.region_names, zones)) {}

  ClosedFiles close(const CurvesFile* curves) {
    close_mesh();
    rename_surfaces();
    close_faces();
    if (curves) close_curves(*curves);
    return std::move(closed_);
  }

 private:
  bool is_zone(std::int32_t region) const { return zone_ids_.contains(region); }

  void close_mesh() {
    const MeshFile& file = mesh_.file;
    MeshFile& out = closed_.mesh;
    row_.assign(file.points.size(), no_vertex);
    std::map<std::tuple<double, double, double>, VertexIndex> at;
    std::vector<bool> used(file.points.size(), false);
    for (std::size_t t = 0; t < mesh_.cells.size(); ++t)
      if (!is_zone(file.region[t]))
        for (const VertexIndex v : mesh_.cells[t]) used[v] = true;
    for (VertexIndex v = 0; v < file.points.size(); ++v) {
      const Vec3 p = file.before_zones[v] + Vec3{0, 0, 0};  // -0 is 0
      const auto [entry, is_new] = at.try_emplace({p.x, p.y, p.z}, static_cast<VertexIndex>(out.points.size()));
      if (is_new && !used[v]) {
        at.erase(entry);  // only elements of fault zones use this point, and they are removed
        continue;
      }
      row_[v] = entry->second;
      if (!is_new) continue;
      out.points.push_back(p);
      if (v < file.kind.size()) out.kind.push_back(file.kind[v]);
      if (v < file.input_vertex.size()) out.input_vertex.push_back(file.input_vertex[v]);
    }
    out.format = file.format;
    out.single_precision = file.single_precision;
    out.region_array = file.region_array;
    out.origin = file.origin;
    for (const auto& [name, values] : file.cell_values) out.cell_values[name];
    for (std::size_t t = 0; t < mesh_.cells.size(); ++t) {
      if (is_zone(file.region[t])) continue;
      const Tetrahedron& c = mesh_.cells[t];
      out.tetrahedra.push_back({row_[c[0]], row_[c[1]], row_[c[2]], row_[c[3]]});
      out.cell.push_back(file.cell[t]);
      out.region.push_back(file.region[t]);
      for (auto& [name, values] : out.cell_values) values.push_back(file.cell_values.at(name)[t]);
    }
    out.region_names = without_zones(file.region_names);
    for (const auto& [name, regions] : file.region_groups)
      for (const std::int32_t id : regions)
        if (auto& kept = out.region_groups[name]; !is_zone(id)) kept.push_back(id);
  }
  std::map<std::int32_t, std::string> without_zones(std::map<std::int32_t, std::string> names) const {
    std::erase_if(names, [&](const auto& entry) { return is_zone(entry.first); });
    return names;
  }

  void rename_surfaces() {
    FacesFile& out = closed_.faces;
    out.region_names = without_zones(faces_.region_names);
    auto next = static_cast<std::int32_t>(closed_.mesh.region_names.size());
    for (const auto& [id, name] : faces_.surface_names) {
      const auto [fault, wall] = wall_of(name, faults_);
      if (wall == Wall::plus) continue;
      id_of_fault_[fault] = now_[id] = ++next;
      out.surface_names[next] = fault;
      if (const auto kind = faces_.surface_kinds.find(id); kind != faces_.surface_kinds.end())
        out.surface_kinds[next] = kind->second;
    }
    for (const auto& [id, name] : faces_.surface_names)
      if (const auto [fault, wall] = wall_of(name, faults_); wall == Wall::plus && id_of_fault_.contains(fault))
        now_[id] = id_of_fault_[fault];
    for (const auto& set : faces_.surface_sets) {
      std::set<std::int32_t> ids;
      for (const std::int32_t id : set) ids.insert(now_.contains(id) ? now_[id] : 0);
      out.surface_sets.emplace_back(ids.begin(), ids.end());
    }
    next_id_ = next;
  }

  Wall wall(std::size_t f) const { return wall_of_face(faces_, f, faults_); }
  Triangle nodes(std::size_t f) const {
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(faces_.mesh_point[faces_.triangles[f][i]]);
      t[i] = at < row_.size() ? row_[at] : no_vertex;
    }
    return t;
  }
  void close_faces() {
    FacesFile& out = closed_.faces;
    out.points = closed_.mesh.points;
    for (std::size_t v = 0; v < out.points.size(); ++v) out.mesh_point.push_back(static_cast<std::int32_t>(v));
    std::map<Triangle, std::int32_t> region_on_plus;
    for (std::size_t f = 0; f < faces_.triangles.size(); ++f)
      if (is_zone(faces_.region_plus[f]) && wall(f) == Wall::plus)
        region_on_plus[sorted(nodes(f))] = faces_.region_minus[f];
    for (std::size_t f = 0; f < faces_.triangles.size(); ++f) {
      Triangle t = nodes(f);
      std::int32_t minus = faces_.region_minus[f], plus = faces_.region_plus[f];
      if (is_zone(minus) || std::find(t.begin(), t.end(), no_vertex) != t.end()) continue;
      if (is_zone(plus)) {
        const auto other = region_on_plus.find(sorted(t));
        if (wall(f) != Wall::minus || other == region_on_plus.end()) continue;
        plus = other->second;
        if (plus < minus) {
          std::swap(plus, minus);
          std::swap(t[1], t[2]);
        }
      }
      out.triangles.push_back(t);
      out.surface.push_back(now_.contains(faces_.surface[f]) ? now_.at(faces_.surface[f]) : 0);
      out.surface_set.push_back(faces_.surface_set[f]);
      out.patch.push_back(faces_.patch[f]);
      out.region_minus.push_back(minus);
      out.region_plus.push_back(plus);
      out.source_triangle.push_back(faces_.source_triangle[f]);
    }
  }

  /// `F1.minus*top` is `F1*top`.
  std::string closed_name(const std::string& name) const {
    std::multiset<std::string> members;
    std::string::size_type from = 0;
    while (true) {
      const auto to = name.find('*', from);
      const auto [fault, side] = wall_of(name.substr(from, to - from), faults_);
      if (side == Wall::none || !members.contains(fault)) members.insert(fault);
      if (to == std::string::npos) break;
      from = to + 1;
    }
    std::string joined;
    for (const std::string& member : members) joined += (joined.empty() ? "" : "*") + member;
    return joined;
  }
  /// Returns whether the curve's name contains both walls of a fault zone, because they meet along it.
  bool walls_meet(const std::string& name) const {
    std::map<std::string, std::set<Wall>> walls;
    std::string::size_type from = 0;
    while (true) {
      const auto to = name.find('*', from);
      const auto [fault, side] = wall_of(name.substr(from, to - from), faults_);
      if (side != Wall::none && walls[fault].insert(side).second && walls[fault].size() == 2) return true;
      if (to == std::string::npos) return false;
      from = to + 1;
    }
  }
  /// Returns the edges at which, with zones closed, exactly two faces meet, both of the same surfaces. Such an edge is
  /// inside a surface, so the curve at which the two walls of a zone met does not remain there.
  std::set<std::array<VertexIndex, 2>> edges_within_sheets() const {
    std::map<std::array<VertexIndex, 2>, std::vector<std::int32_t>> sets;
    const FacesFile& faces = closed_.faces;
    for (std::size_t f = 0; f < faces.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = faces.triangles[f][k], b = faces.triangles[f][(k + 1) % 3];
        sets[{std::min(a, b), std::max(a, b)}].push_back(faces.surface_set[f]);
      }
    std::set<std::array<VertexIndex, 2>> within;
    const auto surfaces = [&](std::int32_t set) {
      const auto row = static_cast<std::size_t>(set);
      return row < faces.surface_sets.size() ? faces.surface_sets[row] : std::vector<std::int32_t>{};
    };
    for (const auto& [edge, of] : sets)
      if (of.size() == 2 && surfaces(of[0]) == surfaces(of[1])) within.insert(edge);
    return within;
  }
  void close_curves(const CurvesFile& file) {
    CurvesFile& out = closed_.curves.emplace();
    out.points = closed_.mesh.points;
    out.mesh_point = closed_.faces.mesh_point;
    const auto row = [&](VertexIndex p) {
      const auto at = p < file.mesh_point.size() ? static_cast<std::size_t>(file.mesh_point[p]) : row_.size();
      return at < row_.size() ? row_[at] : no_vertex;
    };
    std::map<std::int32_t, std::string> name_of, kind_of;
    for (const auto& curve : file.curves) {
      kind_of[curve.id] = curve.kind;
      name_of[curve.id] = curve.kind == "intersection" ? closed_name(curve.name) : curve.name;
    }
    using Key = std::pair<std::string, std::string>;
    std::map<Key, std::set<std::array<VertexIndex, 2>>> edges;
    std::set<std::int32_t> met;
    for (const auto& curve : file.curves)
      if (curve.kind == "intersection" && walls_meet(curve.name)) met.insert(curve.id);
    const auto within = met.empty() ? std::set<std::array<VertexIndex, 2>>{} : edges_within_sheets();
    for (std::size_t e = 0; e < file.edges.size(); ++e) {
      const VertexIndex a = row(file.edges[e][0]), b = row(file.edges[e][1]);
      if (a == no_vertex || b == no_vertex || a == b) continue;  // in a zone
      const std::string& kind = kind_of[file.edge_curve[e]];
      if (kind == "intersection" && name_of[file.edge_curve[e]].find('*') == std::string::npos)
        continue;  // along it only the two walls of a fault zone meet, at the zone's end
      if (met.contains(file.edge_curve[e]) && within.contains({std::min(a, b), std::max(a, b)})) continue;
      edges[{kind_of[file.edge_curve[e]], name_of[file.edge_curve[e]]}].insert({std::min(a, b), std::max(a, b)});
    }
    std::map<Key, std::int32_t> id_of;
    for (const auto& curve : file.curves) {
      const Key key{curve.kind, name_of[curve.id]};
      if (id_of.contains(key) || (curve.kind != "point" && !edges.contains(key))) continue;
      id_of[key] = ++next_id_;
      out.curves.push_back({next_id_, name_of[curve.id], curve.kind});
    }
    for (const auto& [key, list] : edges)
      for (const auto& edge : list) {
        out.edges.push_back(edge);
        out.edge_curve.push_back(id_of[key]);
      }
    for (std::size_t v = 0; v < file.vertices.size(); ++v) {
      out.vertices.push_back(row(file.vertices[v]));
      out.vertex_curve.push_back(id_of[{"point", name_of[file.vertex_curve[v]]}]);
    }
  }

  const CheckedMesh& mesh_;
  const FacesFile& faces_;
  std::vector<std::string> faults_;
  std::map<std::int32_t, std::size_t> zone_ids_;
  ClosedFiles closed_;
  std::vector<VertexIndex> row_;  // index of each point after closing fault zones; no_vertex for points inside zones
  std::map<std::int32_t, std::int32_t> now_;  // ids of surfaces
  std::map<std::string, std::int32_t> id_of_fault_;
  std::int32_t next_id_ = 0;
};

}  // namespace

std::optional<ClosedFiles> close_zones(const CheckedMesh& mesh, const FacesFile& faces, const CurvesFile* curves,
                                       const std::vector<FaultZone>& zones, CheckResult& result) {
  const bool known = mesh.file.before_zones.size() == mesh.n_points() && mesh.file.region.size() == mesh.cells.size() &&
                     knows_mesh_points(faces, mesh.n_points());
  if (known) return ZoneCloser(mesh, faces, zones).close(curves);
  result.faults.push_back(
      {"wrong_fault_zones",
       "1 array is missing or wrong: before_zones of the mesh, or mesh_point of its faces, by which zones are closed "
       "again to check the rest",
       1,
       {},
       {}});
  return std::nullopt;
}

}  // namespace geomesh::geomodel::checking

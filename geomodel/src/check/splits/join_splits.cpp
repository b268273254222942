// SPDX-License-Identifier: GPL-3.0-or-later
// Returns a mesh without its split faults, declared in check/splits/check_splits.hpp.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "check/arrays/check_arrays.hpp"
#include "check/mesh/faults.hpp"
#include "check/mesh/walls.hpp"
#include "check/splits/check_splits.hpp"
#include "check/splits/split_sectors.hpp"

namespace geomesh::geomodel::checking {
namespace {

template <class Value>
void keep_rows(std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  std::vector<Value> kept;
  for (const std::size_t row : rows)
    if (row < values.size()) kept.push_back(values[row]);
  values = std::move(kept);
}

class SplitJoiner {
 public:
  SplitJoiner(const MeshFile& mesh, const FacesFile& faces, const AskedSplits& asked)
      : mesh_(mesh), faces_(faces), asked_(asked), as_split_{mesh, mesh.tetrahedra, {}, true} {}

  JoinedFiles join(const std::optional<CurvesFile>& curves, CheckResult& result) {
    check_mesh_points(as_split_, faces_.points, faces_.mesh_point, "the face set", result);
    if (curves) check_mesh_points(as_split_, curves->points, curves->mesh_point, "the curves", result);
    join_points();
    join_names(result);
    join_faces(result);
    check_sectors(result);
    check_prisms(result);
    if (curves) join_curves(*curves);
    return std::move(joined_);
  }

 private:
  Wall wall(std::size_t f) const { return wall_of_face(faces_, f, asked_.surfaces); }

  void join_points() {
    std::map<std::tuple<double, double, double>, VertexIndex> at;
    std::vector<std::size_t> kept;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const Vec3 p = mesh_.points[v] + Vec3{0, 0, 0};  // -0 is 0
      const auto [entry, is_new] = at.try_emplace({p.x, p.y, p.z}, static_cast<VertexIndex>(kept.size()));
      if (is_new) kept.push_back(v);
      row_.push_back(entry->second);
    }
    MeshFile& out = joined_.mesh = mesh_;
    keep_rows(out.points, kept);
    keep_rows(out.kind, kept);
    keep_rows(out.input_vertex, kept);
    keep_rows(out.before_zones, kept);
    keep_rows(out.global_points, kept);
    for (auto& [name, values] : out.point_values) keep_rows(values, kept);
    for (Tetrahedron& t : out.tetrahedra)
      for (VertexIndex& v : t) v = row_[v];
    for (VertexIndex& v : out.midpoints) v = row_[v];
    for (Triangle& t : out.triangles)
      for (VertexIndex& v : t) v = row_[v];
    for (auto& edge : out.edges)
      for (VertexIndex& v : edge) v = row_[v];
  }

  void require_sides(CheckResult& result) const {
    std::set<std::string> names;
    for (const auto& [id, name] : faces_.surface_names) names.insert(name);
    std::string whole;
    std::size_t n = 0;
    for (const std::string& surface : asked_.surfaces) {
      if (names.contains(surface + ".minus") && names.contains(surface + ".plus") && !names.contains(surface)) continue;
      whole += (n++ == 0 ? "" : ", ") + surface;
    }
    if (n > 0)
      result.faults.push_back({"wrong_splits",
                               std::to_string(n) + " surfaces have not two sides, NAME.minus and NAME.plus: " + whole,
                               n,
                               {},
                               {}});
  }
  void join_names(CheckResult& result) {
    require_sides(result);
    FacesFile& out = joined_.faces;
    out.region_names = faces_.region_names;
    std::set<std::int32_t> gone;
    for (const auto& [id, name] : faces_.surface_names) {
      const auto [surface, wall] = wall_of(name, asked_.surfaces);
      if (wall == Wall::plus) {
        gone.insert(id);
        continue;
      }
      out.surface_names[id] = surface;
      if (const auto kind = faces_.surface_kinds.find(id); kind != faces_.surface_kinds.end())
        out.surface_kinds[id] = kind->second;
    }
    for (const auto& set : faces_.surface_sets)
      if (std::none_of(set.begin(), set.end(), [&](std::int32_t id) { return gone.contains(id); }))
        out.surface_sets.push_back(set);
  }

  /// Returns the mesh nodes of face f as they are in the file, before merging.
  Triangle nodes(std::size_t f) const {
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = static_cast<VertexIndex>(faces_.mesh_point[faces_.triangles[f][i]]);
    return t;
  }
  Triangle joined(Triangle t) const {
    for (VertexIndex& v : t) v = row_[v];
    return t;
  }

  /// Pairs each minus face of a split fault with its plus face; reports faces without a partner, and faces that do not
  /// bound their own side. Nothing is split on the boundary of the model.
  void join_faces(CheckResult& result) {
    FaultCollector alone("wrong_splits"), inside("wrong_splits");
    CheckResult told_of_the_rest;
    CheckedMesh whole{joined_.mesh, joined_.mesh.tetrahedra, {}, true};
    check_faces(as_split_, told_of_the_rest);
    check_faces(whole, told_of_the_rest);
    const auto is_outer = [&](const Triangle& t) {
      const FacePair* face = find_face(whole, t);
      return face && is_boundary(*face);
    };
    const auto bounds = [&](const Triangle& t) {
      const FacePair* face = find_face(as_split_, t);
      return face && is_boundary(*face) && (is_odd(t) ? face->odd : face->even) != no_index;
    };
    std::map<Triangle, std::size_t> plus_face;
    for (std::size_t f = 0; f < faces_.triangles.size(); ++f) {
      if (wall(f) == Wall::none) continue;
      if (faces_.region_plus[f] != 0) inside.add(f, mesh_.points[nodes(f)[0]]);
      if (wall(f) == Wall::plus && !plus_face.try_emplace(sorted(joined(nodes(f))), f).second)
        alone.add(f, mesh_.points[nodes(f)[0]]);
    }
    std::size_t n_pairs = 0;
    for (std::size_t f = 0; f < faces_.triangles.size(); ++f) {
      if (wall(f) == Wall::plus) continue;
      Triangle t = joined(nodes(f));
      std::int32_t minus = faces_.region_minus[f], plus = faces_.region_plus[f];
      if (wall(f) == Wall::minus && !is_outer(t)) {
        const auto other = plus_face.find(sorted(t));
        if (other == plus_face.end() || is_odd(t) == is_odd(joined(nodes(other->second)))) {
          alone.add(f, mesh_.points[nodes(f)[0]]);
        } else {
          ++n_pairs;
          plus = faces_.region_minus[other->second];
          const Triangle from = nodes(f), to = nodes(other->second);
          // A minus and a plus face with the same three nodes lie wholly at a fault tip, where the sides are not split.
          if (sorted(from) != sorted(to)) {
            open_pairs_.emplace_back(from, to);
            if (!bounds(from) || !bounds(to)) inside.add(f, mesh_.points[from[0]]);
          }
        }
        split_.insert(sorted(t));
        if (plus != 0 && plus < minus) {
          std::swap(plus, minus);
          std::swap(t[1], t[2]);
        }
      }
      add_face(f, t, minus, plus);
    }
    for (std::size_t extra = plus_face.size(); extra > n_pairs; --extra) alone.add(0, Vec3{});
    alone.report(result, "faces of one side of a split surface have not one face of the other side in their place");
    inside.report(result, "faces of split surfaces are no boundary of their own side, with the normal out of it");
    joined_.faces.points = joined_.mesh.points;
    for (std::size_t v = 0; v < joined_.faces.points.size(); ++v)
      joined_.faces.mesh_point.push_back(static_cast<std::int32_t>(v));
  }
  void add_face(std::size_t f, const Triangle& t, std::int32_t minus, std::int32_t plus) {
    FacesFile& out = joined_.faces;
    out.triangles.push_back(t);
    out.surface.push_back(faces_.surface[f]);
    out.surface_set.push_back(faces_.surface_set[f]);
    out.patch.push_back(faces_.patch[f]);
    out.region_minus.push_back(minus);
    out.region_plus.push_back(plus);
    out.source_triangle.push_back(faces_.source_triangle[f]);
  }

  void check_sectors(CheckResult& result) const {
    FaultCollector wrong("wrong_splits");
    for (const VertexIndex v :
         nodes_unlike_sectors({joined_.mesh.points.size(), joined_.mesh.tetrahedra}, mesh_.tetrahedra, split_))
      wrong.add(v, joined_.mesh.points[v]);
    wrong.report(result, "places have not one node for each sector that the split surfaces divide about them");
    result.checks_done.push_back("split surfaces: " + std::to_string(split_.size()) +
                                 " faces, each there once on either side; one node for each sector about a place. "
                                 "The rest was checked with the sides joined");
  }

  /// Checks that cohesive prisms extend from the minus face, as seen from within the prism, to the plus face.
  void check_prisms(CheckResult& result) {
    // Cohesive prisms that the project requires, by their sorted minus and plus faces. The value is whether sorting the
    // corners of the minus face takes an odd number of exchanges.
    std::map<std::pair<Triangle, Triangle>, bool> due;
    if (asked_.cohesive)
      for (const auto& [minus, plus] : open_pairs_) due[{sorted(minus), sorted(plus)}] = is_odd(minus);
    FaultCollector wrong("wrong_splits");
    for (const auto& p : mesh_.prisms) {
      const Triangle minus{p[0], p[1], p[2]}, plus{p[3], p[4], p[5]};
      const auto pair = due.find({sorted(minus), sorted(plus)});
      const bool fits = pair != due.end() && pair->second != is_odd(minus) && joined(minus) == joined(plus);
      if (!fits) wrong.add(static_cast<std::size_t>(&p - mesh_.prisms.data()), mesh_.points[p[0]]);
      if (fits) due.erase(pair);
    }
    for (const auto& [pair, parity] : due) wrong.add(0, mesh_.points[pair.first[0]]);
    wrong.report(result,
                 "prisms do not lie between two sides of a split surface, or are missing there (output.cohesive)");
    joined_.mesh.n_other_solids -= mesh_.prisms.size();
    joined_.mesh.prisms.clear();
  }

  void join_curves(const CurvesFile& file) {
    CurvesFile& out = joined_.curves.emplace(file);
    out.points = joined_.mesh.points;
    out.mesh_point = joined_.faces.mesh_point;
    const auto row = [&](VertexIndex p) {
      const auto at = p < file.mesh_point.size() ? static_cast<std::size_t>(file.mesh_point[p]) : row_.size();
      return at < row_.size() ? row_[at] : VertexIndex{0};
    };
    for (auto& edge : out.edges) edge = {row(edge[0]), row(edge[1])};
    for (VertexIndex& v : out.vertices) v = row(v);
  }

  const MeshFile& mesh_;
  const FacesFile& faces_;
  const AskedSplits& asked_;
  CheckedMesh as_split_;
  std::vector<VertexIndex> row_;  // by node of the file with split faults: the point after merging
  std::set<Triangle> split_;      // faces, by places
  std::vector<std::pair<Triangle, Triangle>> open_pairs_;  // pairs of minus and plus faces with different nodes
  JoinedFiles joined_;
};

}  // namespace

std::optional<JoinedFiles> join_splits(const MeshFile& mesh, const FacesFile& faces,
                                       const std::optional<CurvesFile>& curves, const AskedSplits& asked,
                                       CheckResult& result) {
  if (faces.missing_arrays.empty() && knows_mesh_points(faces, mesh.points.size()))
    return SplitJoiner(mesh, faces, asked).join(curves, result);
  result.faults.push_back(
      {"wrong_splits",
       "1 array is missing or wrong in the face set, by which the sides of split surfaces are found: mesh_point, or "
       "one of its cells",
       1,
       {},
       {}});
  return std::nullopt;
}

}  // namespace geomesh::geomodel::checking

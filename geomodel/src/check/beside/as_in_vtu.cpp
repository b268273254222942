// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/beside/as_in_vtu.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/mesh/faults.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel::checking {
namespace {

constexpr const char* fault_id = "not_as_in_vtu";

/// Numbers the distinct points of both meshes in the order of their coordinates, so that equal points get equal
/// numbers.
class Places {
 public:
  explicit Places(const ModelMesh& mesh) : points_(mesh.points) {
    const auto is_same = [](const Vec3& a, const Vec3& b) { return !before(a, b) && !before(b, a); };
    std::sort(points_.begin(), points_.end(), before);
    points_.erase(std::unique(points_.begin(), points_.end(), is_same), points_.end());
  }
  std::optional<Index> find(const Vec3& p) const {
    const auto at = std::lower_bound(points_.begin(), points_.end(), p, before);
    if (at == points_.end() || before(p, *at)) return std::nullopt;
    return static_cast<Index>(at - points_.begin());
  }
  const Vec3& operator[](Index place) const { return points_[place]; }

 private:
  static bool before(const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }
  std::vector<Vec3> points_;
};

/// Points of an element, a face, an edge or a node, in ascending order. There are four for an element and fewer for
/// others, filled up with no_index.
using Corners = std::array<Index, 4>;
constexpr Corners nowhere{no_index, no_index, no_index, no_index};
/// For each name, the list of its elements, faces, edges or nodes, sorted.
using NamedParts = std::map<std::string, std::vector<Corners>>;

struct NamedMesh {
  NamedParts solids, groups, faces, edges, nodes;
};

/// Converts a mesh to lists of named elements, faces, edges and nodes, in which points are identified by their
/// coordinates. `output` selects the parts in the same way as for a solver's file.
class Namer {
 public:
  Namer(const ModelMesh& mesh, std::vector<Index> place, const WriteOptions& output)
      : mesh_(mesh), place_(std::move(place)), output_(output) {}

  NamedMesh run() {
    add_solids();
    add_faces();
    if (output_.curves) add_edges_and_nodes();
    for (NamedParts* parts : {&named_.solids, &named_.groups, &named_.faces, &named_.edges, &named_.nodes})
      for (auto& [name, list] : *parts) std::sort(list.begin(), list.end());
    return std::move(named_);
  }

 private:
  Corners corners(std::span<const VertexIndex> vertices) const {
    Corners places = nowhere;
    for (std::size_t k = 0; k < vertices.size(); ++k) places[k] = place_[vertices[k]];
    std::sort(places.begin(), places.end());
    return places;
  }

  void add_solids() {
    std::map<std::int32_t, std::string> name;
    for (const Region& r : mesh_.regions) name[r.id] = r.name;
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
      named_.solids[name[mesh_.tet_region[t]]].push_back(corners(mesh_.tetrahedra[t]));
    for (const RegionGroup& group : mesh_.groups)
      for (const std::int32_t region : group.regions) {
        const auto& own = named_.solids[name[region]];
        auto& all = named_.groups[group.name];
        all.insert(all.end(), own.begin(), own.end());
      }
  }

  void add_faces() {
    std::map<std::int32_t, std::string> name;
    for (const NamedSurface& s : mesh_.surfaces) name[s.id] = s.name;
    for (const ModelMesh::Face& f : mesh_.faces) {
      if (!output_.inner_faces && f.region_minus != 0 && f.region_plus != 0) continue;
      for (const std::int32_t surface : mesh_.surface_sets[f.surface_set])
        named_.faces[name[surface]].push_back(corners(f.vertices));
    }
  }

  void add_edges_and_nodes() {
    std::map<std::int32_t, std::string> name;
    for (const NamedCurve& c : mesh_.curves) name[c.id] = c.name;
    std::map<std::string, std::set<Index>> nodes;
    for (const ModelMesh::CurveEdge& e : mesh_.curve_edges) {
      named_.edges[name[e.curve]].push_back(corners(std::array{e.a, e.b}));
      nodes[name[e.curve]].insert({place_[e.a], place_[e.b]});
    }
    for (const ModelMesh::MarkedPoint& p : mesh_.marked_points) nodes[p.name].insert(place_[p.v]);
    for (const NodeSet& set : mesh_.node_sets)
      for (const VertexIndex v : set.nodes) nodes[set.name].insert(place_[v]);
    for (const auto& [curve, places] : nodes)
      for (const Index place : places) named_.nodes[curve].push_back({place, no_index, no_index, no_index});
  }

  const ModelMesh& mesh_;
  std::vector<Index> place_;
  const WriteOptions& output_;
  NamedMesh named_;
};

using CurvedEdges = std::vector<std::pair<Corners, std::array<double, 3>>>;

/// Returns the midpoint nodes that are not half-way between the ends of their edges, with the point numbers of these
/// ends.
CurvedEdges curved_edges_of(const ModelMesh& mesh, const std::vector<Index>& place) {
  CurvedEdges edges;
  for (const CurvedEdge& e : mesh.curved_edges) {
    const auto [first, second] = std::minmax(place[e.a], place[e.b]);
    edges.push_back({{first, second, no_index, no_index}, {e.middle.x, e.middle.y, e.middle.z}});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Compares the named elements, faces, edges and nodes of one file with those of another.
class Comparison {
 public:
  Comparison(const Places& places, std::string file, CheckResult& result)
      : places_(places), file_(std::move(file)), result_(result) {}

  /// Compares the elements, faces, edges or nodes that have the same name in both files. `what` describes them in
  /// messages, for example "faces of surface".
  void compare(const std::string& what, const NamedParts& given, const NamedParts& due) {
    std::set<std::string> names;
    for (const NamedParts* parts : {&given, &due})
      for (const auto& [name, list] : *parts) names.insert(name);
    for (const std::string& name : names) {
      const auto g = given.find(name), d = due.find(name);
      const std::string named = what + " '" + name + "'";
      if (g == given.end())
        tell(d->second, named + " are in " + file_ + ", and nothing has that name here");
      else if (d == due.end())
        tell(g->second, named + " are here, and nothing has that name in " + file_);
      else
        tell(in_one_alone(g->second, d->second), named + " are here or in " + file_ + " alone");
    }
  }
  /// Compares the midpoint nodes of both files that are not half-way between the ends of their edges.
  void compare(const CurvedEdges& given, const CurvedEdges& due) {
    std::vector<Corners> edges;
    for (const auto& [ends, middle] : in_one_alone(given, due)) edges.push_back(ends);
    tell(edges, "nodes in the middle of edges are here or in " + file_ + " alone");
  }

 private:
  template <class T>
  static std::vector<T> in_one_alone(const std::vector<T>& a, const std::vector<T>& b) {
    std::vector<T> different;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(different));
    return different;
  }
  void tell(const std::vector<Corners>& parts, const std::string& what) {
    if (parts.empty()) return;
    const std::size_t n = parts.size();
    result_.faults.push_back({fault_id, std::to_string(n) + " " + what, n, {}, places_[parts.front().front()]});
  }

  const Places& places_;
  std::string file_;
  CheckResult& result_;
};

/// Returns the number of each mesh point in `places`, the points of the .vtu. If a point is missing in the .vtu,
/// reports it and returns nothing.
std::optional<std::vector<Index>> places_of(const ModelMesh& mesh, const Places& places, const std::string& file,
                                            CheckResult& result) {
  FaultCollector elsewhere(fault_id);
  std::vector<Index> found;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto place = places.find(mesh.points[v]);
    if (!place) elsewhere.add(v, mesh.points[v]);
    found.push_back(place.value_or(0));
  }
  const bool is_all = elsewhere.count() == 0;
  elsewhere.report(result, "points are at no point of " + file);
  if (!is_all) return std::nullopt;
  return found;
}

/// Rounds all coordinates to the number of digits that the file format stores.
void round_to_fields(ModelMesh& mesh, const Format& format) {
  if (!format.rounded) return;
  const auto round = [&](Vec3& p) { p = {format.rounded(p.x), format.rounded(p.y), format.rounded(p.z)}; };
  for (Vec3& p : mesh.points) round(p);
  for (CurvedEdge& e : mesh.curved_edges) round(e.middle);
}

bool compare_files(const std::filesystem::path& mesh, const Format& format, const std::filesystem::path& vtu,
                   const WriteOptions& output, CheckResult& result) {
  ElementOrder order{}, order_due{};
  const ModelMesh given = read_model_mesh(mesh, &order);
  ModelMesh due = read_model_mesh(vtu, &order_due);
  round_to_fields(due, format);
  const std::string file = vtu.filename().string();
  const Places places(due);
  const auto given_places = places_of(given, places, file, result);
  if (!given_places) return false;
  const std::size_t n_faults = result.faults.size();
  const NamedMesh a = Namer(given, *given_places, output).run();
  const std::vector<Index> due_places = *places_of(due, places, file, result);
  const NamedMesh b = Namer(due, due_places, output).run();
  Comparison comparison(places, file, result);
  comparison.compare("elements of region", a.solids, b.solids);
  comparison.compare("elements of group", a.groups, b.groups);
  comparison.compare("faces of surface", a.faces, b.faces);
  if (!given.curve_edges.empty()) comparison.compare("edges of curve", a.edges, b.edges);
  comparison.compare("nodes of", a.nodes, b.nodes);
  if (order == order_due) comparison.compare(curved_edges_of(given, *given_places), curved_edges_of(due, due_places));
  result.checks_done.push_back("what stands under each name was held against " + file);
  return result.faults.size() == n_faults;
}

}  // namespace

bool check_as_in_vtu(const std::filesystem::path& mesh, const WriteOptions& output, CheckResult& result) {
  const Format* const format = format_of_file(mesh);
  if (!format || !format->read || format->name == "vtu") return false;
  const std::filesystem::path vtu = mesh.parent_path() / (mesh.stem().string() + ".vtu");
  const auto pass_over = [&](const std::string& why) {
    result.checks_done.push_back("names were not held against " + vtu.filename().string() + ": " + why);
    return false;
  };
  if (!std::filesystem::exists(vtu)) return pass_over("it is not there");
  if (!std::filesystem::exists(vtu.string() + ".json"))
    return pass_over("no file of geomesh, with " + vtu.filename().string() + ".json beside it");
  if (!format->holds.names) return pass_over("the format has no names");
  try {
    return compare_files(mesh, *format, vtu, output, result);
  } catch (const Error& e) {
    return pass_over(e.what());
  }
}

}  // namespace geomesh::geomodel::checking

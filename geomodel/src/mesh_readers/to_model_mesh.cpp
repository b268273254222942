// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the sets of a mesh file to regions, surfaces, curves and named nodes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "mesh_readers/file_names.hpp"
#include "mesh_readers/raw_mesh.hpp"
#include "solver_mesh/face_sides.hpp"
#include "solver_mesh/second_order.hpp"

namespace geomesh::geomodel {
namespace {

/// Name, kind and cells of a surface, curve or point that will be added to the mesh.
struct Wanted {
  std::string name, kind;
  std::vector<std::size_t> rows;
};

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

SurfaceKind surface_kind(const std::string& word) {
  for (const SurfaceKind kind : {SurfaceKind::horizon, SurfaceKind::fault, SurfaceKind::body, SurfaceKind::box})
    if (word == to_string(kind)) return kind;
  return SurfaceKind::surface;
}

/// Returns the name of a surface without its side: `fault.minus` and `fault.plus`, for example, are sides of one
/// surface.
std::string without_side(const std::string& name) {
  for (const std::string_view side : {".minus", ".plus", ".faces"})
    if (name.size() > side.size() && name.ends_with(side)) return name.substr(0, name.size() - side.size());
  return name;
}

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::string place(const Vec3& p) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << p.x << ", " << p.y << ", " << p.z << ')';
  return text.str();
}

/// Throws Error{invalid_input} if a coordinate or the origin is not a finite number or exceeds the range of the exact
/// arithmetic. The message names the point and a cell that has it. Points that no tetrahedron uses are not checked.
void require_finite(const RawMesh& mesh, const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& what, const Vec3& p) {
    throw Error(ErrorKind::invalid_input,
                file.string() + ": " + what + " at " + place(p) + ": " +
                    (is_finite(p) ? "a coordinate is too large or too small for exact arithmetic (2^-148 to 2^148)"
                                  : "a coordinate is no finite number"));
  };
  if (!is_finite(mesh.origin)) refuse("its origin", mesh.origin);
  const auto look = [&](const std::vector<VertexIndex>& points, std::size_t n_a_cell) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = mesh.points[points[i]];
      if (exponents_are_safe({&p, 1})) continue;
      refuse("point " + std::to_string(points[i]) + " of tetrahedron " + std::to_string(i / n_a_cell) +
                 " (both counted from 0)",
             p);
    }
  };
  look(mesh.cells[3].corners, 4);
  look(mesh.midpoints, 6);
}

class ModelMeshBuilder {
 public:
  ModelMeshBuilder(RawMesh raw, const std::filesystem::path& file)
      : raw_(std::move(raw)), file_(file), names_(read_file_names(raw_.whole.empty() ? file : raw_.whole)) {
    if (raw_.n_other_solids > 0)
      refuse(file, std::to_string(raw_.n_other_solids) +
                       " of its solids are no tetrahedra (hexahedra, prisms ...); split them "
                       "first");
    if (raw_.cells[3].size() == 0) refuse(file, "it holds no tetrahedra");
    require_finite(raw_, file);
    mesh_.name = raw_.name.empty() ? (raw_.whole.empty() ? file : raw_.whole).stem().string() : raw_.name;
    mesh_.origin = names_.origin.value_or(raw_.origin);
    if (!names_.unit.empty()) mesh_.unit = names_.unit;
    name_unnamed_sets();
  }

  ModelMesh build() {
    keep_used_points();
    add_tetrahedra();
    add_curved_edges();
    add_regions();
    add_faces();
    add_curves();
    add_points();
    add_node_sets();
    add_region_groups();
    add_arrays();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] static void refuse(const std::filesystem::path& file, const std::string& why) {
    throw Error(ErrorKind::invalid_input, file.string() + ": " + why);
  }
  void name_unnamed_sets() {
    const char* const what[] = {"point_", "curve_", "surface_", "region_"};
    for (RawSet& set : raw_.sets)
      if (set.name.empty()) set.name = (set.dimension < 0 ? "nodes_" : what[set.dimension]) + std::to_string(set.id);
  }
  void keep_used_points() {
    row_.assign(raw_.points.size(), no_vertex);
    for (const VertexIndex v : raw_.cells[3].corners) row_[v] = 0;
    const bool ours = raw_.point_kind.size() == row_.size() && raw_.input_vertex.size() == row_.size();
    for (std::size_t v = 0; v < row_.size(); ++v) {
      if (row_[v] == no_vertex) continue;
      row_[v] = static_cast<VertexIndex>(mesh_.points.size());
      mesh_.points.push_back(raw_.points[v]);
      if (raw_.before_zones.size() == row_.size()) mesh_.before_zones.push_back(raw_.before_zones[v]);
      mesh_.point_kind.push_back(ours ? static_cast<std::uint8_t>(raw_.point_kind[v]) : 0);
      mesh_.input_vertex.push_back(ours ? raw_.input_vertex[v] : -1);
    }
  }
  void add_tetrahedra() {
    const std::vector<VertexIndex>& c = raw_.cells[3].corners;
    for (std::size_t t = 0; t < raw_.cells[3].size(); ++t) {
      Tetrahedron v{row_[c[4 * t]], row_[c[4 * t + 1]], row_[c[4 * t + 2]], row_[c[4 * t + 3]]};
      if (orient3d(mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]], mesh_.points[v[3]]) == Sign::negative)
        std::swap(v[2], v[3]);
      mesh_.tetrahedra.push_back(v);
    }
  }

  /// Returns the values of the point arrays at a midpoint node; nothing if all are means of those at the edge's ends.
  std::vector<double> values_at(VertexIndex middle, VertexIndex first, VertexIndex second) const {
    std::vector<double> values;
    bool are_means = true;
    for (const PointArray& array : raw_.point_arrays) {
      const double value = array.values[middle], mean = half_way(array.values[first], array.values[second]);
      are_means = are_means && (value == mean || (std::isnan(value) && std::isnan(mean)));
      values.push_back(value);
    }
    return are_means ? std::vector<double>{} : values;
  }

  /// Stores midpoint nodes that are not exactly half-way between the ends of their edge, or have values of their own,
  /// so that they are written as they were read.
  void add_curved_edges() {
    constexpr std::size_t ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    if (raw_.midpoints.size() != 6 * mesh_.tetrahedra.size()) return;
    std::vector<CurvedEdge>& edges = mesh_.curved_edges;
    for (std::size_t i = 0; i < raw_.midpoints.size(); ++i) {
      const auto& [first, second] = ends[i % 6];
      const VertexIndex* const corner = &raw_.cells[3].corners[i / 6 * 4];
      const auto [a, b] = std::minmax(row_[corner[first]], row_[corner[second]]);
      const Vec3 &p = mesh_.points[a], &q = mesh_.points[b], &middle = raw_.points[raw_.midpoints[i]];
      std::vector<double> values = values_at(raw_.midpoints[i], corner[first], corner[second]);
      if (!(middle == half_way(p, q)) || !values.empty()) edges.push_back({a, b, middle, std::move(values)});
    }
    std::sort(edges.begin(), edges.end(),
              [](const CurvedEdge& p, const CurvedEdge& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
    for (std::size_t k = 1; k < edges.size(); ++k)
      if (edges[k].a == edges[k - 1].a && edges[k].b == edges[k - 1].b && !(edges[k].middle == edges[k - 1].middle))
        refuse(file_, "two elements of second order have their node in the middle of one edge at different places");
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const CurvedEdge& p, const CurvedEdge& q) { return p.a == q.a && p.b == q.b; }),
                edges.end());
  }

  void add_arrays() {
    std::map<std::string, RegionAttribute> attributes;
    for (const FullName& full : names_.regions)
      for (const auto& [name, value] : full.attributes) {
        RegionAttribute& attribute = attributes[name];
        attribute.name = name;
        attribute.by_region.resize(mesh_.regions.size(), std::numeric_limits<double>::quiet_NaN());
        for (const Region& region : mesh_.regions)
          if (region.name == full.name) attribute.by_region[static_cast<std::size_t>(region.id - 1)] = value;
      }
    for (CellArray& array : raw_.cell_arrays) {
      if (attributes.contains(array.name)) continue;
      if (const auto unit = names_.field_units.find(array.name); unit != names_.field_units.end())
        array.unit = unit->second;
      mesh_.cell_arrays.push_back(std::move(array));
    }
    for (auto& [name, attribute] : attributes) mesh_.attributes.push_back(std::move(attribute));
    for (const PointArray& array : raw_.point_arrays) {
      PointArray kept{array.name, std::vector<double>(mesh_.points.size()), ""};
      if (const auto unit = names_.field_units.find(array.name); unit != names_.field_units.end())
        kept.unit = unit->second;
      for (std::size_t v = 0; v < row_.size(); ++v)
        if (row_[v] != no_vertex) kept.values[row_[v]] = array.values[v];
      mesh_.point_arrays.push_back(std::move(kept));
    }
  }
  void add_region_groups() {
    for (const auto& [name, ids] : names_.region_groups) {
      if (std::any_of(mesh_.groups.begin(), mesh_.groups.end(),
                      [&name = name](const RegionGroup& g) { return g.name == name; }))
        continue;
      RegionGroup group{name, {}};
      for (const std::int32_t id : ids)
        for (const Region& region : mesh_.regions)
          if (const auto full = names_.region_ids.find(id);
              full != names_.region_ids.end() && full->second == region.name)
            group.regions.push_back(region.id);
      if (!group.regions.empty()) mesh_.groups.push_back(std::move(group));
    }
  }

  /// Returns a mesh file's sets of one dimension, by their full names if these are known, else as named in the file.
  std::vector<Wanted> wanted(int dimension, const std::vector<FullName>& full_names) const {
    std::vector<Wanted> list;
    std::map<std::string, std::size_t> row_of_name;
    const auto give = [&](const std::string& name, const std::string& kind) -> Wanted& {
      const auto [entry, is_new] = row_of_name.try_emplace(name, list.size());
      if (is_new) list.push_back({name, kind, {}});
      return list[entry->second];
    };
    std::set<std::string> known;
    std::size_t n_rows = 0;
    for (const RawSet& set : raw_.sets) n_rows += set.rows.size();
    SetBudget budget(n_rows);  // limits the work: a set of cells may have many names, and a name many such sets
    for (const FullName& full : full_names) {
      for (const RawSet& set : raw_.sets) {
        if (set.dimension != dimension || std::find(full.sets.begin(), full.sets.end(), set.name) == full.sets.end())
          continue;
        if (!budget.take(set.rows.size())) refuse(file_, "names beside it: its sets are named too many times");
        Wanted& item = give(full.name, full.kind);
        item.rows.insert(item.rows.end(), set.rows.begin(), set.rows.end());
        known.insert(set.name);
      }
    }
    for (const RawSet& set : raw_.sets) {
      if (set.dimension != dimension || known.contains(set.name)) continue;
      Wanted& item = give(dimension == 2 ? without_side(set.name) : set.name, "");
      item.rows.insert(item.rows.end(), set.rows.begin(), set.rows.end());
    }
    return list;
  }

  /// Makes a region from tetrahedra that are in the same sets. Its name is that of a set which contains exactly this
  /// region, else the names of its sets joined by `+`. Sets of several regions become groups.
  void add_regions() {
    const std::vector<Wanted> sets = wanted(3, names_.regions);
    std::vector<std::vector<std::size_t>> sets_of(mesh_.tetrahedra.size());
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (const std::size_t t : sets[s].rows)
        if (sets_of[t].empty() || sets_of[t].back() != s) sets_of[t].push_back(s);
    std::map<std::vector<std::size_t>, std::size_t> n_of;
    for (const auto& list : sets_of) ++n_of[list];
    std::vector<std::size_t> n_regions(sets.size(), 0);
    for (const auto& [list, n] : n_of)
      for (const std::size_t s : list) ++n_regions[s];
    std::map<std::vector<std::size_t>, std::int32_t> id_of;
    for (const auto& [list, n] : n_of) {
      std::string name;
      for (const std::size_t s : list)
        if (n_regions[s] == 1 && name.empty()) name = sets[s].name;
      if (name.empty())
        for (const std::size_t s : list) name += (name.empty() ? "" : "+") + sets[s].name;
      const auto id = static_cast<std::int32_t>(mesh_.regions.size() + 1);
      id_of[list] = id;
      mesh_.regions.push_back({id, name.empty() ? "region_" + std::to_string(id) : name, {}});
    }
    for (std::size_t s = 0; s < sets.size(); ++s) {
      RegionGroup group{sets[s].name, {}};
      for (const auto& [list, id] : id_of)
        if (std::find(list.begin(), list.end(), s) != list.end()) group.regions.push_back(id);
      const bool is_region =
          group.regions.size() == 1 && mesh_.regions[static_cast<std::size_t>(group.regions[0] - 1)].name == group.name;
      if (!is_region && !group.regions.empty()) mesh_.groups.push_back(std::move(group));
    }
    for (const auto& list : sets_of) {
      mesh_.tet_region.push_back(id_of[list]);
      ++mesh_.regions[static_cast<std::size_t>(mesh_.tet_region.back() - 1)].n_tetrahedra;
    }
    next_id_ = static_cast<std::int32_t>(mesh_.regions.size() + 1);
  }

  /// Adds each face once, with all its surfaces. Its normal points from the lower region id to the higher, or outwards.
  void add_faces() {
    std::map<Triangle, std::size_t> face_of;
    std::vector<std::vector<std::int32_t>> surfaces_of;
    std::vector<Triangle> faces;
    const std::vector<VertexIndex>& c = raw_.cells[2].corners;
    for (const Wanted& surface : wanted(2, names_.surfaces)) {
      const std::int32_t id = next_id_++;
      mesh_.surfaces.push_back({id, surface.name, surface_kind(surface.kind)});
      for (const std::size_t f : surface.rows) {
        const Triangle t{row_[c[3 * f]], row_[c[3 * f + 1]], row_[c[3 * f + 2]]};
        if (t[0] == no_vertex || t[1] == no_vertex || t[2] == no_vertex) continue;
        const auto [entry, is_new] = face_of.try_emplace(sorted(t), faces.size());
        if (is_new) {
          faces.push_back(t);
          surfaces_of.emplace_back();
        }
        auto& ids = surfaces_of[entry->second];
        if (ids.empty() || ids.back() != id) ids.push_back(id);
      }
    }
    const auto sides = tetrahedra_at_faces(mesh_.tetrahedra, faces);
    std::map<std::vector<std::int32_t>, std::int32_t> set_of;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto region = [&](std::size_t k) {
        return sides[f][k].tetrahedron == no_side ? 0 : mesh_.tet_region[sides[f][k].tetrahedron];
      };
      std::int32_t minus = region(0), plus = region(1);
      if (minus == 0 && plus == 0) continue;  // a triangle that is no face of a tetrahedron is left out
      if (minus == 0 || (plus != 0 && plus < minus)) {
        std::swap(minus, plus);
        std::swap(faces[f][1], faces[f][2]);
      }
      const auto [entry, is_new] =
          set_of.try_emplace(surfaces_of[f], static_cast<std::int32_t>(mesh_.surface_sets.size()));
      if (is_new) mesh_.surface_sets.push_back(surfaces_of[f]);
      mesh_.faces.push_back({faces[f], surfaces_of[f].front(), entry->second, entry->second + 1, minus, plus, -1});
    }
  }
  void add_curves() {
    const std::vector<VertexIndex>& c = raw_.cells[1].corners;
    for (const Wanted& curve : wanted(1, names_.curves)) {
      const std::int32_t id = next_id_++;
      mesh_.curves.push_back({id, curve.name, curve.kind.empty() ? "curve" : curve.kind});
      for (const std::size_t e : curve.rows) {
        const VertexIndex a = row_[c[2 * e]], b = row_[c[2 * e + 1]];
        if (a != no_vertex && b != no_vertex) mesh_.curve_edges.push_back({a, b, id});
      }
    }
  }
  void add_points() {
    for (const Wanted& point : wanted(0, names_.points))
      for (const std::size_t p : point.rows) {
        const VertexIndex v = row_[raw_.cells[0].corners[p]];
        if (v != no_vertex) mesh_.marked_points.push_back({v, next_id_++, point.name});
      }
  }
  /// Omits node sets that equal the nodes of a region, surface, curve or point with the same name.
  void add_node_sets() {
    std::set<std::string> taken;
    for (const Region& r : mesh_.regions) taken.insert(r.name);
    for (const NamedSurface& s : mesh_.surfaces) taken.insert(s.name);
    for (const NamedCurve& c : mesh_.curves) taken.insert(c.name);
    for (const auto& p : mesh_.marked_points) taken.insert(p.name);
    std::map<std::string, std::string> full_name;
    for (const auto* list : {&names_.surfaces, &names_.curves, &names_.points, &names_.node_sets})
      for (const FullName& full : *list)
        for (const std::string& set : full.sets) full_name.emplace(set, full.name);
    for (const RawSet& set : raw_.sets) {
      if (set.dimension != -1) continue;
      const auto full = full_name.find(set.name);
      const std::string name = full == full_name.end() ? set.name : full->second;
      if (taken.contains(name)) continue;
      NodeSet nodes{next_id_++, name, {}};
      for (const std::size_t v : set.rows)
        if (row_[v] != no_vertex) nodes.nodes.push_back(row_[v]);
      std::sort(nodes.nodes.begin(), nodes.nodes.end());
      nodes.nodes.erase(std::unique(nodes.nodes.begin(), nodes.nodes.end()), nodes.nodes.end());
      mesh_.node_sets.push_back(std::move(nodes));
    }
  }

  RawMesh raw_;
  const std::filesystem::path& file_;
  FileNames names_;
  ModelMesh mesh_;
  std::vector<VertexIndex> row_;  // for each point of the mesh file: its row in the mesh
  std::int32_t next_id_ = 1;
};

}  // namespace

ModelMesh to_model_mesh(RawMesh raw, const std::filesystem::path& file) {
  return ModelMeshBuilder(std::move(raw), file).build();
}

ModelMesh read_model_mesh(const std::filesystem::path& file, ElementOrder* order) {
  const Format* const format = format_of_file(file);
  if (!format || !format->read) {
    std::string known;
    for (const Format& f : formats())
      if (f.read && known.find(f.extensions.front()) == std::string::npos)
        known += (known.empty() ? "" : ", ") + f.extensions.front();
    throw Error(ErrorKind::usage, file.string() + ": meshes of this extension are not read; read are " + known);
  }
  RawMesh raw = format->read(file);
  if (order) *order = raw.second_order ? ElementOrder::second : ElementOrder::first;
  return to_model_mesh(std::move(raw), file);
}

}  // namespace geomesh::geomodel

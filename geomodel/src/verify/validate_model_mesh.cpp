// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the invariants of a mesh with named regions and surfaces, declared in geomesh/geomodel/build_model.hpp.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "common/chunks.hpp"
#include "common/parallel.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/build_model.hpp"
#include "verify/curves_at_faces.hpp"
#include "verify/face_uses.hpp"
#include "verify/fault_list.hpp"

namespace geomesh::geomodel {

namespace {

bool check_indices(const ModelMesh& m, unsigned threads, std::vector<std::string>& faults) {
  const std::size_t n = m.points.size(), before = faults.size();
  if (m.point_kind.size() != n || m.input_vertex.size() != n) faults.push_back("point arrays differ in length");
  if (m.tet_region.size() != m.tetrahedra.size()) faults.push_back("tet_region differs in length from tetrahedra");
  if (std::max({n, m.tetrahedra.size(), m.faces.size()}) >= FaceUse::limit) {
    faults.push_back("there are more than 2^31 points, tetrahedra or faces");
    return false;
  }
  const auto bad = [&](auto first, auto last) {
    return std::any_of(first, last, [&](VertexIndex v) { return v >= n; });
  };
  FaultList tets("tetrahedra with a vertex out of range"), faces("faces with a vertex or surface set out of range"),
      curves("curve edges with a vertex out of range"), marked("marked points out of range");
  const Chunks chunks(m.tetrahedra.size());
  std::vector<FaultList> tets_of_chunk(chunks.size(), tets);
  chunks.for_each(threads, [&](std::size_t k, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      if (bad(m.tetrahedra[t].begin(), m.tetrahedra[t].end())) tets_of_chunk[k].add(t);
  });
  for (const FaultList& of_chunk : tets_of_chunk) tets.append(of_chunk);
  for (std::size_t f = 0; f < m.faces.size(); ++f)
    if (bad(m.faces[f].vertices.begin(), m.faces[f].vertices.end()) || m.faces[f].surface_set < 0 ||
        static_cast<std::size_t>(m.faces[f].surface_set) >= m.surface_sets.size())
      faces.add(f);
  for (std::size_t e = 0; e < m.curve_edges.size(); ++e)
    if (m.curve_edges[e].a >= n || m.curve_edges[e].b >= n) curves.add(e);
  for (std::size_t p = 0; p < m.marked_points.size(); ++p)
    if (m.marked_points[p].v >= n) marked.add(p);
  for (const FaultList& list : {tets, faces, curves, marked}) list.flush(faults);
  return faults.size() == before;
}

void check_points(const ModelMesh& m, unsigned threads, std::vector<std::string>& faults) {
  FaultList unused("points of no tetrahedron"), not_finite("points that are not finite"),
      equal("points equal to another"), order("input points after added ones");
  std::vector<std::uint8_t> used(m.points.size(), 0);
  Chunks(m.tetrahedra.size()).for_each(threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (const VertexIndex v : m.tetrahedra[t]) std::atomic_ref(used[v]).store(1, std::memory_order_relaxed);
  });
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    if (!used[v]) unused.add(v);
    if (!std::isfinite(m.points[v].x) || !std::isfinite(m.points[v].y) || !std::isfinite(m.points[v].z))
      not_finite.add(v);
    if (v > 0 && m.point_kind[v] == 0 && m.point_kind[v - 1] != 0) order.add(v);
  }
  std::vector<VertexIndex> sorted(m.points.size());
  std::iota(sorted.begin(), sorted.end(), VertexIndex{0});
  const auto less = [&](VertexIndex a, VertexIndex b) { return compare_lexicographic(m.points[a], m.points[b]) < 0; };
  in_arena(threads, [&] { parallel_sort(sorted.begin(), sorted.end(), less); });
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (m.points[sorted[k]] == m.points[sorted[k - 1]]) equal.add(std::max(sorted[k], sorted[k - 1]));
  for (const FaultList& list : {unused, not_finite, equal, order}) list.flush(faults);
}

/// Joins the lists of defects that threads found in the chunks, and reports the result.
void flush_joined(const std::vector<FaultList>& by_chunk, std::vector<std::string>& faults) {
  if (by_chunk.empty()) return;
  FaultList joined(by_chunk.front().what());
  for (const FaultList& list : by_chunk) joined.append(list);
  joined.flush(faults);
}

void check_tetrahedra(const ModelMesh& m, unsigned threads, std::vector<std::string>& faults) {
  const Chunks chunks(m.tetrahedra.size());
  std::vector<FaultList> flat(chunks.size(), FaultList("tetrahedra that are not positive")),
      nameless(chunks.size(), FaultList("tetrahedra of no named region"));
  std::vector<std::vector<std::size_t>> counts(chunks.size(), std::vector<std::size_t>(m.regions.size(), 0));
  chunks.for_each(threads, [&](std::size_t k, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Tetrahedron& v = m.tetrahedra[t];
      if (orient3d(m.points[v[0]], m.points[v[1]], m.points[v[2]], m.points[v[3]]) != Sign::positive) flat[k].add(t);
      const std::int32_t region = m.tet_region[t];
      if (region < 1 || static_cast<std::size_t>(region) > m.regions.size()) {
        nameless[k].add(t);
      } else {
        ++counts[k][static_cast<std::size_t>(region - 1)];
      }
    }
  });
  flush_joined(flat, faults);
  flush_joined(nameless, faults);
  for (std::size_t r = 0; r < m.regions.size(); ++r) {
    const Region& region = m.regions[r];
    std::size_t count = 0;
    for (const auto& of_chunk : counts) count += of_chunk[r];
    if (region.id != static_cast<std::int32_t>(r + 1)) faults.push_back("region ids do not count from 1");
    if (region.n_tetrahedra != count)
      faults.push_back("region " + region.name + " states a wrong number of tetrahedra");
  }
}

using NamedFaults = std::map<std::string, FaultList>;

/// Checks that tetrahedra and constrained faces fit together at one triangle of the mesh. `uses` are its faces: all
/// have the same three vertices.
void check_one_face(const ModelMesh& m, std::span<const FaceUse> uses, NamedFaults& lists) {
  const auto report = [&](const char* what, std::size_t row) { lists.try_emplace(what, what).first->second.add(row); };
  const auto first_listed = std::find_if(uses.begin(), uses.end(), [](const FaceUse& use) { return use.is_listed(); });
  const std::span<const FaceUse> tets(uses.begin(), first_listed), listed(first_listed, uses.end());
  if (tets.size() == 2 && listed.empty() && tets[0].even() != tets[1].even() &&
      m.tet_region[tets[0].row()] == m.tet_region[tets[1].row()])
    return;  // most faces
  if (tets.size() > 2) report("tetrahedra that share a face with two others", tets[2].row());
  if (tets.size() == 2 && tets[0].even() == tets[1].even())
    report("tetrahedra that overlap their neighbour", tets[0].row());
  if (listed.size() > 1) report("faces listed twice", listed[1].row());
  if (tets.empty()) report("faces that are no face of a tetrahedron", listed[0].row());
  if (tets.empty() || tets.size() > 2) return;
  if (listed.empty()) {
    const bool in_hull =
        m.regions[static_cast<std::size_t>(m.tet_region[tets[0].row()] - 1)].name.rfind("hull", 0) == 0;
    if (tets.size() == 2 && m.tet_region[tets[0].row()] != m.tet_region[tets[1].row()])
      report("tetrahedra next to another region without a face between", tets[0].row());
    if (tets.size() == 1 && !in_hull) report("tetrahedra on the outer boundary without a face there", tets[0].row());
    return;
  }
  // Faces of a tetrahedron are counter-clockwise as seen from inside, so their normals point inwards. A constrained
  // face in the same order thus has the tetrahedron on its plus side.
  std::int32_t minus = 0, plus = 0;
  for (const FaceUse& t : tets) (t.even() == listed[0].even() ? plus : minus) = m.tet_region[t.row()];
  const ModelMesh::Face& face = m.faces[listed[0].row()];
  if (face.region_minus != minus || face.region_plus != plus)
    report("faces whose regions differ from those of the tetrahedra there", listed[0].row());
  if (minus == 0 || (plus != 0 && plus < minus))
    report("faces whose normal does not point from the lower region id to the higher", listed[0].row());
}

void check_faces(const ModelMesh& m, unsigned threads, std::vector<std::string>& faults) {
  const FaceUses uses(m, threads);
  std::vector<NamedFaults> by_block(uses.n_blocks());
  for_each_task(uses.n_blocks(), threads, [&](std::size_t b) {
    const std::span<const FaceUse> block = uses.block(b);
    for (std::size_t begin = 0; begin < block.size();) {
      std::size_t end = begin + 1;
      while (end < block.size() && block[end].same_triangle(block[begin])) ++end;
      check_one_face(m, block.subspan(begin, end - begin), by_block[b]);
      begin = end;
    }
  });
  NamedFaults lists;
  for (const NamedFaults& of_block : by_block)
    for (const auto& [what, list] : of_block) lists.try_emplace(what, what).first->second.append(list);
  FaultList sets("faces whose surface is not the first of its set");
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    const auto& set = m.surface_sets[static_cast<std::size_t>(m.faces[f].surface_set)];
    if (set.empty() || set.front() != m.faces[f].surface) sets.add(f);
  }
  for (const auto& [what, list] : lists) list.flush(faults);
  sets.flush(faults);
}

void check_curves(const ModelMesh& m, unsigned threads, std::vector<std::string>& faults) {
  if (m.curve_edges.empty()) return;
  std::vector<std::pair<VertexIndex, VertexIndex>> wanted;
  for (const auto& e : m.curve_edges) wanted.emplace_back(std::min(e.a, e.b), std::max(e.a, e.b));
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::vector<bool> on_curve(m.points.size(), false);
  std::vector<std::uint8_t> found(wanted.size(), 0);
  for (const auto& [a, b] : wanted) on_curve[a] = on_curve[b] = true;
  const auto look_for_edges = [&](const Tetrahedron& t) {
    for (const auto& [i, j] : edge_vertices) {
      if (!on_curve[t[i]] || !on_curve[t[j]]) continue;
      const std::pair key(std::min(t[i], t[j]), std::max(t[i], t[j]));
      const auto at = std::lower_bound(wanted.begin(), wanted.end(), key);
      if (at == wanted.end() || *at != key) continue;
      std::atomic_ref(found[static_cast<std::size_t>(at - wanted.begin())]).store(1, std::memory_order_relaxed);
    }
  };
  Chunks(m.tetrahedra.size()).for_each(threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) look_for_edges(m.tetrahedra[t]);
  });
  FaultList missing("curve edges that are no edge of a tetrahedron");
  for (std::size_t e = 0; e < wanted.size(); ++e)
    if (!found[e]) missing.add(e);
  missing.flush(faults);
}

void check_ids(const ModelMesh& m, std::vector<std::string>& faults) {
  std::set<std::int32_t> seen;
  const auto add = [&](std::int32_t id, const std::string& name) {
    if (id < 1 || !seen.insert(id).second)
      faults.push_back("id " + std::to_string(id) + " of " + name + " is not positive or used twice");
  };
  std::set<std::string> names;
  for (const Region& r : m.regions) {
    add(r.id, r.name);
    if (r.name.empty() || !names.insert(r.name).second)
      faults.push_back("region name '" + r.name + "' is empty or used twice");
  }
  std::set<std::int32_t> surfaces, curves;
  for (const NamedSurface& s : m.surfaces) {
    add(s.id, s.name);
    surfaces.insert(s.id);
  }
  for (const NamedCurve& c : m.curves) {
    add(c.id, c.name);
    curves.insert(c.id);
  }
  for (const auto& p : m.marked_points) add(p.id, p.name);
  for (const auto& set : m.surface_sets)
    for (std::int32_t id : set)
      if (!surfaces.contains(id))
        faults.push_back("a surface set names id " + std::to_string(id) + ", which is no surface");
  FaultList bad("curve edges of no named curve");
  for (std::size_t e = 0; e < m.curve_edges.size(); ++e)
    if (!curves.contains(m.curve_edges[e].curve)) bad.add(e);
  bad.flush(faults);
}

}  // namespace

std::vector<std::string> validate_model_mesh(const ModelMesh& mesh, unsigned threads) {
  std::vector<std::string> faults;
  if (!check_indices(mesh, threads, faults)) return faults;
  check_points(mesh, threads, faults);
  check_tetrahedra(mesh, threads, faults);
  if (faults.empty()) check_faces(mesh, threads, faults);
  check_curves(mesh, threads, faults);
  check_curves_at_faces(mesh, faults);
  check_ids(mesh, faults);
  return faults;
}

}  // namespace geomesh::geomodel

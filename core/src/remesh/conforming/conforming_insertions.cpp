// SPDX-License-Identifier: MIT
// The insertions of ConformingRefiner, declared in remesh/conforming/conforming_refiner.hpp.
#include <algorithm>
#include <map>

#include "common/geometry.hpp"
#include "mesh/circumcentre.hpp"
#include "remesh/conforming/conforming_refiner.hpp"

namespace geomesh::remesh {

using recover::Subsegment;
using recover::VertexRecord;

/// Finds the cells whose circumsphere contains p. Returns nothing if a vertex of these cells is too near to p; the
/// vertex nearest to p is always among them.
std::optional<ConformingRefiner::Place> ConformingRefiner::find_place(const Vec3& p, CellIndex start, double size) {
  Place place{p, recover::conflict_cells(mesh_, p, start)};
  if (place.cavity.empty()) return std::nullopt;
  const double least = min_spacing * size;
  for (const CellIndex c : place.cavity)
    for (const VertexIndex v : mesh_.cells().vertices(c))
      if (squared_distance(mesh_.point(v), p) < least * least) return std::nullopt;
  return place;
}

/// Finds a subsegment whose diametral sphere contains p. The cell at this subsegment on p's side has p in its
/// circumsphere, so the subsegment is an edge of a cell of the cavity. Returns no_index if there is none.
Index ConformingRefiner::encroached_subsegment(const Place& place) const {
  Index least = no_index;
  for (const CellIndex c : place.cavity)
    for (const auto& e : edge_vertices) {
      const VertexIndex a = mesh_.cells().vertices(c)[e[0]], b = mesh_.cells().vertices(c)[e[1]];
      const Index s = constraints_.subsegment_of(a, b);
      if (s != no_index && s < least && dot(mesh_.point(a) - place.p, mesh_.point(b) - place.p) < 0) least = s;
    }
  return least;
}

std::optional<ConformingRefiner::FaceOfFacet> ConformingRefiner::encroached_face(const Place& place) const {
  for (const CellIndex c : place.cavity)
    for (unsigned i = 0; i < 4; ++i) {
      const Index f = facet_of(c, i);
      if (f == no_index || facet_is_given_up_[f]) continue;
      const Triangle t = face_of(mesh_.cells().vertices(c), i);
      const auto centre = circumcentre(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
      if (centre && squared_distance(place.p, *centre) < squared_distance(mesh_.point(t[0]), *centre))
        return FaceOfFacet{t, f};
    }
  return std::nullopt;
}

bool ConformingRefiner::insert_in_cell(CellIndex c, const Vec3& centre) {
  const Index component = label_[c];
  const auto place = find_place(centre, c, size_at(centre, component));
  if (!place) return false;
  if (const Index s = encroached_subsegment(*place); s != no_index) return split_long(s);
  if (const auto face = encroached_face(*place)) return insert_in_face(*face);
  for (const CellIndex other : place->cavity)
    if (label_[other] != component && label_[other] != no_index)
      return false;  // The cavity reaches into another component.
  put(*place, {VertexOrigin::inside, no_index}, [](VertexIndex) {}, {}, {no_vertex, no_vertex});
  for (const CellIndex fresh : mesh_.last_created()) label_[fresh] = component;
  ++counts_.inside;
  return true;
}

/// Returns the neighbouring face in the same facet across the edge a-b.
std::optional<ConformingRefiner::FaceOfFacet> ConformingRefiner::next_face(const FaceOfFacet& face, VertexIndex a,
                                                                           VertexIndex b) {
  const CellIndex c = mesh_.find_edge(a, b);
  recover::EdgeRing ring;
  if (c == no_cell || !mesh_.ring(c, a, b, ring)) return std::nullopt;
  for (const VertexIndex w : ring.ring)
    if (std::find(face.vertices.begin(), face.vertices.end(), w) == face.vertices.end() &&
        facet_of_face_.find({a, b, w}) == face.facet)
      return FaceOfFacet{{a, b, w}, face.facet};
  return std::nullopt;
}

/// Walks within a facet from a face to its circumcentre and inserts it. Splits a subsegment on the way instead.
bool ConformingRefiner::insert_in_face(FaceOfFacet face) {
  const auto at = [&](unsigned i) -> const Vec3& { return mesh_.point(face.vertices[i]); };
  const auto found = circumcentre(at(0), at(1), at(2));
  if (!found) return false;
  const Vec3 centre = *found;
  constexpr unsigned max_steps = 200;
  for (unsigned step = 0;; ++step) {
    if (step == max_steps) return false;
    const Vec3 n = cross(at(1) - at(0), at(2) - at(0));
    unsigned leave = 3;
    for (unsigned i = 0; i < 3 && leave == 3; ++i)
      if (dot(cross(at((i + 1) % 3) - at(i), centre - at(i)), n) < 0) leave = i;
    if (leave == 3) break;
    const VertexIndex a = face.vertices[leave], b = face.vertices[(leave + 1) % 3];
    if (const Index s = constraints_.subsegment_of(a, b); s != no_index) return split_long(s);
    const auto next = next_face(face, a, b);
    if (!next) return false;
    face = *next;
  }
  const Index facet = constraints_.subfacets[face.facet].facet;
  const auto place = find_place(centre, mesh_.cell_of(face.vertices[0]), size_on_facet(centre, facet));
  if (!place) return false;
  if (const Index s = encroached_subsegment(*place); s != no_index) return split_long(s);
  const auto declare = [&](VertexIndex x) {
    if (!constraints_.is_piece(face.facet)) constraints_.make_piece(face.facet);
    constraints_.add_member(face.facet, x);
  };
  put(*place, {VertexOrigin::on_facet, facet}, declare, {face.facet}, {no_vertex, no_vertex});
  ++counts_.on_facets;
  return true;
}

/// Splits the subsegment at its middle, or, next to a sharp vertex, on a concentric shell around that vertex.
bool ConformingRefiner::split_long(Index si) {
  const Subsegment s = constraints_.subsegments[si];
  const bool is_inner = s.segment == no_index;
  if (!s.live || (!is_inner && segment_is_given_up_[s.segment])) return false;
  // A subsegment missing in the mesh is queued already, and recovery will split it.
  if (mesh_.find_edge(s.a, s.b) == no_cell) return false;
  const Vec3 p = split_place(s);
  double size = size_at(p, no_index);
  for (const Index f : s.subfacets) size = std::min(size, size_on_facet(p, constraints_.subfacets[f].facet));
  const auto place = find_place(p, mesh_.cell_of(s.a), size);
  if (!place) return false;
  const VertexRecord record{is_inner ? VertexOrigin::on_facet : VertexOrigin::on_segment,
                            is_inner ? s.facet : s.segment};
  const auto declare = [&](VertexIndex x) {
    for (const Index half : constraints_.split_subsegment(si, x))
      if (!is_edge_of_new_star(constraints_.subsegments[half].a, constraints_.subsegments[half].b)) queue_segment(half);
  };
  put(*place, record, declare, s.subfacets, {s.a, s.b});
  ++(is_inner ? counts_.on_facets : counts_.on_segments);
  return true;
}

/// Inserts a vertex, calls `declare` to register the segment or facet that it lies on, and handles subsegments and
/// faces of facets that the insertion removed. In a facet that contains the vertex, the star of the vertex usually
/// replaces the removed faces; other facets are queued for recovery.
void ConformingRefiner::put(const Place& place, VertexRecord record, const std::function<void(VertexIndex)>& declare,
                            const std::vector<Index>& on_subfacets, std::array<VertexIndex, 2> split) {
  recover::insert_into(mesh_, place.p, place.cavity, insertion_);
  const VertexIndex x = insertion_.vertex;
  constraints_.vertices.resize(mesh_.points().size());
  constraints_.vertices[x] = record;
  label_.resize(mesh_.cells().n_slots(), no_index);
  for (const CellIndex fresh : mesh_.last_created()) label_[fresh] = no_index;
  declare(x);
  for (const auto& [a, b] : insertion_.edges) {
    const Index s = constraints_.subsegment_of(a, b);
    if (s != no_index && !is_edge_of_new_star(a, b)) queue_segment(s);
  }
  std::map<Index, std::vector<Triangle>> lost;  // by subfacet
  for (const Triangle& face : insertion_.faces) {
    const Index f = facet_of_face_.find(face);
    if (f == no_index) continue;
    facet_of_face_.erase(face);
    lost[f].push_back(face);
  }
  for (const auto& [f, faces] : lost) {
    const bool is_on = std::find(on_subfacets.begin(), on_subfacets.end(), f) != on_subfacets.end();
    if (!is_on || !renew_faces(x, f, faces, split)) queue_facet(f);
  }
}

/// Registers the star of x in the facet: triangles from x to each border edge of the lost faces, except for the
/// subsegment that x splits. Returns false if one of these triangles is no face of the mesh.
bool ConformingRefiner::renew_faces(VertexIndex x, Index subfacet, const std::vector<Triangle>& lost,
                                    std::array<VertexIndex, 2> split) {
  if (facet_queued_[subfacet]) return false;
  std::map<std::array<VertexIndex, 2>, int> uses;
  for (const Triangle& t : lost)
    for (unsigned i = 0; i < 3; ++i) ++uses[sorted(std::array{t[i], t[(i + 1) % 3]})];
  uses.erase(sorted(split));
  std::vector<Triangle> star;
  for (const auto& [e, n] : uses) {
    if (n != 1) continue;
    if (!mesh_.find_face(x, e[0], e[1]).valid()) return false;
    star.push_back({x, e[0], e[1]});
  }
  for (const Triangle& t : star) facet_of_face_.insert(t, subfacet);
  return true;
}

}  // namespace geomesh::remesh

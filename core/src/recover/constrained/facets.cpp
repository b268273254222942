// SPDX-License-Identifier: MIT
/// Recovers facets after all their segments. The mesh edges that pierce a missing subfacet are removed by flips; if
/// that fails, they are split one after the other where they pierce the subfacet. Splits of edges leave only
/// tetrahedra, so that the prisms and pyramids of Cavalcanti and Mello 1999 (section 3.3) never occur. After as many
/// splits as edges pierce the subfacet it is a union of faces, so this always terminates.
#include <algorithm>
#include <cmath>

#include "common/sort_unique.hpp"
#include "predicates/two_double.hpp"
#include "recover/constrained/exact_steps.hpp"
#include "recover/model/facet_trace.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/edge_removal.hpp"
#include "recover/operations/star_insertion.hpp"

namespace geomesh::recover {

namespace {

/// Forbids flips to create edges whose ends lie on different sides of the subfacet, because inside the ring of a
/// piercing edge such an edge pierces the subfacet, too.
class NoNewPiercing : public EdgeRule {
 public:
  explicit NoNewPiercing(const FacetSides& sides) : sides_(sides) {}
  bool forbids(VertexIndex a, VertexIndex b) const override { return sides_(a) * sides_(b) < 0; }

 private:
  const FacetSides& sides_;
};

class FacetRecovery {
 public:
  FacetRecovery(Recovery& recovery, Index subfacet)
      : recovery_(recovery),
        mesh_(recovery.mesh),
        subfacet_(subfacet),
        plane_(recovery.constraints.subfacets[subfacet].vertices),
        sides_(mesh_, plane_, members_of(recovery.constraints, subfacet)) {
    border_ = {{plane_[0], plane_[1]}, {plane_[1], plane_[2]}, {plane_[2], plane_[0]}};
    if (recovery.constraints.is_piece(subfacet)) border_ = recovery.constraints.piece_of(subfacet).border;
    is_plain_ = !recovery.constraints.is_piece(subfacet);
  }

  /// Locks the mesh faces that cover a piece of a facet. Returns false if no mesh faces cover it.
  bool as_it_is() {
    const FacetTrace trace = trace_piece(mesh_, recovery_.constraints, subfacet_);
    if (trace.status != FacetTrace::Status::complete) return false;
    commit(trace);
    return true;
  }

  bool by_flips(unsigned depth) {
    FacetTrace trace = checked_trace();
    while (trace.status == FacetTrace::Status::pierced) {
      std::vector<Piercing> left = all_of(trace);
      const std::size_t n_before = left.size();
      remove_by_flips(left, depth);
      if (left.size() == n_before) return false;
      trace = checked_trace();
    }
    if (trace.status != FacetTrace::Status::complete) return false;
    commit(trace);
    return true;
  }

  /// Recovers a subfacet, a triangle without added points, by filling the cavity of the edges that pierce it anew.
  bool by_cavity(std::size_t max_nodes) {
    const FacetTrace trace = checked_trace();
    if (trace.status != FacetTrace::Status::pierced || !is_plain_) return false;
    std::vector<CellIndex> cells;
    EdgeRing ring;
    for (const PiercingEdge& e : trace.piercing)
      if (mesh_.ring(mesh_.find_edge(e.below, e.above, e.cell), e.below, e.above, ring))
        cells.insert(cells.end(), ring.cells.begin(), ring.cells.end());
    sort_unique(cells);
    return recover_face_by_cavity(recovery_, plane_, std::move(cells), {max_nodes}) && by_flips(0);
  }

  /// Recovers the subfacet by points where mesh edges pierce it. Finding these edges takes time proportional to the
  /// facet's size, and a large polygon may need as many points. So they are found again only after the first points,
  /// and later when the last one found has been split: a point does not change the other edges.
  void by_points() {
    for (unsigned depth = recovery_budget.facet_depth_first; !by_flips(depth); depth = 1) {
      const FacetTrace trace = checked_trace();
      std::vector<Piercing> left = all_of(trace);
      if (trace.status == FacetTrace::Status::unclear || left.empty())
        recovery_.end(error_of_facet_not_recovered(recovery_, subfacet_));
      while (!left.empty() && !recovery_.has_ended()) {
        if (!split_one(left)) recovery_.end(error_of_facet_not_recovered(recovery_, subfacet_));
        if (may_trace_again()) break;
        remove_by_flips(left, 1);
      }
      if (recovery_.has_ended()) return;
    }
  }

 private:
  struct Piercing {
    PiercingEdge edge;
    /// 0 if flips have not tried to remove the edge; else 1 + the mesh's number of changes when they last failed
    std::size_t tried;
  };

  static std::vector<VertexIndex> members_of(const Constraints& constraints, Index subfacet) {
    if (constraints.is_piece(subfacet)) return constraints.piece_of(subfacet).members;
    const Triangle& t = constraints.subfacets[subfacet].vertices;
    return {t.begin(), t.end()};
  }

  /// Returns whether searches for the facet's faces in the mesh have found so few items that one more is allowed.
  bool may_trace_again() const { return n_traced_ < recovery_budget.traced_of_facet; }

  FacetTrace checked_trace() {
    FacetTrace trace = trace_facet(mesh_, sides_, border_);
    if (n_traced_ == 0) work_left_ = recovery_budget.flips_tried * trace.piercing.size();
    n_traced_ += trace.faces.size() + trace.piercing.size();
    if (trace.status == FacetTrace::Status::touched) {
      if (holds(trace.culprit)) recovery_.end(error_of_vertex_on_facet(recovery_, trace.culprit, subfacet_));
      trace.status = FacetTrace::Status::unclear;
    }
    for (const PiercingEdge& e : trace.piercing) {
      const Index s = recovery_.constraints.subsegment_of(e.below, e.above);
      if (s == no_index) continue;
      if (is_passed_by(e)) recovery_.end(error_of_segment_pierces_facet(recovery_, s, subfacet_));
      trace.status = FacetTrace::Status::unclear;
    }
    return trace;
  }

  // If rounding bends the facet's border at added points, the search for its faces may leave the facet through cells
  // that are flat in its plane, and meet other items there. Therefore an error needs an exact test against the corners.

  /// Returns whether the edge passes through the triangle of the subfacet's corners or touches it. The edges between
  /// the corners are then all on one side of the edge.
  bool is_passed_by(PiercingEdge e) const {
    bool left = false, right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign side = mesh_.orient(e.below, e.above, plane_[i], plane_[(i + 1) % 3]);
      left = left || side == Sign::positive;
      right = right || side == Sign::negative;
    }
    return !(left && right);
  }
  /// Returns whether the vertex lies in the triangle of the subfacet's corners, including its border; in the polygon
  /// itself if orientations are exact and no added point bends its border.
  bool holds(VertexIndex v) const {
    if (mesh_.orient(plane_[0], plane_[1], plane_[2], v) != Sign::zero) return false;
    const std::vector<VertexIndex> members = members_of(recovery_.constraints, subfacet_);
    const auto is_input = [&](VertexIndex u) { return u < mesh_.n_input(); };
    if (is_input(v) && !has_been_split_ && std::all_of(members.begin(), members.end(), is_input)) return true;
    const Vec3 normal = sides_.normal();
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const auto flat = [&](VertexIndex u) {
      return Vec2{mesh_.point(u)[(axis + 1) % 3], mesh_.point(u)[(axis + 2) % 3]};
    };
    const Sign whole = orient2d(flat(plane_[0]), flat(plane_[1]), flat(plane_[2]));
    for (std::size_t i = 0; i < 3; ++i)
      if (static_cast<int>(orient2d(flat(plane_[i]), flat(plane_[(i + 1) % 3]), flat(v))) * static_cast<int>(whole) < 0)
        return false;
    return true;
  }

  /// Returns the point at which the edge pierces the plane of the facet's input vertices. It is computed with twice a
  /// double's precision, because the plane of a thin triangle is known to fewer digits than its corners.
  Vec3 piercing_point(const PiercingEdge& e) const {
    using exact::TwoDouble;
    const Vec3 &p = mesh_.point(plane_[0]), &a = mesh_.point(e.below), &b = mesh_.point(e.above);
    std::array<TwoDouble, 3> u, v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = TwoDouble::difference(mesh_.point(plane_[1])[i], p[i]);
      v[i] = TwoDouble::difference(mesh_.point(plane_[2])[i], p[i]);
    }
    const std::array<TwoDouble, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const auto height = [&](const Vec3& x) {
      return n[0] * TwoDouble::difference(x.x, p.x) + n[1] * TwoDouble::difference(x.y, p.y) +
             n[2] * TwoDouble::difference(x.z, p.z);
    };
    const TwoDouble da = height(a), whole = da - height(b);
    TwoDouble s{0.5};
    if (whole.hi != 0) s = da / whole;
    if (!(s.hi > 0)) return a;
    if (!(s.hi < 1)) return b;
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = (TwoDouble{a[i]} + s * TwoDouble::difference(b[i], a[i])).hi;
    return out;
  }

  static std::vector<Piercing> all_of(const FacetTrace& trace) {
    std::vector<Piercing> out;
    for (const PiercingEdge& e : trace.piercing) out.push_back({e, 0});
    return out;
  }

  /// Removes as many of a list of edges that pierce the facet as flips can. No flip creates another such edge, so the
  /// list remains complete. Up to one level deep, flips examine only the cells at the edge's ends; if these have not
  /// changed since a failure, flips would fail again.
  void remove_by_flips(std::vector<Piercing>& left, unsigned depth) {
    EdgeRemover remover(mesh_, recovery_.constraints, &work_left_);
    const NoNewPiercing rule(sides_);
    for (bool progress = true; progress;) {
      progress = false;
      std::size_t n_kept = 0;
      for (Piercing p : left) {
        const PiercingEdge& e = p.edge;
        if (depth > 1 || p.tried == 0 || std::max(mesh_.last_change(e.below), mesh_.last_change(e.above)) >= p.tried) {
          const CellIndex cell = mesh_.find_edge(e.below, e.above, e.cell);
          if (cell == no_cell) continue;
          if (remover.remove(e.below, e.above, depth, &rule, EdgeRemover::most_edges, cell)) {
            progress = true;
            continue;
          }
          p.tried = 1 + mesh_.n_changes();
        }
        left[n_kept++] = p;
      }
      left.resize(n_kept);
      if (may_trace_again()) return;
    }
  }

  /// Adds a point to the facet where the first edge in `left` that can be split pierces it; takes the edge from `left`.
  bool split_one(std::vector<Piercing>& left) {
    for (std::size_t i = 0; i < left.size(); ++i) {
      const PiercingEdge e = left[i].edge;
      const VertexIndex x =
          recovery_.has_exact_points ? step_onto_plane(recovery_, plane_, e.below, e.above) : split_rounded(e);
      if (x == no_vertex) continue;
      Constraints& constraints = recovery_.constraints;
      constraints.vertices.resize(mesh_.points().size());
      constraints.vertices[x] = {VertexOrigin::on_facet, constraints.subfacets[subfacet_].facet};
      recovery_.count_added_point();
      sides_.add_member(x);
      is_plain_ = false;
      has_been_split_ = true;
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
    return false;
  }
  VertexIndex split_rounded(const PiercingEdge& e) {
    EdgeRing ring;
    if (!mesh_.ring(mesh_.find_edge(e.below, e.above, e.cell), e.below, e.above, ring)) return no_vertex;
    const VertexIndex x = mesh_.add_point(piercing_point(e));
    if (insert_in_star(mesh_, recovery_.constraints, x, ring.cells)) return x;
    mesh_.drop_last_point();
    return no_vertex;
  }

  void commit(const FacetTrace& trace) {
    Constraints& constraints = recovery_.constraints;
    const Index facet = constraints.subfacets[subfacet_].facet;
    if (!is_plain_) {
      // Rounding may have folded facets that meet at a tiny angle onto each other: a mesh face then belongs to both.
      for (const Triangle& t : trace.faces)
        if (constraints.subfacet_of(t[0], t[1], t[2]) != no_index)
          return recovery_.end(error_of_facet_not_recovered(recovery_, subfacet_));
      for (std::size_t i = 0; i < trace.faces.size(); ++i)
        constraints.subfacets[constraints.add_subfacet(trace.faces[i], facet)].seen_in = trace.cells[i];
      constraints.remove_subfacet(subfacet_);
    }
    for (std::size_t i = 0; i < trace.faces.size(); ++i) {
      const Triangle& t = trace.faces[i];
      mesh_.lock(mesh_.face_in_cell(trace.cells[i], t[0], t[1], t[2]));
    }
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Index subfacet_;
  Triangle plane_;
  std::vector<DirectedEdge> border_;
  FacetSides sides_;
  bool is_plain_ = true;         ///< whether the facet is a triangle to which no point has been added
  bool has_been_split_ = false;  ///< whether recovery has added a point to the facet
  std::size_t n_traced_ = 0;     ///< number of mesh faces and piercing edges found by all searches for the facet
  std::size_t work_left_ = 0;    ///< number of edges and faces that flips for the facet may still try to remove
};

}  // namespace

namespace {

/// Returns whether all vertices of the subfacet are in the mesh. Some may be inserted later (hard_parts_first.hpp).
bool has_all_vertices(const Recovery& recovery, Index subfacet) {
  const auto in_mesh = [&](VertexIndex v) { return recovery.mesh.in_mesh(v); };
  const Constraints& c = recovery.constraints;
  if (c.is_piece(subfacet))
    return std::all_of(c.piece_of(subfacet).members.begin(), c.piece_of(subfacet).members.end(), in_mesh);
  return std::all_of(c.subfacets[subfacet].vertices.begin(), c.subfacets[subfacet].vertices.end(), in_mesh);
}

/// Returns whether all border edges of a piece of a facet are in the mesh. At a missing edge, the search for its faces
/// would leave the facet and follow its plane through the whole mesh.
bool has_all_edges(Recovery& recovery, Index piece) {
  Constraints& c = recovery.constraints;
  const std::vector<DirectedEdge>& border = c.piece_of(piece).border;
  return std::all_of(border.begin(), border.end(), [&](const DirectedEdge& e) {
    return cell_of_subsegment(recovery.mesh, c, c.subsegment_of(e[0], e[1])) != no_cell;
  });
}

bool is_present(Recovery& recovery, Index subfacet) {
  if (recovery.constraints.is_piece(subfacet))
    return has_all_edges(recovery, subfacet) &&
           trace_piece(recovery.mesh, recovery.constraints, subfacet).status == FacetTrace::Status::complete;
  return face_of_subfacet(recovery.mesh, recovery.constraints, subfacet).valid();
}

}  // namespace

MissingSubfacets count_missing_subfacets(Recovery& recovery) {
  MissingSubfacets out;
  const Constraints& c = recovery.constraints;
  for (Index f = 0; f < c.subfacets.size(); ++f) {
    if (!c.subfacets[f].live || is_present(recovery, f)) continue;
    ++out.n;
    if (c.is_piece(f)) out.inner_edges += c.piece_of(f).border.size() - 3;
  }
  return out;
}

void recover_facets(Recovery& recovery) {
  Constraints& constraints = recovery.constraints;
  std::vector<Index> missing;
  const Index n_subfacets = static_cast<Index>(constraints.subfacets.size());
  for (Index f = 0; f < n_subfacets; ++f) {
    if (!constraints.subfacets[f].live || !has_all_vertices(recovery, f)) continue;
    if (constraints.is_piece(f)) {
      if (!FacetRecovery(recovery, f).as_it_is()) missing.push_back(f);
      if (recovery.has_ended()) return;
      continue;
    }
    const FaceRef face = face_of_subfacet(recovery.mesh, constraints, f);
    if (face.valid()) {
      recovery.mesh.lock(face);
    } else {
      missing.push_back(f);
    }
  }
  recovery.statistics.missing_facets_initial = std::max(recovery.statistics.missing_facets_initial, missing.size());
  recovery.statistics.facets_reinserted += missing.size();
  for (unsigned depth = 0; depth <= recovery_budget.facet_depth; ++depth) {
    recovery.context.check_cancelled();
    std::size_t n_tried = 0;
    const std::size_t n_missing = missing.size();
    std::erase_if(missing, [&](Index f) {
      if (n_tried++ % 64 == 0) recovery.context.report(n_tried, n_missing);
      return !recovery.has_ended() && (FacetRecovery(recovery, f).by_flips(depth) ||
                                       (depth > 0 && !recovery.has_ended() &&
                                        FacetRecovery(recovery, f).by_cavity(recovery_budget.filling_nodes * depth)));
    });
  }
  if (recovery.has_ended()) return;
  for (Index f : missing) recovery.hard_facets.push_back(constraints.subfacets[f].facet);
  for (Index f : missing) {
    recovery.context.check_cancelled();
    FacetRecovery(recovery, f).by_points();
    if (recovery.has_ended()) return;
  }
}

}  // namespace geomesh::recover

// SPDX-License-Identifier: MIT
/// Facets, whose segments are all present: the mesh edges that pierce a missing subfacet are removed by flips; where that fails they are
/// split one after the other where they pierce it. Splits of edges leave tetrahedra alone, so the prisms and pyramids of the paper's
/// section 3.3 never come up, and after as many splits as edges pierce the subfacet it is a union of faces: this always ends.
#include <algorithm>
#include <cmath>

#include "recover/facet_trace.hpp"
#include "recover/messages.hpp"
#include "recover/recover.hpp"
#include "recover/star_insertion.hpp"

namespace geomesh::recover {

namespace {

/// Forbids edges whose ends lie on different sides of the subfacet: inside the ring of a piercing edge such an edge pierces it too.
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
        sides_(mesh_, recovery.constraints.subfacets[subfacet].vertices, members_) {}

  bool by_flips(unsigned depth) {
    EdgeRemover remover(mesh_, recovery_.constraints);
    const NoNewPiercing rule(sides_);
    FacetTrace trace = checked_trace();
    while (trace.status == FacetTrace::Status::pierced) {
      bool progress = false;
      for (const PiercingEdge& e : trace.piercing)
        if (mesh_.find_edge(e.below, e.above) != no_cell && remover.remove(e.below, e.above, depth, &rule)) progress = true;
      if (!progress) return false;
      trace = checked_trace();
    }
    if (trace.status != FacetTrace::Status::complete) return false;
    commit(trace);
    return true;
  }

  void by_points() {
    for (unsigned depth = 2; !by_flips(depth); depth = 1) {
      const FacetTrace trace = checked_trace();
      if (trace.status == FacetTrace::Status::unclear || !split_one(trace)) fail_facet_not_recovered(recovery_, subfacet_);
    }
  }

 private:
  FacetTrace checked_trace() {
    const FacetTrace trace = trace_facet(mesh_, sides_);
    if (trace.status == FacetTrace::Status::touched) fail_vertex_on_facet(recovery_, trace.culprit, subfacet_);
    for (const PiercingEdge& e : trace.piercing) {
      const Index s = recovery_.constraints.subsegment_of(e.below, e.above);
      if (s != no_index) fail_segment_pierces_facet(recovery_, s, subfacet_);
    }
    return trace;
  }

  Vec3 piercing_point(const PiercingEdge& e) const {
    const Triangle& t = sides_.triangle();
    const Vec3 &p = mesh_.point(t[0]), &a = mesh_.point(e.below), &b = mesh_.point(e.above);
    const Vec3 n = cross(mesh_.point(t[1]) - p, mesh_.point(t[2]) - p);
    const double da = dot(n, a - p), db = dot(n, b - p);
    const double s = da == db ? 0.5 : std::clamp(da / (da - db), 0.0, 1.0);
    return s <= 0.5 ? a + s * (b - a) : b + (1 - s) * (a - b);
  }

  /// Splits the piercing edge nearest to its middle, so that the new cells are as thick as can be; else any.
  bool split_one(const FacetTrace& trace) {
    Constraints& constraints = recovery_.constraints;
    EdgeRing ring;
    for (const PiercingEdge& e : trace.piercing) {
      const CellIndex cell = mesh_.find_edge(e.below, e.above);
      if (!mesh_.ring(cell, e.below, e.above, ring)) continue;
      const VertexIndex x = mesh_.add_point(piercing_point(e));
      if (insert_in_star(mesh_, constraints, x, ring.cells)) {
        constraints.vertices.resize(mesh_.points().size());
        constraints.vertices[x] = {VertexOrigin::on_facet, constraints.subfacets[subfacet_].facet};
        members_.push_back(x);
        return true;
      }
      mesh_.drop_last_point();
    }
    return false;
  }

  void commit(const FacetTrace& trace) {
    Constraints& constraints = recovery_.constraints;
    const Index facet = constraints.subfacets[subfacet_].facet;
    if (!members_.empty()) {
      for (const Triangle& t : trace.faces) constraints.add_subfacet(t, facet);
      constraints.remove_subfacet(subfacet_);
    }
    for (const Triangle& t : trace.faces) mesh_.lock(mesh_.find_face(t[0], t[1], t[2]));
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Index subfacet_;
  std::vector<VertexIndex> members_;
  FacetSides sides_;
};

}  // namespace

std::size_t count_missing_subfacets(Recovery& recovery) {
  std::size_t n = 0;
  for (const Subfacet& f : recovery.constraints.subfacets)
    if (f.live && !recovery.mesh.find_face(f.vertices[0], f.vertices[1], f.vertices[2]).valid()) ++n;
  return n;
}

void recover_facets(Recovery& recovery) {
  Constraints& constraints = recovery.constraints;
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<Index> missing;
  for (Index f = 0; f < constraints.subfacets.size(); ++f) {
    if (!constraints.subfacets[f].live) continue;
    const Triangle& t = constraints.subfacets[f].vertices;
    const FaceRef face = mesh.find_face(t[0], t[1], t[2]);
    if (face.valid()) {
      mesh.lock(face);
    } else {
      missing.push_back(f);
    }
  }
  recovery.statistics.missing_facets_initial = missing.size();
  recovery.statistics.facets_reinserted += missing.size();
  for (unsigned depth : {0u, 1u, 2u, 3u}) {
    recovery.context.check_cancelled();
    std::erase_if(missing, [&](Index f) { return FacetRecovery(recovery, f).by_flips(depth); });
  }
  for (Index f : missing) {
    recovery.context.check_cancelled();
    FacetRecovery(recovery, f).by_points();
  }
}

}  // namespace geomesh::recover

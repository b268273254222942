// SPDX-License-Identifier: MIT
#include "recover/facet_trace.hpp"

#include <algorithm>
#include <set>

namespace geomesh::recover {

int FacetSides::operator()(VertexIndex v) const {
  if (is_member(v)) return 0;
  return static_cast<int>(mesh_.orient(t_[0], t_[1], t_[2], v));
}

bool FacetSides::is_member(VertexIndex v) const {
  return v == t_[0] || v == t_[1] || v == t_[2] || std::find(members_.begin(), members_.end(), v) != members_.end();
}

namespace {

class Tracer {
 public:
  Tracer(ConstrainedMesh& mesh, const FacetSides& sides) : mesh_(mesh), sides_(sides) {}

  FacetTrace run() {
    const Triangle& t = sides_.triangle();
    for (unsigned i = 0; i < 3; ++i) front_.push_back({t[i], t[(i + 1) % 3]});
    while (!front_.empty() && out_.status != FacetTrace::Status::touched) {
      const auto [p, q] = front_.back();
      front_.pop_back();
      advance(p, q);
    }
    if (out_.status == FacetTrace::Status::complete && !out_.piercing.empty()) out_.status = FacetTrace::Status::pierced;
    return std::move(out_);
  }

 private:
  using DirectedEdge = std::array<VertexIndex, 2>;

  void fail(FacetTrace::Status status, VertexIndex culprit = no_vertex) {
    if (out_.status == FacetTrace::Status::touched) return;
    out_.status = status;
    out_.culprit = culprit;
  }

  /// What lies to the left of p->q, seen from above: a face of the facet, or a cell that the facet cuts.
  void advance(VertexIndex p, VertexIndex q) {
    if (done_.count({p, q})) return;
    done_.insert({p, q});
    const CellIndex cell = mesh_.find_edge(p, q);
    if (cell == no_cell || !mesh_.ring(cell, p, q, ring_)) return fail(FacetTrace::Status::unclear);
    const std::size_t n = ring_.ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const VertexIndex u = ring_.ring[i], w = ring_.ring[(i + 1) % n], before = ring_.ring[(i + n - 1) % n];
      // Seen along p->q the ring turns counter-clockwise, so it passes the facet on the left from below to above.
      if (sides_.is_member(u) && sides_(before) < 0 && sides_(w) > 0) return accept(p, q, u);
      if (sides_(u) < 0 && sides_(w) > 0) return pierce(ring_.cells[i], u, w);
    }
    // A vertex in the plane that is no member: it lies in the facet, for an edge of the mesh would cross the border else.
    for (std::size_t i = 0; i < n; ++i) {
      const VertexIndex u = ring_.ring[i];
      if (!sides_.is_member(u) && sides_(u) == 0 && sides_(ring_.ring[(i + n - 1) % n]) < 0 && sides_(ring_.ring[(i + 1) % n]) > 0)
        return fail(FacetTrace::Status::touched, u);
    }
    fail(FacetTrace::Status::unclear);
  }

  void accept(VertexIndex p, VertexIndex q, VertexIndex v) {
    out_.faces.push_back({p, q, v});
    done_.insert({q, v});
    done_.insert({v, p});
    for (const DirectedEdge e : {DirectedEdge{v, q}, DirectedEdge{p, v}})
      if (!done_.count(e) && !is_border(e[1], e[0])) front_.push_back(e);
  }
  bool is_border(VertexIndex a, VertexIndex b) const {
    const Triangle& t = sides_.triangle();
    for (unsigned i = 0; i < 3; ++i)
      if (t[i] == a && t[(i + 1) % 3] == b) return true;
    return false;
  }

  void pierce(CellIndex cell, VertexIndex below, VertexIndex above) {
    std::vector<PiercingEdge> queue;
    add(below, above, queue);
    (void)cell;
    EdgeRing ring;
    for (std::size_t head = 0; head < queue.size() && out_.status != FacetTrace::Status::touched; ++head) {
      const CellIndex c = mesh_.find_edge(queue[head].below, queue[head].above);
      if (c == no_cell || !mesh_.ring(c, queue[head].below, queue[head].above, ring)) return fail(FacetTrace::Status::unclear);
      for (std::size_t i = 0; i < ring.ring.size(); ++i) {
        const VertexIndex u = ring.ring[i], w = ring.ring[(i + 1) % ring.ring.size()];
        const int side = sides_(u);
        if (side == 0 && !sides_.is_member(u)) return fail(FacetTrace::Status::touched, u);
        add_if_pierces(u, side, queue[head], queue);
        const int next = sides_(w);
        if (side < 0 && next > 0) add(u, w, queue);
        if (side > 0 && next < 0) add(w, u, queue);
      }
    }
  }
  void add_if_pierces(VertexIndex u, int side, PiercingEdge e, std::vector<PiercingEdge>& queue) {
    if (side > 0) add(e.below, u, queue);
    if (side < 0) add(u, e.above, queue);
  }
  void add(VertexIndex below, VertexIndex above, std::vector<PiercingEdge>& queue) {
    if (!seen_.insert({below, above}).second) return;
    queue.push_back({below, above});
    out_.piercing.push_back({below, above});
  }

  ConstrainedMesh& mesh_;
  const FacetSides& sides_;
  FacetTrace out_;
  std::vector<DirectedEdge> front_;
  std::set<DirectedEdge> done_;
  std::set<PiercingEdge> seen_;
  EdgeRing ring_;
};

}  // namespace

FacetTrace trace_facet(ConstrainedMesh& mesh, const FacetSides& sides) { return Tracer(mesh, sides).run(); }

}  // namespace geomesh::recover

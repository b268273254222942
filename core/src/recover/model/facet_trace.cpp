// SPDX-License-Identifier: MIT
#include "recover/model/facet_trace.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::recover {

namespace {

/// Records why the search for a facet's faces has ended. A vertex found in the facet first is not overwritten.
void fail(FacetTrace& out, FacetTrace::Status status, VertexIndex culprit = no_vertex) {
  if (out.status == FacetTrace::Status::touched) return;
  out.status = status;
  out.culprit = culprit;
}

/// Returns whether the faces cover the subfacet once: each directed edge of a face is on the subfacet's border or
/// cancels with its reverse, and none occurs twice.
bool covers_once(const std::vector<Triangle>& faces, const std::vector<DirectedEdge>& border_list,
                 const DirectedEdgeSet& border) {
  DirectedEdgeSet edges;
  for (const Triangle& t : faces)
    for (unsigned i = 0; i < 3; ++i)
      if (!edges.insert({t[i], t[(i + 1) % 3]})) return false;
  for (const DirectedEdge& e : border_list)
    if (!edges.contains(e)) return false;
  for (const Triangle& t : faces)
    for (unsigned i = 0; i < 3; ++i)
      if (!border.contains({t[i], t[(i + 1) % 3]}) && !edges.contains({t[(i + 1) % 3], t[i]})) return false;
  return true;
}

/// Finds the edges that pierce a facet, from one piercing edge to the next through the cells around them.
class PiercingSearch {
 public:
  PiercingSearch(ConstrainedMesh& mesh, const FacetSides& sides, FacetTrace& out)
      : mesh_(mesh), sides_(sides), out_(out) {}

  /// Records a mesh edge that pierces the facet, and all other such edges that are connected with it through cells.
  void follow(VertexIndex below, VertexIndex above, CellIndex cell) {
    std::vector<PiercingEdge> queue;
    add({below, above, cell}, queue);
    EdgeRing ring;
    for (std::size_t head = 0; head < queue.size() && out_.status != FacetTrace::Status::touched; ++head) {
      const CellIndex c = mesh_.find_edge(queue[head].below, queue[head].above, queue[head].cell);
      if (c == no_cell || !mesh_.ring(c, queue[head].below, queue[head].above, ring))
        return fail(out_, FacetTrace::Status::unclear);
      for (std::size_t i = 0; i < ring.ring.size(); ++i) {
        const VertexIndex u = ring.ring[i], w = ring.ring[(i + 1) % ring.ring.size()];
        const int side = sides_(u);
        if (side == 0 && !sides_.is_member(u)) return fail(out_, FacetTrace::Status::touched, u);
        const CellIndex with_both = ring.cells[i];
        if (side > 0) add({queue[head].below, u, with_both}, queue);
        if (side < 0) add({u, queue[head].above, with_both}, queue);
        const int next = sides_(w);
        if (side < 0 && next > 0) add({u, w, with_both}, queue);
        if (side > 0 && next < 0) add({w, u, with_both}, queue);
      }
    }
  }

 private:
  void add(const PiercingEdge& e, std::vector<PiercingEdge>& queue) {
    if (!seen_.insert({e.below, e.above})) return;
    queue.push_back(e);
    out_.piercing.push_back(e);
  }

  ConstrainedMesh& mesh_;
  const FacetSides& sides_;
  FacetTrace& out_;
  DirectedEdgeSet seen_;  ///< from below
};

/// Searches the ring of vertices around a facet's edge p->q for where the facet continues on the edge's left: at a
/// vertex or an edge of the ring. Functions return a row in the ring, or the ring's size if there is none.
class LeftOfEdge {
 public:
  LeftOfEdge(const ConstrainedMesh& mesh, const FacetSides& sides, const EdgeRing& ring, DirectedEdge edge,
             VertexIndex right)
      : mesh_(mesh), sides_(sides), ring_(ring.ring), edge_(edge), right_(right) {}

  /// Finds the vertex of the ring whose face with the edge belongs to the facet and lies clearly to the left of the
  /// edge. If several consecutive faces do, because the cells between them are flat up to rounding, the first one is
  /// returned, so that these cells count as above the facet. Exact signs do not help here, because rounding bends the
  /// faces around an added point.
  std::size_t clear_member() const {
    constexpr double clearly_left = 0.5;
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i < n; ++i)
      if (may_follow(ring_[i]) && !may_follow(ring_[(i + n - 1) % n]) && leftness(mesh_.point(ring_[i])) > clearly_left)
        return i;
    return n;
  }
  /// Finds the edge of the ring that pierces the facet. Seen along p->q the ring turns once, counter-clockwise, so an
  /// edge of it that passes from below to above does so on the left. If rounding bends the faces around an added point,
  /// several edges may do so; the one that is most clearly on the left is used.
  std::size_t crossing_edge() const {
    const std::size_t n = ring_.size();
    std::size_t best = n;
    double best_score = -2;
    for (std::size_t i = 0; i < n; ++i) {
      const VertexIndex u = ring_[i], w = ring_[(i + 1) % n];
      if (sides_(u) >= 0 || sides_(w) <= 0) continue;
      const double score = leftness(in_plane(u, w));
      if (score <= best_score) continue;
      best_score = score;
      best = i;
    }
    return best;
  }
  /// Finds a vertex of the facet in the ring around p-q that lies on the line p-q up to rounding. Its triangle with p
  /// and q is a part of the facet without width.
  std::size_t thin_member() const {
    const std::size_t n = ring_.size();
    std::size_t thin = n;
    for (std::size_t i = 0; i < n; ++i)
      if (may_follow(ring_[i]) && (thin == n || leftness(mesh_.point(ring_[i])) > leftness(mesh_.point(ring_[thin]))))
        thin = i;
    return thin;
  }
  /// Finds a vertex in the plane that is not a member of the facet. It lies in the facet, because otherwise an edge of
  /// the mesh would cross the border of the facet.
  std::size_t touched() const {
    const std::size_t n = ring_.size();
    for (std::size_t i = 0; i < n; ++i)
      if (!sides_.is_member(ring_[i]) && sides_(ring_[i]) == 0 && sides_(ring_[(i + n - 1) % n]) < 0 &&
          sides_(ring_[(i + 1) % n]) > 0)
        return i;
    return n;
  }

 private:
  bool may_follow(VertexIndex u) const { return u != right_ && sides_.is_member(u); }
  /// Returns the cosine of the angle, around edge p-q, between the facet on the left of the edge and the point v.
  double leftness(const Vec3& v) const {
    const Vec3 &p = mesh_.point(edge_[0]), &q = mesh_.point(edge_[1]);
    const Vec3 normal = sides_.normal(), turn = cross(q - p, v - p);
    const double length = std::sqrt(dot(normal, normal) * dot(turn, turn));
    return length > 0 ? dot(normal, turn) / length : -1;
  }
  /// Returns the point at which the edge u-v of the mesh crosses the facet's plane.
  Vec3 in_plane(VertexIndex u, VertexIndex v) const {
    const Vec3 normal = sides_.normal(), &a = mesh_.point(u), &b = mesh_.point(v);
    const double ha = dot(normal, a - sides_.origin()), hb = dot(normal, b - sides_.origin());
    return ha == hb ? b : b + hb / (hb - ha) * (a - b);
  }

  const ConstrainedMesh& mesh_;
  const FacetSides& sides_;
  const std::vector<VertexIndex>& ring_;
  DirectedEdge edge_;
  VertexIndex right_;
};

/// Finds the mesh faces of a facet from its border inwards, edge by edge.
class Tracer {
 public:
  Tracer(ConstrainedMesh& mesh, const FacetSides& sides, const std::vector<DirectedEdge>& border)
      : mesh_(mesh), sides_(sides), border_list_(border), piercing_(mesh, sides, out_) {
    for (const DirectedEdge& e : border) {
      front_.push_back({e, no_cell, no_vertex});
      border_.insert(e);
    }
  }

  FacetTrace run() {
    while (!front_.empty() && out_.status != FacetTrace::Status::touched) {
      const FrontEdge next = front_.back();
      front_.pop_back();
      advance(next.edge[0], next.edge[1], next.right, next.cell);
    }
    if (out_.status == FacetTrace::Status::complete && !out_.piercing.empty())
      out_.status = FacetTrace::Status::pierced;
    if (out_.status == FacetTrace::Status::complete && !covers_once(out_.faces, border_list_, border_))
      out_.status = FacetTrace::Status::unclear;
    return std::move(out_);
  }

 private:
  /// A directed edge in the facet whose left side has not been searched yet, a cell that has the edge (no_cell if
  /// unknown), and the corner of the mesh face on its right (no_vertex if the edge is on the facet's border).
  struct FrontEdge {
    DirectedEdge edge;
    CellIndex cell;
    VertexIndex right;
  };

  /// Follows the facet across its edge p->q to the left, as seen from above: into a mesh face in the facet, or into a
  /// cell that the facet cuts. The third corner `right` of the face on the right is never accepted.
  void advance(VertexIndex p, VertexIndex q, VertexIndex right, CellIndex hint) {
    if (!done_.insert({p, q})) return;
    const CellIndex cell = mesh_.find_edge(p, q, hint);
    if (cell == no_cell || !mesh_.ring(cell, p, q, ring_)) return fail(out_, FacetTrace::Status::unclear);
    const std::size_t n = ring_.ring.size();
    if (sides_.is_exact()) return advance_exactly(p, q, right);
    const LeftOfEdge left(mesh_, sides_, ring_, {p, q}, right);
    if (const std::size_t i = left.clear_member(); i < n) return accept(p, q, i);
    if (const std::size_t i = left.crossing_edge(); i < n)
      return piercing_.follow(ring_.ring[i], ring_.ring[(i + 1) % n], ring_.cells[i]);
    if (const std::size_t i = left.thin_member(); i < n) return accept(p, q, i);
    if (const std::size_t i = left.touched(); i < n) return fail(out_, FacetTrace::Status::touched, ring_.ring[i]);
    fail(out_, FacetTrace::Status::unclear);
  }

  /// Follows the facet across its edge p->q to the left with exact signs, by which exactly one vertex or edge of the
  /// ring around p-q lies there in the facet's plane.
  void advance_exactly(VertexIndex p, VertexIndex q, VertexIndex right) {
    const std::size_t n = ring_.ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const VertexIndex u = ring_.ring[i], w = ring_.ring[(i + 1) % n];
      if (sides_.is_member(u) && u != right && sides_.is_left(p, q, u)) return accept(p, q, i);
      if (sides_(u) < 0 && sides_(w) > 0) return piercing_.follow(u, w, ring_.cells[i]);
      if (!sides_.is_member(u) && sides_(u) == 0 && sides_.is_left(p, q, u))
        return fail(out_, FacetTrace::Status::touched, u);
    }
    fail(out_, FacetTrace::Status::unclear);
  }

  /// Adds a mesh face to the faces that make up the facet: that of p, q and vertex i of the ring around edge p-q.
  void accept(VertexIndex p, VertexIndex q, std::size_t i) {
    const VertexIndex v = ring_.ring[i];
    const CellIndex cell = ring_.cells[i];
    out_.faces.push_back({p, q, v});
    out_.cells.push_back(cell);
    done_.insert({q, v});
    done_.insert({v, p});
    for (const FrontEdge& next : {FrontEdge{{v, q}, cell, p}, FrontEdge{{p, v}, cell, q}})
      if (!done_.contains(next.edge) && !border_.contains({next.edge[1], next.edge[0]})) front_.push_back(next);
  }

  ConstrainedMesh& mesh_;
  const FacetSides& sides_;
  FacetTrace out_;
  std::vector<FrontEdge> front_;
  const std::vector<DirectedEdge>& border_list_;
  DirectedEdgeSet border_, done_;
  PiercingSearch piercing_;
  EdgeRing ring_;
};

}  // namespace

FacetTrace trace_facet(ConstrainedMesh& mesh, const FacetSides& sides, const std::vector<DirectedEdge>& border) {
  return Tracer(mesh, sides, border).run();
}

}  // namespace geomesh::recover

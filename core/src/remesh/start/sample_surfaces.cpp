// SPDX-License-Identifier: MIT
#include "remesh/start/sample_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "plc/facet_triangulation.hpp"
#include "remesh/start/flip_slivers.hpp"
#include "remesh/start/mesh_anew.hpp"
#include "remesh/start/planar_sampler.hpp"

namespace geomesh::remesh {

namespace {

using Edge = std::array<VertexIndex, 2>;

/// A coordinate system in a facet's plane. If the plane is normal to an axis, the other two axes are used, so that
/// rounding cannot move points off the plane.
struct PlaneFrame {
  Vec3 origin, u, v;
  Vec2 flat(const Vec3& p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
  Vec3 lifted(const Vec2& p) const { return origin + p.x * u + p.y * v; }
};

std::optional<PlaneFrame> frame_of(const PiecewiseLinearComplex& plc, std::span<const VertexIndex> loop) {
  const Vec3 &o = plc.points[loop[0]], n = loop_normal(plc.points, loop);
  const double l = length(n);
  if (!(l > 0)) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (n[(axis + 1) % 3] == 0 && n[(axis + 2) % 3] == 0) {
      PlaneFrame f{o, {}, {}};
      f.u[(axis + 1) % 3] = 1;
      f.v[(axis + 2) % 3] = n[axis] > 0 ? 1 : -1;
      return f;
    }
  // A short edge may deviate from the best plane by much of its length, so only its component in the plane is used.
  const Vec3 unit = (1 / l) * n, along = plc.points[loop[1]] - o, flat = along - dot(along, unit) * unit,
             u = (1 / length(flat)) * flat;
  return PlaneFrame{o, u, cross(unit, u)};
}

class SurfaceSampler {
 public:
  SurfaceSampler(const MergedFacets& merged, const ConstrainedTetrahedralization& mesh, const SizeField& size,
                 const WholeParts& whole)
      : plc_(merged.plc),
        size_(size),
        whole_(whole),
        is_whole_(merged.plc.n_facets(), false),
        beside_(merged.plc.n_facets(), {no_index, no_index}) {
    for (const Index f : whole.facets) is_whole_[merged.row_of_facet[f]] = true;
    for (const auto& f : mesh.faces) {
      std::array<Index, 2>& beside = beside_[merged.row_of_facet[f.facet]];
      if (f.tetrahedron_below != no_index) beside[0] = mesh.component[f.tetrahedron_below];
      if (f.tetrahedron_above != no_index) beside[1] = mesh.component[f.tetrahedron_above];
    }
  }

  SampledComplex run(const RunContext& context) {
    collect_edges();
    PiecewiseLinearComplex& out = out_.plc;
    out = without_facets(plc_);
    out.segments.clear();
    for (auto& [edge, parts] : edges_) cut(edge, parts);
    for (const auto& s : plc_.facet_segments)
      for_each_piece(s.a, s.b, [&](VertexIndex a, VertexIndex b) { out.facet_segments.push_back({s.facet, a, b}); });
    for (Index s = 0; s < plc_.segments.size(); ++s)
      for_each_piece(plc_.segments[s].a, plc_.segments[s].b, [&](VertexIndex a, VertexIndex b) {
        out.segments.push_back({a, b, plc_.segments[s].curve});
        out_.segment.push_back(s);
      });
    out.facet_points = plc_.facet_points;
    index_inner_parts();
    sample_facets(context);
    return std::move(out_);
  }

 private:
  /// An edge of facets, or a segment: the facets at it, and the new points on it, ordered from the lower vertex on.
  struct EdgeParts {
    std::vector<Index> facets;
    std::vector<VertexIndex> points;
  };

  void collect_edges() {
    for_each_side(plc_, [&](Index f, VertexIndex a, VertexIndex b) { edges_[sorted(Edge{a, b})].facets.push_back(f); });
    for (const auto& s : plc_.facet_segments) edges_[sorted(Edge{s.a, s.b})].facets.push_back(s.facet);
    for (const auto& s : plc_.segments) edges_[sorted(Edge{s.a, s.b})];
  }

  double size_at(const Vec3& p, std::span<const Index> facets) const {
    double h = size_.at(p);
    if (!size_.limits().component_size.empty())
      for (const Index f : facets)
        for (const Index c : beside_[f])
          if (c != no_index) h = std::min(h, size_.at(p, c));
    return h;
  }

  double size_beside(const Vec3& p, const Vec3& q, double size_at_q, std::span<const Index> facets) const {
    return size_.limits().component_size.empty() ? size_.at_beside(p, no_index, q, size_at_q) : size_at(p, facets);
  }

  /// Returns the target size at an original point or one on an edge; stored if sizes do not depend on the facet.
  double size_at_vertex(VertexIndex v, std::span<const Index> facets) {
    const std::vector<Vec3>& points = out_.plc.points;
    if (!size_.limits().component_size.empty()) return size_at(points[v], facets);
    if (vertex_size_.size() <= v) vertex_size_.resize(points.size() + points.size() / 4, -1);
    if (vertex_size_[v] < 0) vertex_size_[v] = size_.at(points[v]);
    return vertex_size_[v];
  }

  /// Divides the edge into pieces with equal integrals of 1 / size.
  void cut(const Edge& edge, EdgeParts& parts) {
    if (whole_.edges.contains(edge)) return;
    // An edge shorter than this many times the smaller target size at its ends is not divided, whatever the sizes along
    // it: an edge becomes two pieces only from 1.5 times the size on.
    constexpr double surely_one = 1.2;
    const Vec3 a = plc_.points[edge[0]], d = plc_.points[edge[1]] - a;
    const double l = length(d);
    if (l < surely_one * std::min(size_at_vertex(edge[0], parts.facets), size_at_vertex(edge[1], parts.facets))) return;
    std::vector<std::array<double, 2>> passed{{0, 0}};  // parameter, integral
    while (passed.back()[0] < 1) {
      const auto [t, sum] = passed.back();
      const double h = size_at(a + t * d, parts.facets), next = std::min(1.0, t + 0.25 * h / l);
      passed.push_back({next, sum + (next - t) * l / h});
    }
    const auto n = static_cast<std::size_t>(std::max(1.0, std::round(passed.back()[1])));
    std::size_t at = 1;
    for (std::size_t k = 1; k < n; ++k) {
      const double wanted = passed.back()[1] * static_cast<double>(k) / static_cast<double>(n);
      while (passed[at][1] < wanted) ++at;
      const auto &p = passed[at - 1], &q = passed[at];
      const double t = p[0] + (q[0] - p[0]) * (wanted - p[1]) / (q[1] - p[1]);
      parts.points.push_back(static_cast<VertexIndex>(out_.plc.points.size()));
      out_.plc.points.push_back(a + t * d);
      out_.edge_of_point.push_back(edge);
    }
  }

  template <class Visit>
  void for_each_piece(VertexIndex a, VertexIndex b, Visit visit) const {
    std::vector<VertexIndex> chain = edges_.at(sorted(Edge{a, b})).points;
    if (a > b) std::reverse(chain.begin(), chain.end());
    chain.push_back(b);
    VertexIndex last = a;
    for (const VertexIndex v : chain) {
      visit(last, v);
      last = v;
    }
  }

  /// Lists, for each facet, the pieces of its inner segments and its inner points.
  void index_inner_parts() {
    inner_segments_.resize(plc_.n_facets());
    inner_points_.resize(plc_.n_facets());
    for (const auto& s : out_.plc.facet_segments) inner_segments_[s.facet].push_back({s.a, s.b});
    for (const auto& p : plc_.facet_points) inner_points_[p.facet].push_back(p.v);
  }

  /// The sampled points of a facet: its loops, including points on its edges, and places inside.
  struct FacetSample {
    std::vector<std::vector<VertexIndex>> loops;
    std::vector<Vec3> inside;
  };

  /// Samples facets in parallel. The points on edges and their sizes must have been computed before.
  void sample_facets(const RunContext& context) {
    constexpr std::size_t batch = 4096, chunk = 64;
    // If sizes are given by a function of the caller, it is evaluated on one thread only.
    const unsigned threads = size_.limits().background ? 1 : thread_count(context.threads);
    if (size_.limits().component_size.empty()) {
      vertex_size_.resize(out_.plc.points.size(), -1);
      for_each_index(vertex_size_.size(), threads,
                     [&](std::size_t v) { size_at_vertex(static_cast<VertexIndex>(v), {}); });
    }
    std::vector<FacetSample> samples;
    for (std::size_t first = 0; first < plc_.n_facets(); first += batch) {
      context.check_cancelled();
      samples.assign(std::min(batch, plc_.n_facets() - first), {});
      for_each_task((samples.size() + chunk - 1) / chunk, threads, [&](std::size_t k) {
        for (std::size_t i = k * chunk; i < std::min(samples.size(), (k + 1) * chunk); ++i)
          samples[i] = sample_facet(static_cast<Index>(first + i));
      });
      for (std::size_t i = 0; i < samples.size(); ++i) append(static_cast<Index>(first + i), samples[i]);
    }
  }

  void append(Index f, const FacetSample& sample) {
    out_.plc.add_polygon(sample.loops, plc_.facet_provenance[f]);
    for (const Vec3& p : sample.inside) {
      out_.plc.facet_points.push_back({f, static_cast<VertexIndex>(out_.plc.points.size())});
      out_.plc.points.push_back(p);
    }
  }

  FacetSample sample_facet(Index f) {
    FacetSample sample;
    std::vector<std::vector<VertexIndex>>& loops = sample.loops;
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
      const auto loop = plc_.loop(l);
      std::vector<VertexIndex>& fine = loops.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i)
        for_each_piece(loop[i], loop[(i + 1) % loop.size()], [&](VertexIndex a, VertexIndex) { fine.push_back(a); });
    }
    if (is_whole_[f] || is_full(f, loops)) return sample;
    const auto frame = frame_of(plc_, plc_.outer_loop(f));
    if (!frame) return sample;
    const std::array<Index, 1> facet{f};
    const auto place = [&](VertexIndex v) {
      return PlanarSampler::Place{frame->flat(out_.plc.points[v]), size_at_vertex(v, facet)};
    };
    std::vector<std::vector<PlanarSampler::Place>> flat;
    for (const auto& loop : loops) {
      auto& ring = flat.emplace_back();
      for (const VertexIndex v : loop) ring.push_back(place(v));
      const bool is_hole = flat.size() > 1;
      if (is_hole == turns_left(ring)) std::reverse(ring.begin(), ring.end());
    }
    PlanarSampler sampler(flat, [&](const Vec2& p, const PlanarSampler::Place& beside) {
      return size_beside(frame->lifted(p), frame->lifted(beside.at), beside.size, facet);
    });
    for (const auto& [a, b] : inner_segments_[f]) sampler.block(place(a), place(b));
    for (const VertexIndex v : inner_points_[f]) sampler.block(place(v));
    for (const Vec2& p : sampler.run()) sample.inside.push_back(frame->lifted(p));
    return sample;
  }

  /// Returns whether a triangle needs no inner points: no points were added on its sides, and no place in it is far
  /// enough from its corners. The farthest place from the corners is at most 1 / sqrt 3 of the longest side away.
  bool is_full(Index f, const std::vector<std::vector<VertexIndex>>& loops) {
    if (loops.size() > 1 || loops[0].size() != 3) return false;
    const std::array<Index, 1> facet{f};
    const std::vector<VertexIndex>& t = loops[0];
    const std::vector<Vec3>& p = out_.plc.points;
    if (std::any_of(t.begin(), t.end(), [&](VertexIndex v) { return v >= plc_.points.size(); })) return false;
    double longest = 0, least = size_at((1.0 / 3) * (p[t[0]] + p[t[1]] + p[t[2]]), facet);
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, squared_distance(p[t[k]], p[t[(k + 1) % 3]]));
      least = std::min(least, size_at_vertex(t[k], facet));
    }
    const double free = PlanarSampler::spacing_ratio * least;
    return longest / 3 < free * free;
  }

  static bool turns_left(const std::vector<PlanarSampler::Place>& ring) {
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i].at, &b = ring[(i + 1) % ring.size()].at;
      area += a.x * b.y - a.y * b.x;
    }
    return area > 0;
  }

  const PiecewiseLinearComplex& plc_;
  const SizeField& size_;
  const WholeParts& whole_;
  std::vector<bool> is_whole_;                // by facet
  std::vector<std::array<Index, 2>> beside_;  // for each facet, the components below and above it
  std::map<Edge, EdgeParts> edges_;
  std::vector<std::vector<Edge>> inner_segments_;
  std::vector<std::vector<VertexIndex>> inner_points_;
  std::vector<double> vertex_size_;  // target size at each vertex; negative if not yet evaluated
  SampledComplex out_;
};

std::vector<std::vector<Edge>> segments_by_facet(const PiecewiseLinearComplex& plc) {
  std::vector<std::vector<Edge>> segments(plc.n_facets());
  for (const auto& s : plc.facet_segments) segments[s.facet].push_back({s.a, s.b});
  return segments;
}

/// Returns whether the facet is so thin that rounding may change it.
bool is_thin(const PiecewiseLinearComplex& plc, Index f) {
  constexpr double least_width = 1e-6;  // twice the area of a facet over its squared longest edge
  const auto loop = plc.outer_loop(f);
  double longest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    longest = std::max(longest, squared_distance(plc.points[loop[i]], plc.points[loop[(i + 1) % loop.size()]]));
  return length(loop_normal(plc.points, loop)) < least_width * longest;
}

/// Returns the facets whose edges may intersect after points on them have been rounded: thin ones, and those that are
/// more than a triangle (with several loops, more corners or inner segments).
std::vector<Index> delicate_facets(const PiecewiseLinearComplex& plc) {
  const std::vector<std::vector<Edge>> segments = segments_by_facet(plc);
  std::vector<Index> delicate;
  for (Index f = 0; f < plc.n_facets(); ++f)
    if (plc.n_loops(f) > 1 || plc.outer_loop(f).size() > 3 || !segments[f].empty() || is_thin(plc, f))
      delicate.push_back(f);
  return delicate;
}

/// Returns whether edges of the facet, with the new points, intersect or pass through each other's points.
bool is_spoilt(const PiecewiseLinearComplex& plc, Index f, const std::vector<Edge>& segments) {
  FacetPolygon polygon{{}, segments, {}};
  for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l)
    polygon.loops.emplace_back(plc.loop(l).begin(), plc.loop(l).end());
  if (polygon.loops.size() == 1 && polygon.loops[0].size() == 3 && segments.empty()) return false;
  FacetFault fault;
  return !triangulate_facet(plc.points, polygon, fault);
}

void add_edges_of(const PiecewiseLinearComplex& plc, Index f, std::set<Edge>& edges) {
  for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
    const auto loop = plc.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) edges.insert(sorted(Edge{loop[i], loop[(i + 1) % loop.size()]}));
  }
  for (const auto& s : plc.facet_segments)
    if (s.facet == f) edges.insert(sorted(Edge{s.a, s.b}));
}

/// Restores the numbers that points, facets and segments have in the original complex.
ConstrainedTetrahedralization renumbered(ConstrainedTetrahedralization fresh, const MergedFacets& merged,
                                         const SampledComplex& sampled) {
  const std::size_t n_points = merged.plc.points.size();
  std::vector<Index> first(merged.plc.n_facets(), no_index);  // first original facet of each merged facet
  for (Index f = 0; f < merged.row_of_facet.size(); ++f)
    first[merged.row_of_facet[f]] = std::min(first[merged.row_of_facet[f]], f);
  for (auto& f : fresh.faces) f.facet = first[f.facet];
  std::vector<bool> on_facet(sampled.plc.points.size(), false);
  for (const auto& p : sampled.plc.facet_points) on_facet[p.v] = true;
  for (std::size_t v = 0; v < fresh.points.size(); ++v) {
    VertexIndex& row = fresh.input_vertex[v];
    if (row == no_vertex || row < n_points) continue;
    fresh.origin[v] = on_facet[row] ? VertexOrigin::on_facet : VertexOrigin::on_segment;
    row = no_vertex;
  }
  for (auto& e : fresh.edges) e.segment = sampled.segment[e.segment];
  return fresh;
}

}  // namespace

SampledComplex sample_surfaces(MergedFacets& merged, const ConstrainedTetrahedralization& mesh, const SizeField& size,
                               Slivers slivers, const RunContext& context, WholeParts whole) {
  std::set<Index> flipped;  // Each facet is flipped only once, since a second flip might undo the first.
  for (;;) {
    SampledComplex sampled = SurfaceSampler(merged, mesh, size, whole).run(context);
    const std::vector<std::vector<Edge>> segments = segments_by_facet(sampled.plc);
    std::vector<Index> to_flip, to_keep;
    for (const Index f : delicate_facets(merged.plc))
      if (is_spoilt(sampled.plc, f, segments[f]))
        (slivers == Slivers::may_go && flipped.insert(f).second ? to_flip : to_keep).push_back(f);
    const std::size_t n_tried = to_flip.size(), n_whole = whole.size();
    if (n_tried > 0) to_flip = flip_slivers(merged.plc, to_flip);
    for (const std::vector<Index>* stay : {&to_flip, &to_keep})
      for (const Index f : *stay) add_edges_of(merged.plc, f, whole.edges);
    if (to_flip.size() == n_tried && whole.size() == n_whole) return sampled;
  }
}

std::optional<ConstrainedTetrahedralization> mesh_sampled(const MergedFacets& merged,
                                                          const ConstrainedTetrahedralization& mesh,
                                                          const SampledComplex& sampled, const RunContext& context,
                                                          ErrorContext* trouble) {
  auto fresh = tetrahedralize_as(mesh, merged.row_of_facet, sampled.plc, context, trouble);
  if (!fresh) return std::nullopt;
  return renumbered(std::move(*fresh), merged, sampled);
}

bool keep_whole(const MergedFacets& merged, const SampledComplex& sampled, const ErrorContext& trouble,
                WholeParts& whole) {
  const std::size_t before = whole.size(), n_given = merged.plc.points.size();
  std::vector<bool> in_trouble(merged.plc.n_facets(), false);
  for (const Index f : trouble.facets) {
    in_trouble[f] = true;
    add_edges_of(merged.plc, f, whole.edges);
  }
  const std::set<VertexIndex> vertices(trouble.vertices.begin(), trouble.vertices.end());
  for (const VertexIndex v : vertices)
    if (v >= n_given && v - n_given < sampled.edge_of_point.size())
      whole.edges.insert(sampled.edge_of_point[v - n_given]);
  for (const auto& inside : sampled.plc.facet_points)
    if (inside.v >= n_given && vertices.contains(inside.v)) in_trouble[inside.facet] = true;
  for (Index f = 0; f < merged.row_of_facet.size(); ++f)
    if (in_trouble[merged.row_of_facet[f]]) whole.facets.insert(f);
  return whole.size() > before;
}

}  // namespace geomesh::remesh

// SPDX-License-Identifier: MIT
#include "recover/model/declare.hpp"

#include <algorithm>
#include <cstdio>

#include "common/sort_unique.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh::recover {

namespace {

class Declarer {
 public:
  Declarer(const PiecewiseLinearComplex& plc, const ModelNames& names, const RunContext& context)
      : plc_(plc), names_(names), context_(context) {}

  DeclaredModel run() {
    out_.n_facets = plc_.n_facets();
    number_vertices();
    out_.constraints.reserve(2 * plc_.n_facets() + plc_.segments.size(), 2 * plc_.n_facets());
    out_.constraints.vertices.assign(out_.input_vertex.size(), {});
    declare_segments();
    for (Index f = 0; f < plc_.n_facets(); ++f) declare_borders(f);
    gather_inner_items();
    for (Index f = 0; f < plc_.n_facets(); ++f) declare_facet(f);
    if (n_bent_ > 0) {
      char text[160];
      std::snprintf(text, sizeof text,
                    "%zu facets are not exactly planar and are meshed as triangles (largest deviation %.3g)", n_bent_,
                    deviation_);
      context_.note(LogLevel::info, text);
    }
    return std::move(out_);
  }

 private:
  void number_vertices() {
    std::vector<std::uint8_t> used(plc_.points.size(), 0);
    for (VertexIndex v : plc_.loop_vertices) used[v] = 1;
    for (const auto& s : plc_.facet_segments) used[s.a] = used[s.b] = 1;
    for (const auto& p : plc_.facet_points) used[p.v] = 1;
    for (const auto& s : plc_.segments) used[s.a] = used[s.b] = 1;
    for (VertexIndex v : plc_.isolated_points) used[v] = 1;
    local_.assign(plc_.points.size(), no_vertex);
    for (VertexIndex v = 0; v < plc_.points.size(); ++v) {
      if (!used[v]) continue;
      local_[v] = static_cast<VertexIndex>(out_.input_vertex.size());
      out_.input_vertex.push_back(v);
    }
    for (VertexIndex v : plc_.isolated_points) out_.isolated_points.push_back(local_[v]);
  }

  Index declare_segment(VertexIndex a, VertexIndex b, Index row) {
    Constraints& c = out_.constraints;
    const Index existing = c.subsegment_of(a, b);
    if (existing != no_index) return c.subsegments[existing].segment;
    const Index segment = static_cast<Index>(c.segments.size());
    c.segments.push_back({a, b, row});
    c.add_subsegment(a, b, segment, no_index);
    return segment;
  }
  void declare_segments() {
    for (Index row = 0; row < plc_.segments.size(); ++row)
      out_.segment_of_row.push_back(declare_segment(local_[plc_.segments[row].a], local_[plc_.segments[row].b], row));
  }
  void declare_borders(Index f) {
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
      const auto loop = plc_.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        declare_segment(local_[loop[i]], local_[loop[(i + 1) % loop.size()]], no_index);
    }
  }
  void gather_inner_items() {
    inner_.resize(plc_.facet_segments.empty() && plc_.facet_points.empty() ? 0 : plc_.n_facets());
    for (const auto& s : plc_.facet_segments) {
      declare_segment(local_[s.a], local_[s.b], no_index);
      inner_[s.facet].segments.push_back({s.a, s.b});
    }
    for (const auto& p : plc_.facet_points) inner_[p.facet].inner_points.push_back(p.v);
  }

  void declare_facet(Index f) {
    const bool plain = inner_.empty() || (inner_[f].segments.empty() && inner_[f].inner_points.empty());
    const auto outer = plc_.outer_loop(f);
    if (plain && plc_.n_loops(f) == 1 && outer.size() == 3) {
      add_triangle({outer[0], outer[1], outer[2]}, f);
      return;
    }
    FacetPolygon polygon = inner_.empty() ? FacetPolygon{} : inner_[f];
    for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l)
      polygon.loops.emplace_back(plc_.loop(l).begin(), plc_.loop(l).end());
    FacetFault fault;
    const auto triangulation = triangulate_facet(plc_.points, polygon, fault);
    if (!triangulation) fail(f, fault);
    if (triangulation->exactly_planar) {
      add_piece(*triangulation, polygon, f);
      return;
    }
    ++n_bent_;
    deviation_ = std::max(deviation_, triangulation->deviation);
    for (const Triangle& t : triangulation->triangles) add_triangle(t, f);
  }
  void add_triangle(const Triangle& t, Index f) {
    const Triangle v{local_[t[0]], local_[t[1]], local_[t[2]]};
    const Index other = out_.constraints.subfacet_of(v[0], v[1], v[2]);
    if (other != no_index) {
      const Index below = out_.constraints.subfacets[other].facet;
      fail(f, {"it overlaps facet " + std::to_string(names_.facet[below]), {t[0], t[1], t[2]}}, below);
    }
    out_.constraints.add_subfacet(v, f);
  }
  /// Takes the border of a polygonal facet from its own triangulation: the directed edges of triangles that are
  /// segments. The orientation of the loops therefore does not matter.
  void add_piece(const FacetTriangulation& draft, const FacetPolygon& polygon, Index f) {
    FacetPiece piece;
    for (const Triangle& t : draft.triangles)
      for (unsigned i = 0; i < 3; ++i) {
        const VertexIndex a = local_[t[i]], b = local_[t[(i + 1) % 3]];
        if (out_.constraints.is_subsegment(a, b)) piece.border.push_back({a, b});
      }
    for (const auto& loop : polygon.loops)
      for (VertexIndex v : loop) piece.members.push_back(local_[v]);
    for (const auto& s : polygon.segments)
      for (VertexIndex v : s) piece.members.push_back(local_[v]);
    for (VertexIndex v : polygon.inner_points) piece.members.push_back(local_[v]);
    sort_unique(piece.members);
    const Triangle& t = draft.triangles.front();
    out_.constraints.add_piece({local_[t[0]], local_[t[1]], local_[t[2]]}, std::move(piece), f);
  }
  /// Throws the error of an invalid facet. `other` is a second facet that takes part in the fault, or no_index.
  [[noreturn]] void fail(Index f, const FacetFault& fault, Index other = no_index) const {
    ErrorContext context;
    context.facets = {f};
    if (other != no_index) context.facets.push_back(other);
    context.vertices = fault.vertices;
    for (VertexIndex v : fault.vertices) context.places.push_back(plc_.points[v]);
    throw Error(ErrorKind::invalid_input,
                "facet " + std::to_string(names_.facet[f]) + " is not valid: " + fault.message, std::move(context));
  }

  const PiecewiseLinearComplex& plc_;
  const ModelNames& names_;
  const RunContext& context_;
  DeclaredModel out_;
  std::vector<VertexIndex> local_;
  std::vector<FacetPolygon> inner_;
  std::size_t n_bent_ = 0;
  double deviation_ = 0;
};

}  // namespace

DeclaredModel declare_constraints(const PiecewiseLinearComplex& plc, const ModelNames& names,
                                  const RunContext& context) {
  return Declarer(plc, names, context).run();
}

}  // namespace geomesh::recover

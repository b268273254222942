// SPDX-License-Identifier: MIT
#include "recover/model/messages.hpp"

#include <algorithm>
#include <cstdio>

#include "common/sort_unique.hpp"
#include "recover/model/excerpt.hpp"

namespace geomesh::recover {

namespace {

std::string coordinates(const Recovery& recovery, const Vec3& place) {
  const Vec3 p = recovery.names.frame.leave(place);
  char text[100];
  std::snprintf(text, sizeof text, "(%.17g, %.17g, %.17g)", p.x, p.y, p.z);
  return text;
}

std::string list(const Recovery& recovery, std::vector<Index> facets) {
  for (Index& f : facets) f = recovery.names.facet[f];
  std::sort(facets.begin(), facets.end());
  std::string out = facets.size() == 1 ? "facet " : "facets ";
  for (std::size_t i = 0; i < facets.size() && i < 8; ++i) out += (i ? ", " : "") + std::to_string(facets[i]);
  return out;
}

/// Returns the kind of error for a contradiction among these vertices. If all are from the input, the input is invalid;
/// if one was added, rounding of added vertices has caused it.
ErrorKind kind_for(const Recovery& recovery, std::initializer_list<VertexIndex> vertices) {
  return all_input(recovery, vertices) ? ErrorKind::invalid_input : ErrorKind::cannot_mesh;
}

const char* advice(ErrorKind kind) {
  return kind == ErrorKind::invalid_input
             ? "; facets and segments may meet only in shared vertices and edges: intersect the surfaces first"
             : "; the geometry there is too thin for double precision: move or merge what nearly touches";
}

ErrorContext context_of(const Recovery& recovery, std::vector<Index> facets,
                        std::initializer_list<VertexIndex> vertices) {
  ErrorContext out;
  out.facets = std::move(facets);
  for (VertexIndex v : vertices) {
    out.places.push_back(recovery.mesh.point(v));
    if (v < recovery.input_vertex.size() && recovery.input_vertex[v] != no_vertex)
      out.vertices.push_back(recovery.input_vertex[v]);
  }
  out.excerpt = excerpt_about(recovery, std::vector<VertexIndex>(vertices));
  return out;
}

std::vector<Index> join(std::vector<Index> a, const std::vector<Index>& b) {
  a.insert(a.end(), b.begin(), b.end());
  sort_unique(a);
  return a;
}

}  // namespace

bool all_input(const Recovery& recovery, std::initializer_list<VertexIndex> vertices) {
  return std::all_of(vertices.begin(), vertices.end(), [&](VertexIndex v) { return v < recovery.mesh.n_input(); });
}

std::string describe_vertex(const Recovery& recovery, VertexIndex v) {
  const VertexIndex row = v < recovery.input_vertex.size() ? recovery.input_vertex[v] : no_vertex;
  return (row != no_vertex ? "vertex " + std::to_string(recovery.names.vertex[row]) : "an added vertex") + " at " +
         coordinates(recovery, recovery.mesh.point(v));
}

std::string describe_edge(const Recovery& recovery, VertexIndex a, VertexIndex b) {
  return "from " + describe_vertex(recovery, a) + " to " + describe_vertex(recovery, b);
}

std::string describe_subfacet(const Recovery& recovery, Index subfacet) {
  const Subfacet& f = recovery.constraints.subfacets[subfacet];
  return "facet " + std::to_string(recovery.names.facet[f.facet]) + " (" + describe_vertex(recovery, f.vertices[0]) +
         ", " + describe_vertex(recovery, f.vertices[1]) + ", " + describe_vertex(recovery, f.vertices[2]) + ")";
}

std::vector<Index> facets_of_subsegment(const Recovery& recovery, Index subsegment) {
  std::vector<Index> out;
  for (Index f : recovery.constraints.subsegments[subsegment].subfacets)
    out.push_back(recovery.constraints.subfacets[f].facet);
  return join(std::move(out), {});
}

Error error_of_vertex_on_segment(const Recovery& recovery, VertexIndex v, Index subsegment) {
  const Subsegment& s = recovery.constraints.subsegments[subsegment];
  const ErrorKind kind = kind_for(recovery, {v, s.a, s.b});
  const std::vector<Index> facets = facets_of_subsegment(recovery, subsegment);
  return Error(kind,
               describe_vertex(recovery, v) + " lies on the segment " + describe_edge(recovery, s.a, s.b) +
                   (facets.empty() ? "" : " of " + list(recovery, facets)) + " without being declared part of it" +
                   advice(kind),
               context_of(recovery, facets, {v, s.a, s.b}));
}

Error error_of_segments_cross(const Recovery& recovery, Index si, Index ti) {
  const Subsegment& s = recovery.constraints.subsegments[si];
  const Subsegment& t = recovery.constraints.subsegments[ti];
  const ErrorKind kind = kind_for(recovery, {s.a, s.b, t.a, t.b});
  const std::vector<Index> facets = join(facets_of_subsegment(recovery, si), facets_of_subsegment(recovery, ti));
  return Error(kind,
               "the segments " + describe_edge(recovery, s.a, s.b) + " and " + describe_edge(recovery, t.a, t.b) +
                   " cross" + (facets.empty() ? "" : " (" + list(recovery, facets) + ")") + advice(kind),
               context_of(recovery, facets, {s.a, s.b, t.a, t.b}));
}

Error error_of_vertex_on_facet(const Recovery& recovery, VertexIndex v, Index subfacet) {
  const Subfacet& f = recovery.constraints.subfacets[subfacet];
  const ErrorKind kind = kind_for(recovery, {v, f.vertices[0], f.vertices[1], f.vertices[2]});
  return Error(kind,
               describe_vertex(recovery, v) + " lies inside " + describe_subfacet(recovery, subfacet) +
                   " without being declared part of it" + advice(kind),
               context_of(recovery, {f.facet}, {v, f.vertices[0], f.vertices[1], f.vertices[2]}));
}

Error error_of_segment_pierces_facet(const Recovery& recovery, Index subsegment, Index subfacet) {
  const Subfacet& f = recovery.constraints.subfacets[subfacet];
  const Subsegment& s = recovery.constraints.subsegments[subsegment];
  const ErrorKind kind = kind_for(recovery, {s.a, s.b, f.vertices[0], f.vertices[1], f.vertices[2]});
  const std::vector<Index> facets = facets_of_subsegment(recovery, subsegment);
  return Error(kind,
               "the segment " + describe_edge(recovery, s.a, s.b) +
                   (facets.empty() ? "" : " of " + list(recovery, facets)) + " pierces " +
                   describe_subfacet(recovery, subfacet) + advice(kind),
               context_of(recovery, join({f.facet}, facets), {s.a, s.b, f.vertices[0], f.vertices[1], f.vertices[2]}));
}

Error error_of_segment_not_recovered(const Recovery& recovery, Index subsegment) {
  const Subsegment& s = recovery.constraints.subsegments[subsegment];
  const std::vector<Index> facets = facets_of_subsegment(recovery, subsegment);
  return Error(ErrorKind::cannot_mesh,
               "the segment " + describe_edge(recovery, s.a, s.b) +
                   (facets.empty() ? "" : " of " + list(recovery, facets)) +
                   " cannot be recovered: no double near it makes positive cells" + advice(ErrorKind::cannot_mesh),
               context_of(recovery, facets, {s.a, s.b}));
}

Error error_of_facet_not_recovered(const Recovery& recovery, Index subfacet) {
  const Subfacet& f = recovery.constraints.subfacets[subfacet];
  return Error(ErrorKind::cannot_mesh,
               describe_subfacet(recovery, subfacet) + " cannot be recovered: no double near it makes positive cells" +
                   advice(ErrorKind::cannot_mesh),
               context_of(recovery, {f.facet}, {f.vertices[0], f.vertices[1], f.vertices[2]}));
}

namespace {

/// Returns the facet on which a vertex lies, or else the facets with segments or faces in its star.
std::vector<Index> facets_about(const Recovery& recovery, VertexIndex x) {
  const VertexRecord& record = recovery.constraints.vertices[x];
  if (record.origin == VertexOrigin::on_facet) return {record.owner};
  std::vector<Index> out;
  std::vector<CellIndex> star;
  recovery.mesh.star(x, star);
  for (const CellIndex c : star) {
    const Tetrahedron& v = recovery.mesh.cells().vertices(c);
    for (const auto& face : face_vertices)
      if (const Index f = recovery.constraints.subfacet_of(v[face[0]], v[face[1]], v[face[2]]); f != no_index)
        out.push_back(recovery.constraints.subfacets[f].facet);
    for (const auto& e : edge_vertices)
      if (const Index s = recovery.constraints.subsegment_of(v[e[0]], v[e[1]]); s != no_index)
        out = join(std::move(out), facets_of_subsegment(recovery, s));
  }
  return join(std::move(out), {});
}

}  // namespace

Error error_of_rounding(const Recovery& recovery, const std::vector<VertexIndex>& points) {
  const VertexIndex x = points.front();
  std::vector<Index> facets = facets_about(recovery, x);
  const std::string where = facets.empty() ? "" : " at " + list(recovery, facets);
  const std::string at = describe_vertex(recovery, x) + where;
  const std::string what = points.size() == 1 ? "no double near " + at + " leaves all cells positive"
                                              : "no doubles near " + std::to_string(points.size()) +
                                                    " added vertices leave all cells positive, the first " + at;
  return Error(ErrorKind::cannot_mesh, what + advice(ErrorKind::cannot_mesh),
               context_of(recovery, std::move(facets), {x}));
}

void Recovery::count_added_point() {
  const double expected =
      recovery_budget.doubtful_points + expected_points_per_vertex * static_cast<double>(input_vertex.size());
  if (++n_points_added != static_cast<std::size_t>(expected)) return;
  if (std::optional<Error> crossing = describe_crossing()) end(std::move(*crossing));
}

bool Recovery::has_crossings() const { return crossings.first().has_value(); }

std::optional<Error> Recovery::describe_crossing() const {
  const auto& crossing = crossings.first();
  if (!crossing) return std::nullopt;
  ErrorContext where;
  where.facets.push_back(crossing->facet);
  if (crossing->edge_facet != no_index) where.facets.push_back(crossing->edge_facet);
  where.vertices = {crossing->a, crossing->b};
  where.places = {plc.points[crossing->a], plc.points[crossing->b]};
  const auto local = [&](VertexIndex row) {
    return static_cast<VertexIndex>(std::lower_bound(input_vertex.begin(), input_vertex.end(), row) -
                                    input_vertex.begin());
  };
  where.excerpt = excerpt_about(*this, std::vector{local(crossing->a), local(crossing->b)});
  const std::string owner =
      crossing->edge_facet == no_index ? "" : " of facet " + std::to_string(names.facet[crossing->edge_facet]);
  return Error(ErrorKind::invalid_input,
               "the edge from vertex " + std::to_string(names.vertex[crossing->a]) + " to vertex " +
                   std::to_string(names.vertex[crossing->b]) + owner + " at " +
                   coordinates(*this, plc.points[crossing->a]) + " meets facet " +
                   std::to_string(names.facet[crossing->facet]) + " outside shared vertices and edges" +
                   advice(ErrorKind::invalid_input),
               std::move(where));
}

}  // namespace geomesh::recover

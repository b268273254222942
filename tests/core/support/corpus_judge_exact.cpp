// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Mpzf;
using ExactVec = std::array<Exact, 3>;

Kernel::Point_3 cgal(const Vec3& p) { return {p.x, p.y, p.z}; }

ExactVec exact(const Vec3& p) { return {Exact(p.x), Exact(p.y), Exact(p.z)}; }
ExactVec difference(const ExactVec& a, const ExactVec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact dot(const ExactVec& a, const ExactVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ExactVec cross(const ExactVec& a, const ExactVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(exact(a), exact(b)), exact(c)); }
double approximate(const Exact& x) { return x.to_double(); }

/// Six times the volume under the facet's loops as given, seen from the origin; exact for exactly planar facets.
Exact determinant_of_facet(const PiecewiseLinearComplex& plc, Index facet) {
  Exact sum(0);
  Vec3 outer_normal;
  for (Index l = plc.facet_loops[facet]; l < plc.facet_loops[facet + 1]; ++l) {
    const auto loop = plc.loop(l);
    Exact of_loop(0);
    Vec3 normal;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vec3 &a = plc.points[loop[0]], &b = plc.points[loop[i]], &c = plc.points[loop[i + 1]];
      of_loop = of_loop + determinant(a, b, c);
      normal = normal + geomesh::cross(b - a, c - a);
    }
    if (l == plc.facet_loops[facet]) outer_normal = normal;
    const bool reverse = l != plc.facet_loops[facet] && geomesh::dot(normal, outer_normal) > 0;
    sum = reverse ? sum - of_loop : sum + of_loop;
  }
  return sum;
}

/// Per component what the three ways of measuring it need.
struct Measured {
  Exact cells{0}, faces{0}, facets{0};
  double area = 0;
  bool has_added_boundary_points = false;
  bool comparable_with_facets = true;
};

Vec3 normal_of_triangle(const PiecewiseLinearComplex& plc, Index f) {
  const auto loop = plc.outer_loop(f);
  return geomesh::cross(plc.points[loop[1]] - plc.points[loop[0]], plc.points[loop[2]] - plc.points[loop[0]]);
}

/// Coplanar triangles that no face names, since faces spread over several of them, have on their sides what their
/// neighbours have.
void give_sides(const PiecewiseLinearComplex& plc, const std::vector<Index>& group, std::vector<std::uint8_t>& seen,
                std::vector<std::array<Index, 2>>& sides) {
  const auto named = std::find_if(group.begin(), group.end(), [&](Index f) { return seen[f] != 0; });
  if (named == group.end()) return;
  for (const Index f : group) {
    if (seen[f]) continue;
    const bool turned = geomesh::dot(normal_of_triangle(plc, f), normal_of_triangle(plc, *named)) < 0;
    seen[f] = 1;
    sides[f] = turned ? std::array<Index, 2>{sides[*named][1], sides[*named][0]} : sides[*named];
  }
}

void measure_faces(const Judgement& j, std::vector<Measured>& components) {
  constexpr Index mixed = no_index - 1;
  std::vector<std::array<Index, 2>> sides(j.plc.n_facets(), {mixed, mixed});
  std::vector<std::uint8_t> seen(j.plc.n_facets(), 0), is_mixed(j.plc.n_facets(), 0);
  for (const auto& f : j.mesh.faces) {
    const Exact volume = determinant(j.point(f.vertices[0]), j.point(f.vertices[1]), j.point(f.vertices[2]));
    const Vec3 n = geomesh::cross(j.point(f.vertices[1]) - j.point(f.vertices[0]),
                                  j.point(f.vertices[2]) - j.point(f.vertices[0]));
    std::array<Index, 2> side;
    for (int above = 0; above < 2; ++above) {
      const Index cell = above ? f.tetrahedron_above : f.tetrahedron_below;
      side[above] = cell == no_index ? no_index : j.mesh.component[cell];
      if (side[above] == no_index) continue;
      Measured& m = components[side[above]];
      m.faces = above ? m.faces - volume : m.faces + volume;
      m.area += std::sqrt(geomesh::dot(n, n)) / 2;
      for (VertexIndex v : f.vertices) m.has_added_boundary_points |= j.is_added(v);
    }
    if (seen[f.facet] && sides[f.facet] != side) is_mixed[f.facet] = 1;
    seen[f.facet] = 1;
    sides[f.facet] = side;
    if (is_mixed[f.facet])
      for (Index c : side)
        if (c != no_index) components[c].comparable_with_facets = false;
  }
  for (const std::vector<Index>& group : coplanar_groups(j.plc)) give_sides(j.plc, group, seen, sides);
  for (Index f = 0; f < j.plc.n_facets(); ++f) {
    if (!seen[f]) continue;
    const bool usable = !is_mixed[f] && is_exactly_planar(j.plc, f);
    const Exact volume = usable ? determinant_of_facet(j.plc, f) : Exact(0);
    for (int above = 0; above < 2; ++above) {
      if (sides[f][above] == no_index) continue;
      Measured& m = components[sides[f][above]];
      if (!usable) m.comparable_with_facets = false;
      m.facets = above ? m.facets - volume : m.facets + volume;
    }
  }
}

}  // namespace

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return static_cast<int>(CGAL::orientation(cgal(a), cgal(b), cgal(c), cgal(d)));
}

bool exactly_inside_sphere(const std::array<Vec3, 4>& t, const Vec3& p) {
  return CGAL::side_of_oriented_sphere(cgal(t[0]), cgal(t[1]), cgal(t[2]), cgal(t[3]), cgal(p)) ==
         CGAL::ON_POSITIVE_SIDE;
}

double distance_from_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const ExactVec u = difference(exact(b), exact(a)), n = cross(u, difference(exact(p), exact(a)));
  return std::sqrt(approximate(dot(n, n))) / std::sqrt(approximate(dot(u, u)));
}

double distance_from_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const ExactVec n = cross(difference(exact(b), exact(a)), difference(exact(c), exact(a)));
  return std::fabs(approximate(dot(n, difference(exact(p), exact(a))))) / std::sqrt(approximate(dot(n, n)));
}

double parameter_on_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const ExactVec u = difference(exact(b), exact(a));
  return approximate(dot(u, difference(exact(p), exact(a)))) / approximate(dot(u, u));
}

std::array<VertexIndex, 3> plane_corners(const PiecewiseLinearComplex& plc, Index facet) {
  const auto loop = plc.outer_loop(facet);
  std::array<VertexIndex, 3> best{loop[0], loop[1], loop[2]};
  double largest = -1;
  for (std::size_t i = 1; i < loop.size(); ++i)
    for (std::size_t k : {i + 1, (i + loop.size() / 2) % loop.size()}) {
      if (k >= loop.size() || k == i) continue;
      const Vec3 n =
          geomesh::cross(plc.points[loop[i]] - plc.points[loop[0]], plc.points[loop[k]] - plc.points[loop[0]]);
      if (geomesh::dot(n, n) > largest) {
        largest = geomesh::dot(n, n);
        best = {loop[0], loop[i], loop[k]};
      }
    }
  return best;
}

bool is_exactly_planar(const PiecewiseLinearComplex& plc, Index facet) {
  const auto corner = plane_corners(plc, facet);
  for (Index l = plc.facet_loops[facet]; l < plc.facet_loops[facet + 1]; ++l)
    for (VertexIndex v : plc.loop(l))
      if (exact_orientation(plc.points[corner[0]], plc.points[corner[1]], plc.points[corner[2]], plc.points[v]) != 0)
        return false;
  return true;
}

void judge_volumes(Judgement& j) {
  std::vector<Measured> components(j.mesh.n_components);
  for (Index c = 0; c < j.mesh.tetrahedra.size(); ++c) {
    if (j.mesh.component[c] >= components.size()) return;  // told by judge_components
    const Tetrahedron& t = j.mesh.tetrahedra[c];
    const ExactVec o = exact(j.point(t[0]));
    const auto edge = [&](int i) { return difference(exact(j.point(t[i])), o); };
    Measured& m = components[j.mesh.component[c]];
    m.cells = m.cells + dot(cross(edge(1), edge(2)), edge(3));
  }
  measure_faces(j, components);
  for (Index c = 0; c < components.size(); ++c) {
    const Measured& m = components[c];
    const std::string name = "component " + std::to_string(c);
    if (!(m.cells == m.faces)) j.fault("volume", name + ": cells and boundary faces disagree");
    if (!m.comparable_with_facets) continue;
    const double off = std::fabs(approximate(m.cells - m.facets)) / 6, volume = approximate(m.cells) / 6;
    const double allowed = m.has_added_boundary_points ? 2 * j.ulp * m.area + 1e-12 * volume : 0;
    if (off > allowed)
      j.fault("volume", name + ": " + std::to_string(volume) + " is off the input facets' by " +
                            std::to_string(off / volume) + " of itself");
  }
}

}  // namespace geomesh::test

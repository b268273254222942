// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "arrangement/model/separation.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

int to_int(Sign s) { return static_cast<int>(s); }

/// Returns the sign of d against a facet's plane, by a static filter or, if that fails, by the exact predicate.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) { return to_int(orient3d(a, b, c, d)); }

struct FacetView {
  const Complex& complex;
  Index id;
  const Triangle& v;
  FacetView(const Complex& all, Index facet) : complex(all), id(facet), v(all.facets[facet]) {}
  const Vec3& p(std::size_t i) const { return complex.points[v[i]]; }
  int corner(VertexIndex x) const { return x == v[0] ? 0 : x == v[1] ? 1 : x == v[2] ? 2 : -1; }
};

Projection projection_of(const FacetView& f) { return arrangement::projection_of(f.p(0), f.p(1), f.p(2)); }

/// Returns whether a point of the facet's plane is in the closed facet.
bool plane_point_in_facet(const FacetView& f, const Vec3& q) {
  const Projection frame = projection_of(f);
  const Vec2 x = project(q, frame);
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(project(f.p(i), frame), project(f.p((i + 1) % 3), frame), x) * frame.sign == Sign::negative)
      return false;
  return true;
}

/// Returns whether the line through p and q, which crosses the facet's plane, meets the closed facet.
bool line_meets_facet(const FacetView& f, const Vec3& p, const Vec3& q) {
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int s = side(p, q, f.p(i), f.p((i + 1) % 3));
    positive |= s > 0;
    negative |= s < 0;
    if (positive && negative) return false;
  }
  return true;
}

class Ends {
 public:
  void add(const Symbol& s) {
    for (std::size_t i = 0; i < n_; ++i)
      if (items_[i] == s) return;
    GEOMESH_CHECK(n_ < items_.size());
    items_[n_++] = s;
  }
  std::size_t size() const { return n_; }
  const Symbol& operator[](std::size_t i) const { return items_[i]; }

 private:
  std::array<Symbol, 8> items_;
  std::size_t n_ = 0;
};

/// Adds the ends of the intersection of the facet `cut` with the plane of the facet `plane`, if they lie in that closed
/// facet. `signs` are those of the corners of `cut` against the plane.
void add_ends(const FacetView& plane, const FacetView& cut, const std::array<int, 3>& signs, Ends& ends) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (signs[i] == 0 && (plane.corner(cut.v[i]) >= 0 || plane_point_in_facet(plane, cut.p(i))))
      ends.add(Symbol::point(cut.v[i]));
    const std::size_t j = (i + 1) % 3;
    if (signs[i] * signs[j] < 0 && line_meets_facet(plane, cut.p(i), cut.p(j)))
      ends.add(Symbol::line_plane(cut.v[i], cut.v[j], plane.id));
  }
}

/// Returns whether a contact lies only at corners and along edges of the facet, so that it does not split the facet.
bool is_own_border(const FacetView& f, const Ends& ends) {
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (!ends[i].is_point() || f.corner(ends[i].a) < 0) return false;
  return true;
}

void emit(const FacetView& f, Index other, Line line, const Ends& ends, Contacts& out) {
  if (ends.size() == 0 || is_own_border(f, ends)) return;
  GEOMESH_CHECK(ends.size() <= 4);
  FacetContact contact;
  contact.facet = f.id;
  contact.other = other;
  contact.line = line;
  contact.n_ends = static_cast<std::uint8_t>(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) contact.ends[i] = ends[i];
  out.facets.push_back(contact);
}

void emit_point(const FacetView& f, Index other, VertexIndex v, Contacts& out) {
  Ends ends;
  ends.add(Symbol::point(v));
  emit(f, other, Line::plane(other), ends, out);
}

/// Returns whether an edge of `a` has all of the coplanar facet `b` on its outer side or on its line.
bool separated_by_edge(const FacetView& a, const FacetView& b, const Projection& frame, Sign sign) {
  for (std::size_t i = 0; i < 3; ++i) {
    bool outside = true;
    for (std::size_t k = 0; k < 3 && outside; ++k)
      outside = orient2d(project(a.p(i), frame), project(a.p((i + 1) % 3), frame), project(b.p(k), frame)) * sign !=
                Sign::positive;
    if (outside) return true;
  }
  return false;
}

void coplanar_contact(const FacetView& a, const FacetView& b, Contacts& out) {
  const Projection frame = projection_of(a);
  const Sign sign_b = orient2d(project(b.p(0), frame), project(b.p(1), frame), project(b.p(2), frame));
  if (!separated_by_edge(a, b, frame, frame.sign) && !separated_by_edge(b, a, frame, sign_b)) {
    out.overlaps.push_back({std::min(a.id, b.id), std::max(a.id, b.id)});
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.corner(b.v[k]) < 0 && plane_point_in_facet(a, b.p(k))) emit_point(a, b.id, b.v[k], out);
    if (b.corner(a.v[k]) < 0 && plane_point_in_facet(b, a.p(k))) emit_point(b, a.id, a.v[k], out);
  }
}

bool same_strict_side(const std::array<int, 3>& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

/// Computes the signs of the corners of f against another facet's plane, zero without a test for shared corners.
/// Returns false if all corners are strictly on one side, or if f touches the plane only in a shared corner or edge.
bool plane_signs(const FacetView& plane, const FacetView& f, std::array<int, 3>& signs) {
  int n_shared = 0, positive = 0, negative = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (plane.corner(f.v[i]) >= 0) {
      signs[i] = 0;
      ++n_shared;
      continue;
    }
    signs[i] = side(plane.p(0), plane.p(1), plane.p(2), f.p(i));
    positive += signs[i] > 0;
    negative += signs[i] < 0;
  }
  if (n_shared == 3) return true;
  return n_shared == 0 ? !same_strict_side(signs) : positive != 3 - n_shared && negative != 3 - n_shared;
}

/// Returns whether the point d is strictly between a and b on their line.
bool strictly_between(const Vec3& a, const Vec3& d, const Vec3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i] != b[i]) return (a[i] < d[i] && d[i] < b[i]) || (b[i] < d[i] && d[i] < a[i]);
  return false;
}

void add_coplanar_segment(const Complex& complex, const PolygonSoup::Segment& s, const FacetView& f, Ends& ends) {
  const Projection frame = projection_of(f);
  const Vec2 p = project(complex.points[s.a], frame), q = project(complex.points[s.b], frame);
  for (const VertexIndex v : {s.a, s.b})
    if (f.corner(v) >= 0 || plane_point_in_facet(f, complex.points[v])) ends.add(Symbol::point(v));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = project(f.p(i), frame), b = project(f.p((i + 1) % 3), frame);
    const int sa = to_int(orient2d(p, q, a)), sb = to_int(orient2d(p, q, b));
    const int sp = to_int(orient2d(a, b, p)), sq = to_int(orient2d(a, b, q));
    if (sa == 0 && strictly_between(complex.points[s.a], f.p(i), complex.points[s.b])) ends.add(Symbol::point(f.v[i]));
    if (sa * sb < 0 && sp * sq < 0) ends.add(Symbol::line_line(s.a, s.b, f.v[i], f.v[(i + 1) % 3]));
  }
}

}  // namespace

Symbol Symbol::line_line(VertexIndex p, VertexIndex q, VertexIndex r, VertexIndex s) {
  std::array<VertexIndex, 2> first{std::min(p, q), std::max(p, q)}, second{std::min(r, s), std::max(r, s)};
  if (second < first) std::swap(first, second);
  return {first[0], first[1], second[0], second[1]};
}

void Contacts::append(const Contacts& more) {
  facets.insert(facets.end(), more.facets.begin(), more.facets.end());
  segments.insert(segments.end(), more.segments.begin(), more.segments.end());
  overlaps.insert(overlaps.end(), more.overlaps.begin(), more.overlaps.end());
  n_pairs += more.n_pairs;
}

void facet_facet_contact(const Complex& complex, Index ia, Index ib, Contacts& out) {
  const FacetView a(complex, ia), b(complex, ib);
  if (proven_apart({&a.p(0), &a.p(1), &a.p(2)}, a.v, {&b.p(0), &b.p(1), &b.p(2)}, b.v)) return;
  std::array<int, 3> sb, sa;
  if (!plane_signs(a, b, sb)) return;
  if (sb == std::array<int, 3>{0, 0, 0}) {
    coplanar_contact(a, b, out);
    return;
  }
  if (!plane_signs(b, a, sa)) return;
  Ends ends;
  add_ends(a, b, sb, ends);
  add_ends(b, a, sa, ends);
  emit(a, ib, Line::plane(ib), ends, out);
  emit(b, ia, Line::plane(ia), ends, out);
}

void segment_facet_contact(const Complex& complex, Index segment, Index facet, Contacts& out) {
  const PolygonSoup::Segment& s = complex.segments[segment];
  const FacetView f(complex, facet);
  const auto sign_of = [&](VertexIndex v) {
    return f.corner(v) >= 0 ? 0 : side(f.p(0), f.p(1), f.p(2), complex.points[v]);
  };
  const int sa = sign_of(s.a), sb = sign_of(s.b);
  if (sa * sb > 0) return;
  Ends ends;
  if (sa * sb < 0) {
    if (line_meets_facet(f, complex.points[s.a], complex.points[s.b])) ends.add(Symbol::line_plane(s.a, s.b, facet));
  } else if (sa == 0 && sb == 0) {
    add_coplanar_segment(complex, s, f, ends);
  } else {
    const VertexIndex v = sa == 0 ? s.a : s.b;
    if (f.corner(v) >= 0 || plane_point_in_facet(f, complex.points[v])) ends.add(Symbol::point(v));
  }
  emit(f, no_index, Line::edge(s.a, s.b), ends, out);
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (ends[i] != Symbol::point(s.a) && ends[i] != Symbol::point(s.b)) out.segments.push_back({segment, ends[i]});
}

void point_segment_contact(const Complex& complex, VertexIndex v, Index segment, Contacts& out) {
  const PolygonSoup::Segment& s = complex.segments[segment];
  if (v == s.a || v == s.b) return;
  const Vec3 &a = complex.points[s.a], &b = complex.points[s.b], &p = complex.points[v];
  if (collinear(a, b, p) && strictly_between(a, p, b)) out.segments.push_back({segment, Symbol::point(v)});
}

void segment_segment_contact(const Complex& complex, Index ia, Index ib, Contacts& out) {
  const PolygonSoup::Segment &s = complex.segments[ia], &t = complex.segments[ib];
  for (const VertexIndex v : {t.a, t.b}) point_segment_contact(complex, v, ia, out);
  for (const VertexIndex v : {s.a, s.b}) point_segment_contact(complex, v, ib, out);
  if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return;
  const Vec3 &a = complex.points[s.a], &b = complex.points[s.b], &c = complex.points[t.a], &d = complex.points[t.b];
  if (side(a, b, c, d) != 0) return;
  const Projection frame = projection_of(a, b, c);
  if (frame.sign == Sign::zero) return;
  const Vec2 p = project(a, frame), q = project(b, frame), r = project(c, frame), u = project(d, frame);
  if (to_int(orient2d(p, q, r)) * to_int(orient2d(p, q, u)) >= 0 ||
      to_int(orient2d(r, u, p)) * to_int(orient2d(r, u, q)) >= 0)
    return;
  const Symbol crossing = Symbol::line_line(s.a, s.b, t.a, t.b);
  out.segments.push_back({ia, crossing});
  out.segments.push_back({ib, crossing});
}

void point_facet_contact(const Complex& complex, VertexIndex v, Index facet, Contacts& out) {
  const FacetView f(complex, facet);
  const Vec3& p = complex.points[v];
  if (f.corner(v) >= 0 || side(f.p(0), f.p(1), f.p(2), p) != 0 || !plane_point_in_facet(f, p)) return;
  Ends ends;
  ends.add(Symbol::point(v));
  emit(f, no_index, Line{}, ends, out);
}

}  // namespace geomesh::geomodel::arrangement

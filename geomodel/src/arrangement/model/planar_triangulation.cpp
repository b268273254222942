// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/planar_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

/// Returns the sign of twice the area of a triangle from the nearest doubles of its corners, or zero if their errors
/// (half an ulp unless exact) leave the sign open.
Sign filtered_orient2d(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, std::size_t i, std::size_t j) {
  constexpr double u = 0x1p-53;
  const auto error = [](const PlanarPoint& p, std::size_t k) { return p.exact ? u * std::fabs(p.rounded[k]) : 0.0; };
  const double acx = a.rounded[i] - c.rounded[i], bcx = b.rounded[i] - c.rounded[i];
  const double acy = a.rounded[j] - c.rounded[j], bcy = b.rounded[j] - c.rounded[j];
  const double eacx = error(a, i) + error(c, i) + u * std::fabs(acx),
               ebcx = error(b, i) + error(c, i) + u * std::fabs(bcx);
  const double eacy = error(a, j) + error(c, j) + u * std::fabs(acy),
               ebcy = error(b, j) + error(c, j) + u * std::fabs(bcy);
  const double left = acx * bcy, right = acy * bcx, det = left - right;
  const double bound = 1.0001 * (std::fabs(acx) * ebcy + std::fabs(bcy) * eacx + eacx * ebcy + std::fabs(acy) * ebcx +
                                 std::fabs(bcx) * eacy + eacy * ebcx + 2 * u * (std::fabs(left) + std::fabs(right))) +
                       1e-290;
  return det > bound ? Sign::positive : det < -bound ? Sign::negative : Sign::zero;
}

}  // namespace

ExactPoint PlanarTriangulation::exact(int p) const {
  return points_[p].exact ? *points_[p].exact : frame_.to_exact(points_[p].rounded);
}

Sign PlanarTriangulation::orient(int a, int b, int c) const {
  const PlanarPoint &pa = points_[a], &pb = points_[b], &pc = points_[c];
  if (!pa.exact && !pb.exact && !pc.exact)
    return orient2d({pa.rounded[i_], pa.rounded[j_]}, {pb.rounded[i_], pb.rounded[j_]},
                    {pc.rounded[i_], pc.rounded[j_]});
  const Sign fast = filtered_orient2d(pa, pb, pc, i_, j_);
  return fast != Sign::zero ? fast : exact_orient2d(exact(a), exact(b), exact(c), i_, j_);
}

int PlanarTriangulation::add_point(const PlanarPoint& p) {
  points_.push_back(p);
  face_of_.push_back(none);
  return static_cast<int>(points_.size()) - 1;
}

void PlanarTriangulation::start(int a, int b, int c) {
  GEOMESH_CHECK(orient(a, b, c) == Sign::positive);
  faces_.push_back({{a, b, c}});
  touch(0);
}

int PlanarTriangulation::index_of(int face, int v) const {
  const auto& corners = faces_[face].v;
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

int PlanarTriangulation::mirror(int face, int edge) const {
  const Face& g = faces_[faces_[face].neighbour[edge]];
  const int a = faces_[face].v[next(edge)], b = faces_[face].v[previous(edge)];
  for (int i = 0; i < 3; ++i)
    if (g.v[i] != a && g.v[i] != b) return i;
  return none;
}

/// Updates the references of vertices and neighbouring faces to a face that was rewritten.
void PlanarTriangulation::touch(int face) {
  for (int i = 0; i < 3; ++i) {
    face_of_[faces_[face].v[i]] = face;
    if (faces_[face].neighbour[i] != none) {
      const int back = mirror(face, i);
      faces_[faces_[face].neighbour[i]].neighbour[back] = face;
    }
  }
}

template <typename Visit>
void PlanarTriangulation::star(int a, Visit&& visit) const {
  const int first = face_of_[a];
  int f = first;
  do {
    const int k = index_of(f, a);
    if (visit(f, k)) return;
    f = faces_[f].neighbour[next(k)];
  } while (f != none && f != first);
  if (f == first) return;
  for (f = faces_[first].neighbour[previous(index_of(first, a))]; f != none;) {
    const int k = index_of(f, a);
    if (visit(f, k)) return;
    f = faces_[f].neighbour[previous(k)];
  }
}

std::pair<int, int> PlanarTriangulation::left_face(int a, int b) const {
  std::pair<int, int> found{none, none};
  star(a, [&](int f, int k) {
    if (faces_[f].v[next(k)] != b) return false;
    found = {f, previous(k)};
    return true;
  });
  return found;
}

PlanarTriangulation::Place PlanarTriangulation::locate(int p, int& face, int& index) const {
  int f = hint_;
  for (std::size_t steps = 0;; ++steps) {
    GEOMESH_CHECK(steps <= 1000 + 100 * faces_.size());
    // A walk that varies the first edge to test terminates in any triangulation (Devillers et al. 2002).
    turn_ = turn_ * 1103515245u + 12345u;
    int zeros = 0, zero_edge = none, move = none;
    for (int k = 0; k < 3 && move == none; ++k) {
      const int e = static_cast<int>((k + (turn_ >> 16)) % 3);
      const Sign s = orient(faces_[f].v[next(e)], faces_[f].v[previous(e)], p);
      if (s == Sign::negative) move = e;
      if (s == Sign::zero) {
        index = zeros++ == 0 ? e : 3 - e - zero_edge;
        zero_edge = e;
      }
    }
    if (move == none) {
      face = hint_ = f;
      return zeros == 0 ? Place::inside : zeros == 1 ? Place::on_edge : Place::on_vertex;
    }
    GEOMESH_CHECK(faces_[f].neighbour[move] != none);
    f = faces_[f].neighbour[move];
  }
}

void PlanarTriangulation::insert_point(int p) {
  if (face_of_[p] != none) return;
  int face = none, index = none;
  const Place place = locate(p, face, index);
  GEOMESH_CHECK(place != Place::on_vertex);  // the caller has merged points at equal places
  if (place == Place::inside)
    split_face(face, p);
  else
    split_edge(face, index, p);
  hint_ = face_of_[p];
  std::vector<std::pair<int, int>> edges;
  star(p, [&](int f, int k) {
    edges.emplace_back(faces_[f].v[next(k)], faces_[f].v[previous(k)]);
    return false;
  });
  legalize(edges);
}

void PlanarTriangulation::split_face(int f, int p) {
  const Face old = faces_[f];
  const auto [a, b, c] = old.v;
  const int g = static_cast<int>(faces_.size()), h = g + 1;
  faces_[f] = {{a, b, p}, {g, h, old.neighbour[2]}, {none, none, old.constraint[2]}};
  faces_.push_back({{b, c, p}, {h, f, old.neighbour[0]}, {none, none, old.constraint[0]}});
  faces_.push_back({{c, a, p}, {f, g, old.neighbour[1]}, {none, none, old.constraint[1]}});
  for (const int x : {f, g, h}) touch(x);
}

void PlanarTriangulation::split_edge(int f, int e, int p) {
  const Face old = faces_[f];
  const int o = old.v[e], a = old.v[next(e)], b = old.v[previous(e)], line = old.constraint[e];
  const int g = old.neighbour[e], f2 = static_cast<int>(faces_.size());
  const int g2 = g == none ? none : f2 + 1;
  const int ea = next(e), eb = previous(e);
  Face other;
  int m = none;
  if (g != none) {
    m = mirror(f, e);
    other = faces_[g];
  }
  faces_[f] = {{o, a, p}, {g, f2, old.neighbour[eb]}, {line, none, old.constraint[eb]}};
  faces_.push_back({{o, p, b}, {g2, old.neighbour[ea], f}, {line, old.constraint[ea], none}});
  if (g != none) {
    const int q = other.v[m], opposite_b = next(m), opposite_a = previous(m);
    faces_[g] = {{q, p, a}, {f, other.neighbour[opposite_b], g2}, {line, other.constraint[opposite_b], none}};
    faces_.push_back({{q, b, p}, {f2, g, other.neighbour[opposite_a]}, {line, none, other.constraint[opposite_a]}});
    touch(g);
    touch(g2);
  }
  touch(f);
  touch(f2);
}

void PlanarTriangulation::flip(int f, int e) {
  const Face old = faces_[f];
  const int g = old.neighbour[e], m = mirror(f, e);
  const Face other = faces_[g];
  const int p = old.v[e], a = old.v[next(e)], b = old.v[previous(e)], q = other.v[m];
  // Indices of the edges opposite b and a in the face g, whose counter-clockwise corners are q, b, a.
  const int opposite_b = next(m), opposite_a = previous(m);
  faces_[f] = {{p, a, q},
               {other.neighbour[opposite_b], g, old.neighbour[previous(e)]},
               {other.constraint[opposite_b], none, old.constraint[previous(e)]}};
  faces_[g] = {{p, q, b},
               {other.neighbour[opposite_a], old.neighbour[next(e)], f},
               {other.constraint[opposite_a], old.constraint[next(e)], none}};
  touch(f);
  touch(g);
}

bool PlanarTriangulation::is_convex(int f, int e) const {
  const int q = faces_[faces_[f].neighbour[e]].v[mirror(f, e)];
  const int p = faces_[f].v[e], a = faces_[f].v[next(e)], b = faces_[f].v[previous(e)];
  return orient(p, a, q) == Sign::positive && orient(p, q, b) == Sign::positive;
}

bool PlanarTriangulation::wants_flip(int f, int e) const {
  if (f == none || faces_[f].constraint[e] != none || faces_[f].neighbour[e] == none) return false;
  const Vec3 &p = points_[faces_[f].v[e]].rounded, &a = points_[faces_[f].v[next(e)]].rounded;
  const Vec3& b = points_[faces_[f].v[previous(e)]].rounded;
  const Vec3& q = points_[faces_[faces_[f].neighbour[e]].v[mirror(f, e)]].rounded;
  const Vec3 pa = a - p, pb = b - p, qa = a - q, qb = b - q;
  const double cos_p = dot(pa, pb), sin_p = length(cross(pa, pb)), cos_q = dot(qa, qb), sin_q = length(cross(qa, qb));
  // Opposite angles must clearly exceed pi in sum for a flip, so that each flip improves the faces and flipping ends.
  constexpr double margin = 1e-10;
  return sin_p * cos_q + cos_p * sin_q < -margin * length(pa) * length(pb) * length(qa) * length(qb) && is_convex(f, e);
}

void PlanarTriangulation::legalize(std::vector<std::pair<int, int>>& edges) {
  std::size_t budget = 64 * faces_.size() + 64;
  while (!edges.empty() && budget > 0) {
    const auto [u, w] = edges.back();
    edges.pop_back();
    const auto [f, e] = left_face(u, w);
    if (f == none || !wants_flip(f, e)) continue;
    --budget;
    const int g = faces_[f].neighbour[e];
    flip(f, e);
    edges.emplace_back(faces_[f].v[1], faces_[f].v[2]);
    edges.emplace_back(faces_[f].v[0], faces_[f].v[1]);
    edges.emplace_back(faces_[g].v[1], faces_[g].v[2]);
    edges.emplace_back(faces_[g].v[2], faces_[g].v[0]);
  }
}

/// Returns the first vertex or edge that the segment from vertex a towards b meets.
PlanarTriangulation::Stop PlanarTriangulation::first_stop(int a, int b) const {
  Stop stop;
  star(a, [&](int f, int k) {
    const int right = faces_[f].v[next(k)], left = faces_[f].v[previous(k)];
    if (right == b || left == b) {
      stop = {b, true, none, none};
      return true;
    }
    const Sign s_right = orient(a, b, right), s_left = orient(a, b, left);
    if (s_right == Sign::zero && s_left == Sign::positive) {
      stop = {right, true, none, none};
      return true;
    }
    if (s_left == Sign::zero && s_right == Sign::negative) {
      stop = {left, true, none, none};
      return true;
    }
    if (s_right == Sign::negative && s_left == Sign::positive) {
      stop = {none, false, f, k};
      return true;
    }
    return false;
  });
  GEOMESH_CHECK(stop.vertex != none || stop.face != none);
  return stop;
}

/// Inserts the segment ab up to the next vertex on it or the next constraint across it; returns the vertex reached.
int PlanarTriangulation::advance(int a, int b, int line) {
  const Stop stop = first_stop(a, b);
  if (stop.is_edge) {
    mark(a, stop.vertex, line);
    return stop.vertex;
  }
  std::vector<std::pair<int, int>> crossed;
  int f = stop.face, e = stop.edge;
  for (;;) {
    const int right = faces_[f].v[next(e)], left = faces_[f].v[previous(e)];
    if (faces_[f].constraint[e] != none) {
      const int x = add_point(crossing_(line, faces_[f].constraint[e]));
      split_edge(f, e, x);
      force_edge(a, x, crossed);
      mark(a, x, line);
      legalize(crossed);
      return x;
    }
    crossed.emplace_back(right, left);
    const int g = faces_[f].neighbour[e], m = mirror(f, e), apex = faces_[g].v[m];
    const Sign s = apex == b ? Sign::zero : orient(a, b, apex);
    if (s == Sign::zero) {
      force_edge(a, apex, crossed);
      mark(a, apex, line);
      legalize(crossed);
      return apex;
    }
    // The segment leaves face g through the edge between g's apex and g's corner on the other side of the segment.
    e = index_of(g, s == Sign::positive ? left : right);
    f = g;
  }
}

/// Makes ab an edge by Sloan's flips, which remove the unconstrained edges that cross it.
void PlanarTriangulation::force_edge(int a, int b, std::vector<std::pair<int, int>>& crossed) {
  std::deque<std::pair<int, int>> queue(crossed.begin(), crossed.end());
  std::vector<std::pair<int, int>> made;
  std::size_t budget = 1000 + 100 * (queue.size() + 1) * (queue.size() + 1);
  while (!queue.empty()) {
    GEOMESH_CHECK(budget-- > 0);
    const auto [u, w] = queue.front();
    queue.pop_front();
    const auto [f, e] = left_face(u, w);
    GEOMESH_CHECK(f != none);
    if (!is_convex(f, e)) {
      queue.emplace_back(u, w);
      continue;
    }
    flip(f, e);
    const int p = faces_[f].v[0], q = faces_[f].v[2];
    if ((p == a && q == b) || (p == b && q == a)) continue;
    if (p != a && p != b && q != a && q != b && orient(a, b, p) * orient(a, b, q) == Sign::negative)
      queue.emplace_back(p, q);
    else
      made.emplace_back(p, q);
  }
  GEOMESH_CHECK(left_face(a, b).first != none || left_face(b, a).first != none);
  crossed = std::move(made);
}

void PlanarTriangulation::mark(int a, int b, int line) {
  for (const auto& [u, w] : {std::pair{a, b}, std::pair{b, a}}) {
    const auto [f, e] = left_face(u, w);
    if (f != none && faces_[f].constraint[e] == none) faces_[f].constraint[e] = line;
  }
}

void PlanarTriangulation::insert_constraint(int a, int b, int line) {
  while (a != b) a = advance(a, b, line);
}

std::vector<int> PlanarTriangulation::chain(int a, int b) const {
  std::vector<int> result{a};
  while (a != b) {
    const Stop stop = first_stop(a, b);
    GEOMESH_CHECK(stop.is_edge);
    result.push_back(a = stop.vertex);
  }
  return result;
}

}  // namespace geomesh::geomodel::arrangement

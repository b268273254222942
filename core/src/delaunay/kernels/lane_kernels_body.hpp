// SPDX-License-Identifier: MIT
/// @file
/// Bodies of the lane kernels; each lane_kernels_*.cpp compiles them for one instruction set, with internal linkage.
/// This file calls no inline function with external linkage, because the linker might keep the version of that function
/// for the wrong processor.
///
/// Lanes are IEEE doubles without contraction on every instruction set, so all versions compute the same bits.
#pragma once

#include "delaunay/kernels/lane_kernels.hpp"
#include "predicates/filters.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"  // all functions on vectors are inlined: no vector is passed in a call

namespace geomesh {
namespace {

using Lanes __attribute__((vector_size(32), aligned(8), may_alias)) = double;
using Mask __attribute__((vector_size(32), aligned(8), may_alias)) = long long;
using Half __attribute__((vector_size(16), aligned(8), may_alias)) = double;
using Indices __attribute__((vector_size(16), aligned(4), may_alias)) = std::uint32_t;
static_assert(alignof(Lanes) == alignof(double) && alignof(Indices) == alignof(std::uint32_t),
              "arrays are aligned for their elements only");

#define GEOMESH_INLINE [[gnu::always_inline]] inline

/// Returns a number whose bit i is the sign bit of lane i.
GEOMESH_INLINE unsigned signs(Mask m) {
#if defined(__AVX__)
  return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Lanes>(m)));
#elif defined(__SSE2__)
  const Lanes v = reinterpret_cast<Lanes>(m);
  const Half low = __builtin_shufflevector(v, v, 0, 1), high = __builtin_shufflevector(v, v, 2, 3);
  return static_cast<unsigned>(__builtin_ia32_movmskpd(low) | __builtin_ia32_movmskpd(high) << 2);
#else
  unsigned r = 0;
  for (unsigned i = 0; i < 4; ++i) r |= (m[i] < 0 ? 1u : 0u) << i;
  return r;
#endif
}

GEOMESH_INLINE Lanes greater(Lanes u, Lanes v) { return u > v ? u : v; }

/// Returns the largest of the four lanes, in all lanes.
GEOMESH_INLINE Lanes greatest(Lanes v) {
  const Lanes pairs = greater(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
  return greater(pairs, __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1));
}

/// Returns an upper bound, within 7 percent, of the square root: half the exponent, with the mantissa as linear.
GEOMESH_INLINE Lanes root_bound(Lanes v) {
  using Words __attribute__((vector_size(32), aligned(8), may_alias)) = unsigned long long;
  return reinterpret_cast<Lanes>((reinterpret_cast<Words>(v) + 0x3FF0000000000000ull) >> 1);
}

/// Four points relative to p, one per lane. `w`: squared distances from p. `tag`: ids, and places on the Hilbert curve.
struct FourPoints {
  Lanes x, y, z, w;
  Mask tag;
};

GEOMESH_INLINE Lanes load(const PointRecord* points, VertexIndex v) {
  return *reinterpret_cast<const Lanes*>(points + v);
}

/// Returns a cell as eight words: four vertices, then four neighbours.
GEOMESH_INLINE const std::uint32_t* words(const TetMesh::Cell& cell) {
  return reinterpret_cast<const std::uint32_t*>(&cell);
}

GEOMESH_INLINE FourPoints four_points(const PointRecord* points, const VertexIndex* v, double px, double py,
                                      double pz) {
  const Lanes a = load(points, v[0]), b = load(points, v[1]), c = load(points, v[2]), d = load(points, v[3]);
  const Lanes ab_xz = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_yt = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_xz = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_yt = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  FourPoints r;
  r.x = __builtin_shufflevector(ab_xz, cd_xz, 0, 1, 4, 5) - px;
  r.y = __builtin_shufflevector(ab_yt, cd_yt, 0, 1, 4, 5) - py;
  r.z = __builtin_shufflevector(ab_xz, cd_xz, 2, 3, 6, 7) - pz;
  r.tag = reinterpret_cast<Mask>(__builtin_shufflevector(ab_yt, cd_yt, 2, 3, 6, 7));
  r.w = r.x * r.x + r.y * r.y + r.z * r.z;
  return r;
}

/// Returns a mask of the lanes whose points lie off the Hilbert curve's part that the insertion may change.
GEOMESH_INLINE unsigned foreign(Mask tag, Ownership owned) {
  const Mask place = tag >> 48 & 0xFFFF;
  return signs((place - owned.first) | ((owned.end - 1) - place));
}

/// face_r, face_s and face_t return in lane i vertex 0, 1 and 2 of face i, in the order of face_vertices.
GEOMESH_INLINE Lanes face_r(Lanes u) { return __builtin_shufflevector(u, u, 1, 0, 0, 0); }
GEOMESH_INLINE Lanes face_s(Lanes u) { return __builtin_shufflevector(u, u, 3, 2, 3, 1); }
GEOMESH_INLINE Lanes face_t(Lanes u) { return __builtin_shufflevector(u, u, 2, 3, 1, 2); }

/// Returns the error bound of a determinant of degree 3 or 5 whose points are no farther from p than the root of w. The
/// bound is 0 if they are within the exact reach, because the determinant is then exact.
GEOMESH_INLINE Lanes bound(Lanes w, Lanes degree, double exact_reach) {
  return w > exact_reach * exact_reach ? degree : Lanes{};
}

// Functions marked so are excluded from the thread sanitizer: they load whole point records, including the field
// `local`, which they do not use and which another thread may be writing.
#if defined(__SANITIZE_THREAD__)
#define GEOMESH_WHOLE_RECORDS __attribute__((no_sanitize("thread")))
#else
#define GEOMESH_WHOLE_RECORDS
#endif

GEOMESH_WHOLE_RECORDS
bool walk(const LaneQuery& query, CellIndex& at, std::size_t& steps) {
  const double px = query.p.x, py = query.p.y, pz = query.p.z, reach = query.exact_reach;
  CellIndex c = at;
  std::size_t n = 0;
  bool inside = false;
  for (;;) {
    const std::uint32_t* cell = words(query.cells[c]);
    const FourPoints q = four_points(query.points, cell, px, py, pz);
    if (foreign(q.tag, query.owned)) break;
    for (unsigned i = 4; i < 8; ++i) __builtin_prefetch(&query.cells[cell[i] >> 2]);
    ++n;
    const Lanes rx = face_r(q.x), ry = face_r(q.y), rz = face_r(q.z), sx = face_s(q.x), sy = face_s(q.y),
                sz = face_s(q.z);
    const Lanes tx = face_t(q.x), ty = face_t(q.y), tz = face_t(q.z);
    const Lanes det = rz * (sx * ty - tx * sy) + sz * (tx * ry - rx * ty) + tz * (rx * sy - sx * ry);
    const Lanes w = greater(greater(face_r(q.w), face_s(q.w)), face_t(q.w));
    const Lanes error = bound(w, filter::orient3d_factor * w * root_bound(w), reach);
    // The orientation determinant is positive in the lanes of those faces that separate p from the cell.
    const unsigned beyond = signs(det > error);
    if (beyond == 0) {
      inside = signs(det < -error) == 0xFu;
      break;
    }
    // The walk leaves the cell through the face with the largest determinant, if its sign is certain. This takes 6.5
    // steps on uniform points, compared with 6.9 steps through the first face with p beyond it.
    const unsigned farthest = signs(det >= greatest(det)) & beyond;
    c = cell[4 + __builtin_ctz(farthest != 0 ? farthest : beyond)] >> 2;
  }
  at = c;
  steps += n;
  return inside;
}

struct FilteredLanes {
  Lanes det, error;
};

/// Returns in lane i the in-sphere determinant of p and the neighbour across face i of cell q. The apex of that
/// neighbour is lane i of e. Positive: p is inside.
GEOMESH_INLINE FilteredLanes in_sphere(const FourPoints& q, const FourPoints& e, double reach) {
  const Lanes rx = face_r(q.x), ry = face_r(q.y), rz = face_r(q.z), sx = face_s(q.x), sy = face_s(q.y),
              sz = face_s(q.z);
  const Lanes tx = face_t(q.x), ty = face_t(q.y), tz = face_t(q.z);
  const Lanes rw = face_r(q.w), sw = face_s(q.w), tw = face_t(q.w);
  const Lanes rs = rx * sy - sx * ry, st = sx * ty - tx * sy, te = tx * e.y - e.x * ty;
  const Lanes er = e.x * ry - rx * e.y, rt = rx * ty - tx * ry, se = sx * e.y - e.x * sy;
  const Lanes rst = rz * st - sz * rt + tz * rs, ste = sz * te - tz * se + e.z * st;
  const Lanes ter = tz * er + e.z * rt + rz * te, ers = e.z * rs + rz * se + sz * er;
  const Lanes det = (e.w * rst - tw * ers) + (sw * ter - rw * ste);
  const Lanes w = greater(greater(rw, sw), greater(tw, e.w));
  const Lanes error = bound(w, filter::in_sphere_factor * (w * w) * root_bound(w), reach);
  return {det, error};
}

/// Appends the cell's faces i for which bit i of `closed` is set; returns the new number of faces. Needs room for 4.
GEOMESH_INLINE std::size_t append_faces(const std::uint32_t* cell, unsigned closed, CavityFace<3>* faces,
                                        std::size_t n_faces) {
  const Indices v = *reinterpret_cast<const Indices*>(cell), o = *reinterpret_cast<const Indices*>(cell + 4);
  *reinterpret_cast<Indices*>(faces + n_faces) = __builtin_shufflevector(v, o, 1, 3, 2, 4);
  n_faces += closed & 1u;
  *reinterpret_cast<Indices*>(faces + n_faces) = __builtin_shufflevector(v, o, 0, 2, 3, 5);
  n_faces += closed >> 1 & 1u;
  *reinterpret_cast<Indices*>(faces + n_faces) = __builtin_shufflevector(v, o, 0, 3, 1, 6);
  n_faces += closed >> 2 & 1u;
  *reinterpret_cast<Indices*>(faces + n_faces) = __builtin_shufflevector(v, o, 0, 1, 2, 7);
  n_faces += closed >> 3 & 1u;
  return n_faces;
}

/// Number of cells whose neighbours are prefetched ahead. Two to four are equally fast; none is a tenth slower.
constexpr std::size_t look_ahead = 4;

GEOMESH_WHOLE_RECORDS
bool grow(const LaneQuery& query, std::uint8_t* flags, std::uint8_t mark, CavityLists& lists, CavityHost& host) {
  const TetMesh::Cell* cells = query.cells;
  const PointRecord* points = query.points;
  const double px = query.p.x, py = query.p.y, pz = query.p.z, reach = query.exact_reach;
  const Ownership part = query.owned;
  CellIndex* cavity = lists.cells;
  CavityFace<3>* faces = lists.faces;
  std::size_t n_cells = lists.n_cells, n_faces = lists.n_faces, k = lists.n_done;
  std::uint8_t unused = 0;
  bool owned = true;
  constexpr double infinity = __builtin_inf();
  Lanes nearest = {infinity, infinity, infinity, infinity};
  for (; k < n_cells; ++k) {
    if ((n_cells > n_faces ? n_cells : n_faces) + 4 > lists.capacity) [[unlikely]] {
      lists.n_cells = n_cells, lists.n_faces = n_faces;
      host.enlarge(lists);
      cavity = lists.cells, faces = lists.faces;
    }
    const TetMesh::Cell& cell = cells[cavity[k]];
    CellIndex next[4];  // neighbours of a cell, all different because no two cells share two faces
    VertexIndex apex[4];
    std::uint8_t flag[4];
    unsigned open = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t outer = words(cell)[4 + i];
      next[i] = outer >> 2;
      apex[i] = words(cells[next[i]])[outer & 3u];
      flag[i] = flags[next[i]];
      open |= (flag[i] & mark ? 0u : 1u) << i;
    }
    const FourPoints q = four_points(points, words(cell), px, py, pz);
    const FourPoints e = four_points(points, apex, px, py, pz);
    nearest = q.w < nearest ? q.w : nearest;
    const auto [det, error] = in_sphere(q, e, reach);
    unsigned conflict = signs(det > error) & open;
    const unsigned undecided = open & ~(conflict | signs(det < -error));
    if (undecided != 0) [[unlikely]] {
      alignas(32) double value[4];
      *reinterpret_cast<Lanes*>(value) = det;
      conflict |= host.decide(cell, undecided, value);
    }
    const unsigned other = conflict & foreign(e.tag, part);
    if (other != 0) [[unlikely]] {
      for (unsigned i = 0; i < 4; ++i) owned = owned && (!(other >> i & 1u) || points[apex[i]].id == infinite_vertex);
      if (!owned) break;
    }
    n_faces = append_faces(words(cell), open & ~conflict, faces, n_faces);
#pragma GCC unroll 4
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned taken = conflict >> i & 1u;
      // Flags of cells that are not in conflict are not rewritten, even unchanged: another thread may be reading them.
      *(taken ? flags + next[i] : &unused) = static_cast<std::uint8_t>(flag[i] | mark);
      cavity[n_cells] = next[i];
      n_cells += taken;
    }
    const std::uint32_t* later = words(cells[cavity[k + look_ahead < n_cells ? k + look_ahead : n_cells - 1]]);
    for (unsigned i = 4; i < 8; ++i) __builtin_prefetch(&cells[later[i] >> 2]);
  }
  lists.n_cells = n_cells, lists.n_faces = n_faces, lists.n_done = k;
  const double a = nearest[0] < nearest[1] ? nearest[0] : nearest[1],
               b = nearest[2] < nearest[3] ? nearest[2] : nearest[3];
  lists.nearest = a < b ? a : b;
  return owned;
}

}  // namespace
}  // namespace geomesh

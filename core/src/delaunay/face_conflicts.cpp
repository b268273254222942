// SPDX-License-Identifier: MIT
#include "delaunay/face_conflicts.hpp"

#include "predicates/filters.hpp"

// One source, two machines: with AVX2 four lanes are one register, else pairs. Both are IEEE doubles without contraction, so the
// results are the same bits.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GEOMESH_LANES_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define GEOMESH_LANES_CLONES
#endif

#pragma GCC diagnostic ignored "-Wpsabi"  // the lambdas below are inlined: no vector crosses a call

namespace geomesh {
namespace {

using Lanes = double __attribute__((vector_size(32), may_alias));
using Mask = long long __attribute__((vector_size(32), may_alias));

}  // namespace

GEOMESH_LANES_CLONES
void face_conflicts(const PointRecord* points, const VertexIndex* cell, const VertexIndex* apex, const Vec3& p,
                    FaceConflicts& result) {
  const PointRecord &a = points[cell[0]], &b = points[cell[1]], &c = points[cell[2]], &d = points[cell[3]];
  const PointRecord &e0 = points[apex[0]], &e1 = points[apex[1]], &e2 = points[apex[2]], &e3 = points[apex[3]];
  const Lanes x = Lanes{a.x, b.x, c.x, d.x} - p.x, y = Lanes{a.y, b.y, c.y, d.y} - p.y, z = Lanes{a.z, b.z, c.z, d.z} - p.z;
  const Lanes ex = Lanes{e0.x, e1.x, e2.x, e3.x} - p.x, ey = Lanes{e0.y, e1.y, e2.y, e3.y} - p.y,
              ez = Lanes{e0.z, e1.z, e2.z, e3.z} - p.z;
  const Lanes w = x * x + y * y + z * z, ew = ex * ex + ey * ey + ez * ez;
  // Lane i holds face i: rows r, s, t are its vertices in the order of face_vertices.
  const Lanes rx = __builtin_shufflevector(x, x, 1, 0, 0, 0), ry = __builtin_shufflevector(y, y, 1, 0, 0, 0),
              rz = __builtin_shufflevector(z, z, 1, 0, 0, 0);
  const Lanes sx = __builtin_shufflevector(x, x, 3, 2, 3, 1), sy = __builtin_shufflevector(y, y, 3, 2, 3, 1),
              sz = __builtin_shufflevector(z, z, 3, 2, 3, 1);
  const Lanes tx = __builtin_shufflevector(x, x, 2, 3, 1, 2), ty = __builtin_shufflevector(y, y, 2, 3, 1, 2),
              tz = __builtin_shufflevector(z, z, 2, 3, 1, 2);
  const Lanes rw = __builtin_shufflevector(w, w, 1, 0, 0, 0), sw = __builtin_shufflevector(w, w, 3, 2, 3, 1),
              tw = __builtin_shufflevector(w, w, 2, 3, 1, 2);
  const Lanes rs = rx * sy - sx * ry, st = sx * ty - tx * sy, te = tx * ey - ex * ty;
  const Lanes er = ex * ry - rx * ey, rt = rx * ty - tx * ry, se = sx * ey - ex * sy;
  const Lanes rst = rz * st - sz * rt + tz * rs, ste = sz * te - tz * se + ez * st;
  const Lanes ter = tz * er + ez * rt + rz * te, ers = ez * rs + rz * se + sz * er;
  // The neighbour (face seen from outside, apex) has the opposite orientation of (r, s, t, apex).
  const Lanes det = (ew * rst - tw * ers) + (sw * ter - rw * ste);
  const auto size = [](Lanes u) { return reinterpret_cast<Lanes>(reinterpret_cast<Mask>(u) & 0x7FFFFFFFFFFFFFFFll); };
  const auto greater = [](Lanes u, Lanes v) { return u > v ? u : v; };
  const auto reach = [&](Lanes r, Lanes s, Lanes t, Lanes e) {
    return greater(greater(size(r), size(s)), greater(size(t), size(e)));
  };
  const Lanes mx = reach(rx, sx, tx, ex), my = reach(ry, sy, ty, ey), mz = reach(rz, sz, tz, ez);
  const Lanes error = filter::in_sphere_factor * (mx * my) * mz * (mx * mx + my * my + mz * mz);
  *reinterpret_cast<Lanes*>(result.value) = det;
  *reinterpret_cast<Lanes*>(result.error) = error;
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "geomesh/core/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "predicates/expansion.hpp"

namespace geomesh {
namespace {

using exact::difference;
using exact::Expansion;

constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2;  // 2^-53
// Shewchuk 1997, section 4: error bounds of the straightforward evaluations.
constexpr double orient2d_bound = (3 + 16 * epsilon) * epsilon;
constexpr double orient3d_bound = (7 + 56 * epsilon) * epsilon;
constexpr double in_circle_bound = (10 + 96 * epsilon) * epsilon;
constexpr double in_sphere_bound = (16 + 224 * epsilon) * epsilon;

constexpr Sign sign_of(double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

template <int N, int M>
auto minor2(const Expansion<N>& ax, const Expansion<N>& ay, const Expansion<M>& bx, const Expansion<M>& by) {
  return ax * by - bx * ay;
}

/// Differences of three coordinates, two components each.
struct ExactVector {
  Expansion<2> x, y, z;
  ExactVector(const Vec3& p, const Vec3& origin)
      : x(difference(p.x, origin.x)), y(difference(p.y, origin.y)), z(difference(p.z, origin.z)) {}
};

Sign orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  return minor2(difference(b.x, a.x), difference(b.y, a.y), difference(c.x, a.x), difference(c.y, a.y)).sign();
}

auto determinant3(const ExactVector& u, const ExactVector& v, const ExactVector& w) {
  return minor2(u.x, u.y, v.x, v.y) * w.z + minor2(v.x, v.y, w.x, w.y) * u.z + minor2(w.x, w.y, u.x, u.y) * v.z;
}

Sign orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return determinant3(ExactVector(b, a), ExactVector(c, a), ExactVector(d, a)).sign();
}

auto squared_length(const ExactVector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

Sign in_circle_exact(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto ax = difference(a.x, d.x), ay = difference(a.y, d.y);
  const auto bx = difference(b.x, d.x), by = difference(b.y, d.y);
  const auto cx = difference(c.x, d.x), cy = difference(c.y, d.y);
  return (minor2(bx, by, cx, cy) * (ax * ax + ay * ay) + minor2(cx, cy, ax, ay) * (bx * bx + by * by) +
          minor2(ax, ay, bx, by) * (cx * cx + cy * cy))
      .sign();
}

Sign in_sphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const ExactVector u(a, e), v(b, e), w(c, e), t(d, e);
  const auto first = determinant3(v, w, t) * squared_length(u) - determinant3(u, v, w) * squared_length(t);
  const auto second = determinant3(t, u, v) * squared_length(w) - determinant3(w, t, u) * squared_length(v);
  return (first + second).sign();
}

/// Perturbed sign of a lifted determinant that is zero: the points' heights get infinitely small increments, the greatest point the
/// greatest. `cofactor(i)` is the sign with which the height of point i enters the determinant; the first that is not zero decides.
template <std::size_t N, class Cofactor>
Sign perturbed_sign(const std::array<const Vec3*, N>& points, Cofactor&& cofactor) {
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return compare_lexicographic(*points[i], *points[j]) > 0; });
  for (const std::size_t i : order) {
    const Sign s = cofactor(i);
    if (s != Sign::zero) return s;
  }
  return Sign::zero;
}

}  // namespace

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (c.x - a.x) * (b.y - a.y);
  const double det = left - right;
  const double bound = orient2d_bound * (std::abs(left) + std::abs(right));
  if (det > bound || -det > bound) return sign_of(det);
  return orient2d_exact(a, b, c);
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  const double uxvy = ux * vy, vxuy = vx * uy;
  const double vxwy = vx * wy, wxvy = wx * vy;
  const double wxuy = wx * uy, uxwy = ux * wy;
  const double det = (uxvy - vxuy) * wz + (vxwy - wxvy) * uz + (wxuy - uxwy) * vz;
  const double permanent = (std::abs(uxvy) + std::abs(vxuy)) * std::abs(wz) + (std::abs(vxwy) + std::abs(wxvy)) * std::abs(uz) +
                           (std::abs(wxuy) + std::abs(uxwy)) * std::abs(vz);
  const double bound = orient3d_bound * permanent;
  if (det > bound || -det > bound) return sign_of(det);
  return orient3d_exact(a, b, c, d);
}

Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double bxcy = bx * cy, cxby = cx * by, cxay = cx * ay, axcy = ax * cy, axby = ax * by, bxay = bx * ay;
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double det = a2 * (bxcy - cxby) + b2 * (cxay - axcy) + c2 * (axby - bxay);
  const double permanent = (std::abs(bxcy) + std::abs(cxby)) * a2 + (std::abs(cxay) + std::abs(axcy)) * b2 +
                           (std::abs(axby) + std::abs(bxay)) * c2;
  const double bound = in_circle_bound * permanent;
  if (det > bound || -det > bound) return sign_of(det);
  return in_circle_exact(a, b, c, d);
}

Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const double ax = a.x - e.x, ay = a.y - e.y, az = a.z - e.z;
  const double bx = b.x - e.x, by = b.y - e.y, bz = b.z - e.z;
  const double cx = c.x - e.x, cy = c.y - e.y, cz = c.z - e.z;
  const double dx = d.x - e.x, dy = d.y - e.y, dz = d.z - e.z;
  const double axby = ax * by, bxay = bx * ay, bxcy = bx * cy, cxby = cx * by, cxdy = cx * dy, dxcy = dx * cy;
  const double dxay = dx * ay, axdy = ax * dy, axcy = ax * cy, cxay = cx * ay, bxdy = bx * dy, dxby = dx * by;
  const double ab = axby - bxay, bc = bxcy - cxby, cd = cxdy - dxcy, da = dxay - axdy, ac = axcy - cxay, bd = bxdy - dxby;
  const double abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
  const double cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
  const double a2 = ax * ax + ay * ay + az * az, b2 = bx * bx + by * by + bz * bz;
  const double c2 = cx * cx + cy * cy + cz * cz, d2 = dx * dx + dy * dy + dz * dz;
  const double det = (a2 * bcd - b2 * cda) + (c2 * dab - d2 * abc);
  // |ab| etc. as sums of absolute products (Shewchuk's permanent).
  const double pab = std::abs(axby) + std::abs(bxay), pbc = std::abs(bxcy) + std::abs(cxby), pcd = std::abs(cxdy) + std::abs(dxcy);
  const double pda = std::abs(dxay) + std::abs(axdy), pac = std::abs(axcy) + std::abs(cxay), pbd = std::abs(bxdy) + std::abs(dxby);
  const double za = std::abs(az), zb = std::abs(bz), zc = std::abs(cz), zd = std::abs(dz);
  const double permanent = (pcd * zb + pbd * zc + pbc * zd) * a2 + (pda * zc + pac * zd + pcd * za) * b2 +
                           (pab * zd + pbd * za + pda * zb) * c2 + (pbc * za + pac * zb + pab * zc) * d2;
  const double bound = in_sphere_bound * permanent;
  if (det > bound || -det > bound) return sign_of(det);
  return in_sphere_exact(a, b, c, d, e);
}

Sign in_sphere_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Sign s = in_sphere(a, b, c, d, e);
  if (s != Sign::zero) return s;
  // e is inside where it lies below the plane of the lifted a, b, c, d: raising e moves it out, raising another lifts the plane by its
  // barycentric coordinate at e, whose sign is the orientation with that point replaced by e.
  return perturbed_sign<5>({&a, &b, &c, &d, &e}, [&](std::size_t i) {
    switch (i) {
      case 0: return orient3d(e, b, c, d);
      case 1: return orient3d(a, e, c, d);
      case 2: return orient3d(a, b, e, d);
      case 3: return orient3d(a, b, c, e);
      default: return Sign::negative;
    }
  });
}

Sign in_circle_perturbed(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Sign s = in_circle(a, b, c, d);
  if (s != Sign::zero) return s;
  const Vec3 pa{a.x, a.y, 0}, pb{b.x, b.y, 0}, pc{c.x, c.y, 0}, pd{d.x, d.y, 0};
  return perturbed_sign<4>({&pa, &pb, &pc, &pd}, [&](std::size_t i) {
    switch (i) {
      case 0: return orient2d(d, b, c);
      case 1: return orient2d(a, d, c);
      case 2: return orient2d(a, b, d);
      default: return Sign::negative;
    }
  });
}

namespace {

/// Projection along axis k: (y, z), (z, x), (x, y).
Vec2 drop(const Vec3& p, int k) { return k == 0 ? Vec2{p.y, p.z} : k == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y}; }

/// Unperturbed in-circle of coplanar points: an auxiliary point off the plane makes it an in-sphere test; the sphere's section with the
/// plane is the circle, whatever the point.
Sign in_circle_coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int k, Sign turn) {
  Vec3 above = a;
  const double reach = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(b.z - a.z), std::abs(c.x - a.x),
                                 std::abs(c.y - a.y), std::abs(c.z - a.z)});
  above[static_cast<std::size_t>(k)] += reach;
  if (above[static_cast<std::size_t>(k)] == a[static_cast<std::size_t>(k)])
    above[static_cast<std::size_t>(k)] = std::nextafter(a[static_cast<std::size_t>(k)], std::numeric_limits<double>::infinity());
  return turn == Sign::positive ? in_sphere(a, b, c, above, d) : in_sphere(b, a, c, above, d);
}

}  // namespace

Sign in_circle_coplanar_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  int k = 2;
  Sign turn = Sign::zero;
  for (; k >= 0; --k) {
    turn = orient2d(drop(a, k), drop(b, k), drop(c, k));
    if (turn != Sign::zero) break;
  }
  GEOMESH_CHECK(k >= 0);  // a, b, c not collinear
  const Sign s = in_circle_coplanar(a, b, c, d, k, turn);
  if (s != Sign::zero) return s;
  const auto turned = [&](const Vec3& p, const Vec3& q, const Vec3& r) { return turn * orient2d(drop(p, k), drop(q, k), drop(r, k)); };
  return perturbed_sign<4>({&a, &b, &c, &d}, [&](std::size_t i) {
    switch (i) {
      case 0: return turned(d, b, c);
      case 1: return turned(a, d, c);
      case 2: return turned(a, b, d);
      default: return Sign::negative;
    }
  });
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int k = 0; k < 3; ++k)
    if (orient2d(drop(a, k), drop(b, k), drop(c, k)) != Sign::zero) return false;
  return true;
}

int compare_lexicographic(const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] < b[i]) return -1;
    if (a[i] > b[i]) return 1;
  }
  return 0;
}

bool exponents_are_safe(std::span<const Vec3> points) {
  // In-sphere multiplies five coordinate differences; errors of the products reach down to 2^-(5*53) of them. With magnitudes in
  // [2^-142, 2^195] the largest product stays below 2^1023 and the smallest error term above 2^-1074.
  const double smallest = std::ldexp(1.0, -142), largest = std::ldexp(1.0, 195);
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      const double m = std::abs(p[i]);
      if (!(m == 0 || (m >= smallest && m <= largest))) return false;
    }
  return true;
}

}  // namespace geomesh

// SPDX-License-Identifier: MIT
#include "quality/measure/dihedral_measure.hpp"

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

/// Vectors from the apex p to the corners of the base (a, b, c), and face normals with their lengths: na, nb and nc
/// point outward on the faces at the apex, np points inward on the base.
struct Frame {
  Vec3 a, b, c, na, nb, nc, np;
  double la, lb, lc, lp, det;
  Frame(const std::array<Vec3, 3>& face, const Vec3& p)
      : a(face[0] - p),
        b(face[1] - p),
        c(face[2] - p),
        na(cross(b, c)),
        nb(cross(c, a)),
        nc(cross(a, b)),
        np(cross(face[1] - face[0], face[2] - face[0])),
        la(length(na)),
        lb(length(nb)),
        lc(length(nc)),
        lp(length(np)),
        det(-dot(a, na)) {}
};

double weighted(double sine, double cosine) { return cosine < 0 ? DihedralMeasure::obtuse_weight * sine : sine; }

/// Returns the weighted sines of the dihedral angles at the edges pa, pb, pc, ab, bc, ca.
std::array<double, 6> weighted_sines(const Frame& f, const std::array<Vec3, 3>& face) {
  const double d = f.det;
  return {weighted(d * length(f.a) / (f.lb * f.lc), -dot(f.nb, f.nc)),
          weighted(d * length(f.b) / (f.la * f.lc), -dot(f.na, f.nc)),
          weighted(d * length(f.c) / (f.la * f.lb), -dot(f.na, f.nb)),
          weighted(d * length(face[1] - face[0]) / (f.lc * f.lp), dot(f.nc, f.np)),
          weighted(d * length(face[2] - face[1]) / (f.la * f.lp), dot(f.na, f.np)),
          weighted(d * length(face[0] - face[2]) / (f.lb * f.lp), dot(f.nb, f.np))};
}

/// Returns the gradient, by the apex, of the weighted sine of the dihedral angle at edge k; `value` is this sine.
Vec3 gradient_of_sine(const Frame& f, unsigned k, double value) {
  const Vec3 area_a = (1 / (f.la * f.la)) * cross(f.b - f.c, f.na);
  const Vec3 area_b = (1 / (f.lb * f.lb)) * cross(f.c - f.a, f.nb);
  const Vec3 area_c = (1 / (f.lc * f.lc)) * cross(f.a - f.b, f.nc);
  Vec3 g = (1 / f.det) * f.np;
  switch (k) {
    case 0:
      g = g - (1 / dot(f.a, f.a)) * f.a - area_b - area_c;
      break;
    case 1:
      g = g - (1 / dot(f.b, f.b)) * f.b - area_a - area_c;
      break;
    case 2:
      g = g - (1 / dot(f.c, f.c)) * f.c - area_a - area_b;
      break;
    case 3:
      g = g - area_c;
      break;
    case 4:
      g = g - area_a;
      break;
    default:
      g = g - area_b;
      break;
  }
  return value * g;
}

}  // namespace

void DihedralMeasure::append_gradients(const std::array<Vec3, 3>& face, const Vec3& p, double limit,
                                       std::vector<Vec3>& out) {
  const Frame frame(face, p);
  if (!(frame.det > 0)) return;
  const std::array<double, 6> sines = weighted_sines(frame, face);
  for (unsigned k = 0; k < 6; ++k)
    if (sines[k] <= limit) out.push_back(gradient_of_sine(frame, k, sines[k]));
}

}  // namespace geomesh::remesh

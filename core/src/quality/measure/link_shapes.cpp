// SPDX-License-Identifier: MIT
#include "quality/measure/link_shapes.hpp"

namespace geomesh::remesh {

void LinkShapes::set(std::size_t face, const Vec3& a, const Vec3& b, const Vec3& c, double share) {
  FourFaces& four = fours_[face / 4];
  const std::size_t lane = face % 4;
  const Vec3* const corners[] = {&a, &b, &c};
  for (unsigned k = 0; k < 3; ++k) {
    four.corner[k][0][lane] = corners[k]->x;
    four.corner[k][1][lane] = corners[k]->y;
    four.corner[k][2][lane] = corners[k]->z;
  }
  four.share[lane] = share;
}

void LinkShapes::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (n_ / 4 >= fours_.size()) fours_.resize(fours_.size() + 8);
  set(n_++, a, b, c, 1);
}

void LinkShapes::prepare() {
  for (std::size_t k = n_; k < 4 * n_fours(); ++k) set(k, corner(n_ - 1, 0), corner(n_ - 1, 1), corner(n_ - 1, 2), 0);
  kernels_->prepare(fours_.data(), n_fours());
}

}  // namespace geomesh::remesh

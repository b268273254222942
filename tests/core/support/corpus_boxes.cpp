// SPDX-License-Identifier: MIT
#include "corpus_boxes.hpp"

#include <array>
#include <cmath>
#include <random>

namespace geomesh::test {

namespace {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  PiecewiseLinearComplex run() {
    for (unsigned& n : n_) n = 1 + integer(4);
    warp_ = integer(3) == 0 ? 0 : 0.18 * real();
    for (unsigned i = 0; i <= n_[0]; ++i)
      for (unsigned j = 0; j <= n_[1]; ++j)
        for (unsigned k = 0; k <= n_[2]; ++k) plc_.points.push_back(Vec3{i + warp(), j + warp(), k + warp()});
    for (unsigned axis = 0; axis < 3; ++axis) add_faces(axis);
    if (integer(2)) hang_triangles();
    transform();
    return plc_;
  }

 private:
  unsigned integer(unsigned n) { return static_cast<unsigned>(random_() % n); }
  double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double warp() { return warp_ * (2 * real() - 1); }
  VertexIndex row(const std::array<unsigned, 3>& i) const {
    return static_cast<VertexIndex>((i[0] * (n_[1] + 1) + i[1]) * (n_[2] + 1) + i[2]);
  }

  /// The faces across an axis; those on the outside always.
  void add_faces(unsigned axis) {
    const unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<unsigned, 3> i{};
    for (i[axis] = 0; i[axis] <= n_[axis]; ++i[axis])
      for (i[u] = 0; i[u] < n_[u]; ++i[u])
        for (i[v] = 0; i[v] < n_[v]; ++i[v]) {
          const bool outer = i[axis] == 0 || i[axis] == n_[axis];
          if (!outer && integer(4) == 0) continue;
          auto b = i, c = i, d = i;
          ++b[u];
          ++c[u], ++c[v];
          ++d[v];
          const VertexIndex va = row(i), vb = row(b), vc = row(c), vd = row(d);
          if (integer(2)) {
            plc_.add_triangle({va, vb, vc});
            if (outer || integer(5)) plc_.add_triangle({va, vc, vd});
          } else {
            plc_.add_triangle({va, vb, vd});
            if (outer || integer(5)) plc_.add_triangle({vb, vc, vd});
          }
        }
  }
  /// Small triangles about the middles of boxes, inside whatever warp there is.
  void hang_triangles() {
    for (unsigned i = 0; i < n_[0]; ++i) {
      const Vec3 centre{i + 0.5, 0.5, 0.5};
      const VertexIndex first = static_cast<VertexIndex>(plc_.points.size());
      for (unsigned k = 0; k < 3; ++k)
        plc_.points.push_back(centre + 0.12 * Vec3{2 * real() - 1, 2 * real() - 1, 2 * real() - 1});
      plc_.add_triangle({first, first + 1, first + 2});
    }
  }
  void transform() {
    const double stretch = integer(3) == 0 ? std::pow(10, -3 * real()) : 1;
    const double angle = integer(2) ? 6.28 * real() : 0, c = std::cos(angle), s = std::sin(angle);
    const Vec3 shift = integer(3) == 0 ? Vec3{5e5 * real(), 7e6 * real(), -1e3 * real()} : Vec3{};
    for (Vec3& p : plc_.points) p = Vec3{c * p.x - s * p.y, s * p.x + c * p.y, stretch * p.z} + shift;
  }

  std::mt19937_64 random_;
  std::array<unsigned, 3> n_{};
  double warp_ = 0;
  PiecewiseLinearComplex plc_;
};

}  // namespace

PiecewiseLinearComplex random_boxes(std::uint64_t seed) { return Generator(seed).run(); }

}  // namespace geomesh::test
